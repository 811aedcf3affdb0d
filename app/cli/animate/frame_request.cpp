// SPDX-License-Identifier: MIT
#include "animate/frame_request.h"

#include "process/arguments.h"

#include "io/animation/request_text.h"
#include "io/palette/palette_stops.h"
#include "io/text/number.h"

namespace cli {

namespace {

// With the options as they were typed.
class CanonicalRequest : public io::FrameRequestText {
public:
    void addText(const char* name, const OptionText& value) {
        if (value) add(name, QByteArray::fromStdString(*value));
    }
    // Numbers between commas, as doubles.
    void addNumbers(const char* name, const OptionText& value) {
        if (!value) return;
        QByteArrayList parts;
        for (const double number : numbers(QString::fromStdString(*value)))
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
    const QSize size = pictureSizeArgument("--size", options.size);
    request.addCount("width", std::uint64_t(size.width()));
    request.addCount("height", std::uint64_t(size.height()));
    request.addCount("seed", wholeArgument("--seed", options.seed));
    if (options.points) request.addCount("points", countArgument("--points", *options.points, 1, maxPoints));
    if (options.readPalette) request.add("palette", paletteText(*options.readPalette));
    request.addText("colour", options.colour);
    request.addNumbers("gamma", options.gamma);
    request.addNumbers("brightness", options.brightness);
    request.addNumbers("contrast", options.contrast);
    request.addNumbers("vibrancy", options.vibrancy);
    if (options.background)
        request.add("background", io::colourText(colourArgument("--background", *options.background)));
    request.addText("supersample", options.supersample);
    if (is16Bit(options)) request.add("bits", "16");
    request.addNumbers("dpi", options.dpi);
    request.addNumbers("view", options.view);
    request.addNumbers("view-rotation", options.viewRotation);
    request.addNumbers("margin", options.margin);
    if (options.yDown) request.add("y-down", "");
    request.addNumbers("orbit", options.orbit);
    request.addNumbers("perspective", options.perspective);
    request.addText("look", options.look);
    request.addNumbers("light", options.light);
    request.addNumbers("fog", options.fog);
    if (options.shutter) {
        const document::ShutterAngle angle = shutterArgument("--shutter", *options.shutter);
        if (angle > 0) request.addCount("shutter", std::uint64_t(angle));
    }
    request.add("exposure", QByteArray::fromStdString(options.exposure));
    request.addNumbers("slice", options.slice);
    request.addText("stereo", options.stereo);
    return request.hash(entry);
}

} // namespace cli
