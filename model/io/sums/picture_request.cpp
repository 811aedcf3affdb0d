// SPDX-License-Identifier: MIT
#include "io/sums/picture_request.h"

#include "document/fractal_file.h"
#include "document/fractal_geometry.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/text/number.h"

#include <QHash>

#include <cstddef>

namespace io {

namespace {

QByteArray line(const char* key, std::initializer_list<QByteArray> words) {
    QByteArray text(key);
    for (const QByteArray& word : words)
        text += ' ' + word;
    return text + '\n';
}

// The lines before the entry, by their keys.
class RequestLines {
public:
    explicit RequestLines(const QByteArray& text) {
        for (const QByteArray& line : text.split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            m_values.insert(words.first(), words.mid(1));
        }
    }

    QByteArray word(const char* key) const { return m_values.value(key).value(0); }
    std::optional<double> number(const char* key, int index = 0) const {
        return parseNumber(QString::fromLatin1(m_values.value(key).value(index)));
    }
    std::optional<int> integer(const char* key, int min, int max, int index = 0) const {
        bool isNumber = false;
        const int value = m_values.value(key).value(index).toInt(&isNumber);
        return isNumber && value >= min && value <= max ? std::optional(value) : std::nullopt;
    }

private:
    QHash<QByteArray, QList<QByteArray>> m_values;
};

std::optional<attractor::Camera> cameraOf(const RequestLines& lines) {
    constexpr int maxSide = 1'000'000;
    const auto x = lines.number("centre", 0);
    const auto y = lines.number("centre", 1);
    const auto scale = lines.number("scale");
    const auto width = lines.integer("size", 1, maxSide, 0);
    const auto height = lines.integer("size", 1, maxSide, 1);
    if (!x || !y || !scale || !(*scale > 0) || !width || !height) return std::nullopt;
    attractor::Camera camera{{*x, *y}, *scale, *width, *height, attractor::YAxis::Up};
    if (lines.word("y") == "down") camera.yAxis = attractor::YAxis::Down;
    if (const auto degrees = lines.number("rotation")) camera.rotation = attractor::rotationOf(*degrees);
    return camera;
}

} // namespace

QByteArray pictureRequest(const PngExport& picture, int pixels) {
    const attractor::Camera& camera = picture.request.camera;
    QByteArray text = line("pixels", {QByteArray::number(pixels)});
    text += line("centre", {formatNumber(camera.centre.x()), formatNumber(camera.centre.y())});
    text += line("scale", {formatNumber(camera.pixelsPerUnit)});
    text += line("size", {QByteArray::number(camera.width), QByteArray::number(camera.height)});
    text += line("y", {camera.yAxis == attractor::YAxis::Down ? "down" : "up"});
    if (camera.rotation != 0) text += line("rotation", {formatNumber(attractor::degreesOf(camera.rotation))});
    text += line("seed", {QByteArray::number(qulonglong(picture.request.seed))});
    text += line("bits", {picture.depth == PngFormat::Depth::Bits16 ? "16" : "8"});
    if (picture.dotsPerInch) text += line("dpi", {formatNumber(*picture.dotsPerInch)});
    return text + "entry\n" + writeEntry(picture.fractal);
}

std::optional<PngExport> pictureOf(const QByteArray& request) {
    const QByteArray divider = "\nentry\n";
    const qsizetype end = request.indexOf(divider);
    if (end < 0) return std::nullopt;
    const RequestLines lines(request.left(end));
    const auto camera = cameraOf(lines);
    const document::FractalFile file = readFractint(request.mid(end + divider.size()));
    if (!lines.integer("pixels", attractor::pixelVersion, attractor::pixelVersion) || !camera ||
        file.entries.size() != 1 || document::plane(*file.entries.first().fractal) == nullptr)
        return std::nullopt;
    PngExport picture;
    picture.fractal = *file.entries.first().fractal;
    picture.request = document::renderRequest(picture.fractal, *camera);
    picture.request.seed = lines.word("seed").toULongLong();
    picture.request.samples = 0;
    picture.dotsPerInch = lines.number("dpi");
    if (lines.word("bits") == "16") picture.depth = PngFormat::Depth::Bits16;
    return picture;
}

} // namespace io
