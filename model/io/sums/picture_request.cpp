// SPDX-License-Identifier: MIT
#include "io/sums/picture_request.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/fractal_file.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/text/number.h"

#include <QHash>

#include <algorithm>
#include <cstddef>
#include <memory>

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

constexpr int maxSide = 1'000'000;

std::optional<attractor::Camera> cameraOf(const RequestLines& lines) {
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

std::optional<attractor::OrbitCamera> orbitCameraOf(const RequestLines& lines) {
    attractor::OrbitCamera camera;
    for (int i = 0; i < 4; ++i) {
        const auto turn = lines.number("orientation", i);
        const auto at = i < 3 ? lines.number("target", i) : turn;
        if (!turn || !at) return std::nullopt;
        camera.orientation.coeffs()[i] = *turn;
        if (i < 3) camera.target[i] = *at;
    }
    camera.height = lines.number("height").value_or(0);
    camera.size.width = lines.integer("size", 1, maxSide, 0).value_or(0);
    camera.size.height = lines.integer("size", 1, maxSide, 1).value_or(0);
    if (const auto field = lines.number("perspective")) {
        camera.projection = attractor::OrbitCamera::Projection::Perspective;
        camera.fieldOfView = *field;
    }
    return isUsable(camera) ? std::optional(camera) : std::nullopt;
}

// The entry behind the lines of a request of our pixels; null where there is none.
struct Request {
    RequestLines lines;
    std::shared_ptr<const document::Fractal> fractal;
};
Request requestFrom(const QByteArray& text) {
    const QByteArray divider = "\nentry\n";
    const qsizetype end = text.indexOf(divider);
    Request request{RequestLines(text.left(std::max<qsizetype>(0, end))), nullptr};
    const document::FractalFile file =
        end < 0 ? document::FractalFile() : readFractint(text.mid(end + divider.size()));
    const bool isOurs =
        request.lines.integer("pixels", attractor::pixelVersion, attractor::pixelVersion).has_value();
    if (isOurs && file.entries.size() == 1) request.fractal = file.entries.first().fractal;
    return request;
}

template <class Picture> QByteArray commonLines(const Picture& picture) {
    QByteArray text = line("seed", {QByteArray::number(qulonglong(picture.request.seed))});
    text += line("bits", {picture.depth == PictureFormat::Depth::Bits16 ? "16" : "8"});
    if (picture.dotsPerInch) text += line("dpi", {formatNumber(*picture.dotsPerInch)});
    return text;
}

template <class Picture> void readCommonLines(const RequestLines& lines, Picture& picture) {
    picture.request.seed = lines.word("seed").toULongLong();
    picture.request.samples = 0;
    picture.dotsPerInch = lines.number("dpi");
    if (lines.word("bits") == "16") picture.depth = PictureFormat::Depth::Bits16;
}

bool isCloud(const SpaceExport& picture) {
    return attractor::showsCloud(picture.look);
}

// The fractal as it is drawn.
document::Fractal placed(const SpaceExport& picture) {
    document::Fractal fractal = picture.fractal;
    if (auto* shape = document::space(fractal)) shape->cage = picture.request.cage;
    return fractal;
}

} // namespace

QByteArray pictureRequest(const PlaneExport& picture, int pixels) {
    const attractor::Camera& camera = picture.request.camera;
    QByteArray text = line("pixels", {QByteArray::number(pixels)});
    text += line("centre", {formatNumber(camera.centre.x()), formatNumber(camera.centre.y())});
    text += line("scale", {formatNumber(camera.pixelsPerUnit)});
    text += line("size", {QByteArray::number(camera.width), QByteArray::number(camera.height)});
    text += line("y", {camera.yAxis == attractor::YAxis::Down ? "down" : "up"});
    if (camera.rotation != 0) text += line("rotation", {formatNumber(attractor::degreesOf(camera.rotation))});
    return text + commonLines(picture) + "entry\n" + writeEntry(picture.fractal);
}

std::optional<PlaneExport> pictureOf(const QByteArray& request) {
    const Request from = requestFrom(request);
    const auto camera = cameraOf(from.lines);
    if (!camera || !from.fractal || document::plane(*from.fractal) == nullptr) return std::nullopt;
    PlaneExport picture;
    picture.fractal = *from.fractal;
    picture.request = document::renderRequest(picture.fractal, *camera);
    readCommonLines(from.lines, picture);
    return picture;
}

QByteArray pictureRequest(const SpaceExport& picture, int pixels) {
    const attractor::OrbitCamera& camera = picture.request.camera;
    const auto& turn = camera.orientation.coeffs();
    QByteArray text = line("pixels", {QByteArray::number(pixels)});
    text += line("target", {formatNumber(camera.target.x()), formatNumber(camera.target.y()),
                            formatNumber(camera.target.z())});
    text += line("orientation", {formatNumber(turn[0]), formatNumber(turn[1]), formatNumber(turn[2]),
                                 formatNumber(turn[3])});
    text += line("height", {formatNumber(camera.height)});
    if (camera.projection == attractor::OrbitCamera::Projection::Perspective)
        text += line("perspective", {formatNumber(camera.fieldOfView)});
    text += line("size", {QByteArray::number(camera.size.width), QByteArray::number(camera.size.height)});
    if (!isCloud(picture)) {
        const attractor::Rgba& ground = picture.solid.background;
        text += line("supersample", {QByteArray::number(picture.supersample)});
        text += line("background", {QByteArray::number(ground.red), QByteArray::number(ground.green),
                                    QByteArray::number(ground.blue), QByteArray::number(ground.alpha)});
    }
    return text + commonLines(picture) + "entry\n" + writeEntry(placed(picture));
}

std::optional<SpaceExport> spacePictureOf(const QByteArray& request) {
    const Request from = requestFrom(request);
    const auto camera = orbitCameraOf(from.lines);
    if (!camera || !from.fractal || document::space(*from.fractal) == nullptr) return std::nullopt;
    SpaceExport picture;
    picture.fractal = *from.fractal;
    picture.look = picture.fractal.inSpace.look;
    picture.request = document::spaceRequest(picture.fractal, *camera);
    readCommonLines(from.lines, picture);
    if (isCloud(picture)) return picture;
    picture.solid = document::solidAppearance(picture.fractal);
    picture.supersample = from.lines.integer("supersample", 1, 4).value_or(1);
    attractor::Rgba& ground = picture.solid.background;
    const auto channel = [&](int index) {
        return std::uint8_t(from.lines.integer("background", 0, 255, index).value_or(0));
    };
    ground = {channel(0), channel(1), channel(2), channel(3)};
    return picture;
}

bool isOfSpace(const QByteArray& request) {
    const QByteArray entry = "\nentry\n";
    const qsizetype at = request.indexOf("\ntarget ");
    return at >= 0 && at < request.indexOf(entry);
}

} // namespace io
