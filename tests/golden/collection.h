// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/solid_light.h"
#include "attractor/render/renderer.h"
#include "attractor/render/solid_rendering.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal_file.h"
#include "io/fractint/fractint_reader.h"

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QList>
#include <QString>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

// The bundled collection as the tests see it.
namespace golden {

struct Theme {
    QString fileName;
    QString title;
    QString description;
    QByteArray bytes;
    document::FractalFile file;
};

inline QByteArray resource(const QString& name) {
    QFile file(QStringLiteral(":/ifs_library/") + name);
    if (!file.open(QIODevice::ReadOnly)) throw std::runtime_error("no resource " + name.toStdString());
    return file.readAll();
}

// In the order of the index.
inline QList<Theme> collection() {
    QList<Theme> themes;
    const QJsonArray index = QJsonDocument::fromJson(resource(QStringLiteral("index.json")))
                                 .object()
                                 .value(QStringLiteral("themes"))
                                 .toArray();
    for (const QJsonValue& item : index) {
        Theme theme;
        theme.fileName = item[u"file"].toString();
        theme.title = item[u"title"].toString();
        theme.description = item[u"description"].toString();
        theme.bytes = resource(theme.fileName);
        theme.file = io::readFractint(theme.bytes);
        themes << theme;
    }
    return themes;
}

inline constexpr int tileSize = 96;

// 500 samples per pixel of a full tile: the grain of the golden picture stays far below the threshold of
// comparison.
inline attractor::RenderRequest tileRequest(const document::Fractal& fractal) {
    attractor::Camera camera;
    camera.width = camera.height = tileSize;
    if (const std::optional<document::Box> box = document::displayedBox(fractal))
        camera = attractor::fitted(camera, box->min, box->max, 0.05);
    attractor::RenderRequest request = document::renderRequest(fractal, camera);
    request.samples = 200 * tileSize * tileSize;
    request.seed = 1;
    return request;
}

inline QImage picture(const attractor::Frame& frame) {
    const QImage view(reinterpret_cast<const uchar*>(frame.pixels.data()), frame.camera.width,
                      frame.camera.height, QImage::Format_ARGB32_Premultiplied);
    return view.convertToFormat(QImage::Format_RGB32);
}

// A solid of stone, from the usual side.
inline QImage solidTile(const document::System3& system) {
    attractor::SpaceRequest request;
    request.system = system;
    request.camera.size = {tileSize, tileSize};
    request.camera.orientation = attractor::orbit(30, 20);
    const auto support = ifs::SupportFunction<3>::of(ifs::activeMaps(system).maps);
    request.camera = attractor::fitted(request.camera, *support, {}, 0.05);
    attractor::SolidRendering rendering(request);
    rendering.draw();
    if (rendering.note() != attractor::RenderNote::None || rendering.work().isCoarse) return {};
    attractor::Frame frame;
    frame.camera.width = frame.camera.height = tileSize;
    attractor::Workers workers(1);
    frame.pixels =
        attractor::lit(rendering.raster(), {}, attractor::solidView(request.camera, 0, 1), workers);
    return picture(frame);
}

inline QImage tile(const document::Fractal& fractal) {
    if (const auto* solid = document::system3(fractal)) return solidTile(*solid);
    return picture(attractor::render(tileRequest(fractal)));
}

// Peak signal to noise ratio in decibels over the three channels, peak 255; infinite for equal pictures.
inline double psnr(const QImage& a, const QImage& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            sum += std::pow(qRed(p) - qRed(q), 2) + std::pow(qGreen(p) - qGreen(q), 2) +
                   std::pow(qBlue(p) - qBlue(q), 2);
        }
    if (sum == 0) return std::numeric_limits<double>::infinity();
    return 10 * std::log10(255.0 * 255.0 * 3.0 * a.width() * a.height() / sum);
}

} // namespace golden
