// SPDX-License-Identifier: MIT
#include "animate/frame_request.h"

#include "io/animation/request_text.h"
#include "io/palette/palette_stops.h"
#include "io/text/number.h"

namespace cli {

namespace {

class CanonicalRequest : public io::FrameRequestText {
public:
    void addNumber(const char* name, const std::optional<double>& value) {
        if (value) add(name, io::formatNumber(*value));
    }
    void addNumbers(const char* name, const std::optional<NumberList>& list) {
        if (!list) return;
        QByteArrayList parts;
        for (const double number : list->values)
            parts << io::formatNumber(number);
        add(name, parts.join(','));
    }
};

QByteArray paletteText(const attractor::Palette& palette) {
    QByteArrayList stops;
    for (const auto& stop : palette.stops)
        stops << io::formatNumber(stop.position) + ' ' + io::colourText(stop.colour);
    return stops.join(", ");
}

} // namespace

QByteArray requestHash(const document::Fractal& entry, std::optional<int> frame,
                       const RenderArguments& options) {
    CanonicalRequest request;
    request.addFrame(frame);
    request.addCount("width", std::uint64_t(options.size.width()));
    request.addCount("height", std::uint64_t(options.size.height()));
    request.addCount("seed", options.seed);
    if (options.points) request.addCount("points", *options.points);
    if (options.palette) request.add("palette", paletteText(*options.palette));
    if (options.colour) request.add("colour", QByteArray::fromStdString(options.colour->word));
    for (std::size_t i = 0; i < numberOptions.size(); ++i)
        request.addNumber(numberOf(numberOptions[i]).key, options.numbers[i]);
    if (options.background) request.add("background", io::colourText(*options.background));
    if (options.supersample) request.addCount("supersample", std::uint64_t(*options.supersample));
    if (is16Bit(options)) request.add("bits", "16");
    request.addNumber("dpi", options.dpi);
    request.addNumbers("view", options.view);
    request.addNumber("view-rotation", options.viewRotation);
    if (options.given.has("--margin")) request.addNumber("margin", options.margin);
    if (options.yDown) request.add("y-down", "");
    request.addNumbers("orbit", options.orbit);
    request.addNumber("perspective", options.perspective);
    if (options.look) request.add("look", ifs::nameOf(*options.look));
    request.addNumbers("light", options.light);
    request.addNumber("fog", options.fog);
    if (options.shutter > 0) request.addCount("shutter", std::uint64_t(options.shutter));
    request.add("exposure", ifs::nameOf(options.exposure));
    request.addNumbers("slice", options.slice);
    if (options.stereo != attractor::Stereo::None) request.add("stereo", ifs::nameOf(options.stereo));
    return request.hash(entry);
}

} // namespace cli
