// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/fractal/fractal.h"
#include "ifs/names.h"
#include "io/file/save_file.h"
#include "io/overlay/cage_overlay.h"
#include "io/overlay/picture_overlay.h"
#include "io/picture/vector/svg_document.h"

#include <QByteArray>

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>

namespace ifs {
class CopyHierarchy;
}

namespace io {

// Structured: copies of copies, small files. Outline: the union of the copies as one path, for cutters and
// plotters. Points: dots of the chaos game.
enum class ShapeStyle { Structured, Outline, Points };

struct SvgFormat {
    static constexpr std::uint64_t maxPoints = 1'000'000;

    std::optional<int> depth = std::nullopt; // levels of copies; nullopt: as many as a pixel needs
    CageVisibility cage = CageVisibility::Hidden;
    ShapeStyle style = ShapeStyle::Structured;
    std::uint64_t points = 20'000; // at most maxPoints
    std::uint64_t seed = 1;
    PictureOverlay overlay{};         // drawn on top
    double dotsPerInch = pixelsOfSvg; // pixels of the camera per inch
};

// What the picture lies on: an outline, on the material that is cut.
inline attractor::Rgba groundOf(const document::Fractal& fractal, const SvgFormat& format) {
    return format.style == ShapeStyle::Outline ? attractor::Rgba{0, 0, 0, 0} : fractal.appearance.background;
}

// A summary of a picture of shapes: for the dialog, before anything is written.
struct SvgPlan {
    int depth = 0;
    int deepest = 0;              // largest depth within the bound of references
    std::uint64_t references = 0; // copies that a reader of the file makes
    double errorInPixels = 0;     // certified distance to the attractor
    bool isCutShort = false;      // true if a pixel needs more copies than programs can draw quickly
    bool unbent = false;          // true if copies show the affine fit of a cage that bends
    Failure failure;              // reason why there can be no structured picture
};
SvgPlan svgPlan(const document::Fractal& fractal, const attractor::Camera& camera, const SvgFormat& format);
// The depth of the plan alone: measuring the error takes longer.
int svgDepth(const ifs::CopyHierarchy& levels, const SvgFormat& format);

// The fractal as the camera shows it, in a scalable picture. Of a structured one `<defs>` holds an outline
// and the levels, each level one `<use>` for every map. Carries the entry as `.ifs` text for readSvgSystem().
struct SvgPicture {
    QByteArray bytes; // empty after a failure
    SvgPlan plan;
};
SvgPicture svgPicture(const document::Fractal& fractal, const attractor::Camera& camera,
                      const SvgFormat& format, const std::stop_token& stop = {});

// The structured picture alone, sooner: its error is not measured. Empty where there is none.
QByteArray structuredSvg(const document::Fractal& fractal, const attractor::Camera& camera);

} // namespace io

template <>
inline constexpr auto ifs::names<io::ShapeStyle> = std::to_array<ifs::Named<io::ShapeStyle>>({
    {io::ShapeStyle::Structured, "structured"},
    {io::ShapeStyle::Outline, "outline"},
    {io::ShapeStyle::Points, "points"},
});
