// SPDX-License-Identifier: MIT
#include "dialogs/export/copy_picture.h"

#include "dialogs/export/export_dialog.h"
#include "io/file/background.h"
#include "io/picture/vector/svg_writer.h"
#include "widgets/background/wait_for.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

namespace view {

void copyPicture(document::Document* document, const attractor::Camera& camera, const QImage& shown,
                 QWidget* parent) {
    auto data = std::make_unique<QMimeData>();
    data->setImageData(shown);
    QFuture<QByteArray> writing =
        io::inBackground<QByteArray>([fractal = document->fractal(), camera](QPromise<QByteArray>& promise) {
            promise.addResult(io::structuredSvg(fractal, camera));
        });
    // The picture is copied even without shapes.
    if (waitFor(QFuture<void>(writing), ExportDialog::tr("Copying the picture…"), parent))
        if (const QByteArray svg = writing.takeResult(); !svg.isEmpty())
            data->setData(QStringLiteral("image/svg+xml"), svg);
    QGuiApplication::clipboard()->setMimeData(data.release()); // owned by the clipboard
}

} // namespace view
