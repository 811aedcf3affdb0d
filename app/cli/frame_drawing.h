// SPDX-License-Identifier: MIT
#pragma once

#include "render_arguments.h"
#include "shown_frame.h"

#include "document/shutter.h"
#include "io/picture/png_export.h"
#include "io/picture/space_export.h"

#include <QByteArray>
#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <stop_token>

namespace cli {

// Draws the frames of an entry, in any order: each is a function of the entry, its number and the options.
// What makes no sense throws UsageError.
class FrameDrawing {
public:
    // `name` stands for the pictures in messages.
    FrameDrawing(const document::Fractal& entry, const RenderArguments& options, const QString& name);

    // A PNG picture that carries the hash of its request; `path` appears whole or not at all.
    io::ExportOutcome writePng(int frame, const QString& path, const QByteArray& hash,
                               const io::Progress& progress, const std::stop_token& stop);
    // The same pixels with 8 bits a channel; null when stopped.
    io::Picture draw(int frame, const io::Progress& progress, const std::stop_token& stop);

    bool isTransparent(int frame) const; // some of it may be

private:
    enum class Exposing { Fixed, Smooth, Each };

    bool isPlane() const { return document::plane(m_entry) != nullptr; }
    io::PngExport planeAt(const animation::Moment& moment) const;
    io::SpaceExport spaceAt(const animation::Moment& moment) const;
    io::PngExport planeFrame(int frame, const std::stop_token& stop);
    io::SpaceExport spaceFrame(int frame, const std::stop_token& stop);
    template <class Request, class RequestAt>
    std::vector<Request> momentsOf(int frame, RequestAt requestAt) const;
    // nullopt: the frame has its own, or the work is stopped.
    std::optional<attractor::Exposure> exposureAt(int frame, const std::stop_token& stop);
    std::optional<attractor::Exposure> pilot(std::size_t index, const std::stop_token& stop);

    const RenderArguments& m_options;
    const document::Fractal& m_entry;
    QString m_name;
    Frames m_frames;
    document::AnimationFacts m_facts;
    document::ShutterAngle m_shutter = 0;
    Exposing m_exposing = Exposing::Smooth;
    std::vector<animation::Moment> m_pilots;
    std::map<std::size_t, attractor::Exposure> m_exposures; // of pilots
};

} // namespace cli
