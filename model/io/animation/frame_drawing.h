// SPDX-License-Identifier: MIT
#pragma once

#include "document/moments/shutter.h"
#include "ifs/names.h"
#include "io/animation/request_text.h"
#include "io/picture/plane_export.h"
#include "io/picture/space_export.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>

namespace io {

// Keywords of the texts in which a frame carries the hashes of its request, and the number of its file.
inline constexpr const char* frameRequestKeyword = "barycage:request";
inline constexpr const char* animationRequestKeyword = "barycage:animation";
inline constexpr const char* frameNumberKeyword = "barycage:frame";

// Brightness of the frames.
enum class Exposing {
    Smooth, // one exposure that follows the whole animation, without flicker
    Fixed,  // exposure of frame 0
    Each,   // separate exposure for each frame
};

struct FrameOptions {
    document::ShutterAngle shutter = 0;
    Exposing exposing = Exposing::Smooth;
};

// Draws an animated entry at a moment, on request. One of the two functions is called, by the dimension of
// the entry; their results carry the whole entry as text.
class FrameSource {
public:
    virtual ~FrameSource() = default;
    virtual const document::Fractal& entry() const = 0; // animated entry
    virtual PlaneExport planeAt(const animation::Moment& moment) const = 0;
    virtual SpaceExport spaceAt(const animation::Moment& moment) const = 0;
};

// Draws the frames of an entry, in any order: each is a function of the entry, its number and the options.
class FrameDrawing {
public:
    FrameDrawing(std::unique_ptr<FrameSource> source, const FrameOptions& options);

    // A PNG picture that carries the hashes of its request; `path` appears whole or not at all. It is encoded
    // while the next one is drawn, so that its failure may be that of the next call, or of finish().
    ExportOutcome writePng(int frame, const QString& path, const FrameHashes& hashes,
                           const Progress& progress, const std::stop_token& stop);
    Failure finish();                                    // waits for the last picture
    const QString& failedPath() const { return m_path; } // path of the picture that cannot be written
    // The same pixels with 8 bits per channel; null when stopped. Throws bad_alloc where there is no room for
    // it.
    Picture draw(int frame, const Progress& progress, const std::stop_token& stop);

    bool isTransparent(int frame) const; // true if the frame may have transparent pixels
    // Returns true if any frame is transparent.
    bool isTransparent(const std::vector<int>& frames) const;

private:
    using Measuring = std::function<std::optional<attractor::Exposure>()>;

    bool isPlane() const { return document::plane(m_source->entry()) != nullptr; }
    Failure startOf(const QString& path);
    ExportOutcome encodeLater(const QString& path, const PictureFormat& format,
                              const std::function<Picture()>& draw, const std::stop_token& stop);
    PlaneExport planeFrame(int frame, const std::stop_token& stop);
    SpaceExport spaceFrame(int frame, const std::stop_token& stop);
    template <class Request, class RequestAt>
    std::vector<Request> momentsOf(int frame, RequestAt requestAt) const;
    // nullopt: the frame has its own, or the work is stopped.
    std::optional<attractor::Exposure> exposureAt(int frame, const std::stop_token& stop);
    void measurePilots(const document::BetweenPilots& between, const std::stop_token& stop);
    Measuring measuringOf(std::size_t pilot, int threads, const std::stop_token& stop) const;
    int threads() const;

    std::unique_ptr<FrameSource> m_source;
    FrameOptions m_options;
    document::AnimationFacts m_facts;
    std::vector<animation::Moment> m_pilots;
    std::map<std::size_t, attractor::Exposure> m_exposures; // exposures of the pilots
    QString m_path;                                         // path of the newest picture
    std::future<Failure> m_written;                         // result of the picture being encoded
};

} // namespace io

template <>
inline constexpr auto ifs::names<io::Exposing> = std::to_array<ifs::Named<io::Exposing>>({
    {io::Exposing::Fixed, "fixed"},
    {io::Exposing::Smooth, "smooth"},
    {io::Exposing::Each, "each"},
});
