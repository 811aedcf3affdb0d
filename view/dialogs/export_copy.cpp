// SPDX-License-Identifier: MIT
#include "dialogs/export_dialog.h"

#include "io/svg_writer.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

namespace view {

void copyPicture(document::Document* document, const attractor::Camera& camera, const QImage& shown) {
    auto data = std::make_unique<QMimeData>();
    data->setImageData(shown);
    const io::SvgPicture svg = io::svgPicture(document->fractal(), camera, {});
    if (!svg.plan.failure) data->setData(QStringLiteral("image/svg+xml"), svg.bytes);
    QGuiApplication::clipboard()->setMimeData(data.release()); // the clipboard owns it
}

} // namespace view
