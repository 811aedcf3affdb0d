// SPDX-License-Identifier: MIT
#include "dialogs/export/copy_picture.h"

#include "dialogs/export/export_dialog.h"
#include "io/file/background.h"
#include "io/picture/svg_writer.h"
#include "widgets/wait_for.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

namespace view {

void copyPicture(document::Document* document, const attractor::Camera& camera, const QImage& shown,
                 QWidget* parent) {
    auto data = std::make_unique<QMimeData>();
    data->setImageData(shown);
    QFuture<io::SvgPicture> writing = io::inBackground<io::SvgPicture>(
        [fractal = document->fractal(), camera](QPromise<io::SvgPicture>& promise) {
            promise.addResult(io::svgPicture(fractal, camera, {}));
        });
    // Without its lines it is still a picture.
    if (waitFor(QFuture<void>(writing), ExportDialog::tr("Copying the picture…"), parent))
        if (const io::SvgPicture svg = writing.takeResult(); !svg.plan.failure)
            data->setData(QStringLiteral("image/svg+xml"), svg.bytes);
    QGuiApplication::clipboard()->setMimeData(data.release()); // the clipboard owns it
}

} // namespace view
