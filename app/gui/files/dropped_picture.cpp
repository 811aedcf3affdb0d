// SPDX-License-Identifier: MIT
#include "files/dropped_picture.h"

#include "docks/panels.h"
#include "document/text/text.h"
#include "io/file/background.h"
#include "io/file/save_file.h"
#include "io/picture/decoding/picture_decoder.h"
#include "io/picture/png/png_system.h"
#include "io/raster/raster_system.h"
#include "panels/collage/collage_panel.h"
#include "panels/collage/target_box.h"
#include "widgets/background/wait_for.h"

#include <QFileInfo>
#include <QMainWindow>

namespace {

bool isPlainPicture(const QString& path, QWidget* window) {
    static const QStringList withoutSystem{QStringLiteral("gif"), QStringLiteral("bmp"),
                                           QStringLiteral("pbm"), QStringLiteral("pgm"),
                                           QStringLiteral("ppm"), QStringLiteral("pnm")};
    const QFileInfo file(path);
    const QString suffix = file.suffix().toLower();
    if (!io::pictureSuffixes().contains(suffix)) return false;
    if (withoutSystem.contains(suffix)) return true;
    const QFuture<bool> reading = io::inBackground<bool>(io::Lane::Reading, [path](QPromise<bool>& isPlain) {
        const io::Loaded loaded = io::loadFile(path);
        const io::EmbeddedSystem system = io::rasterFormat(loaded.bytes).isEmpty()
                                              ? io::readPngSystem(loaded.bytes)
                                              : io::readRasterSystem(loaded.bytes);
        isPlain.addResult(!loaded.failure && system.text.isEmpty());
    });
    const QString label = Text::tr("Reading “%1”…").arg(file.fileName());
    return view::waitFor(QFuture<void>(reading), label, window) && reading.isResultReadyAt(0) &&
           reading.resultAt(0);
}

} // namespace

bool takeAsTarget(const QStringList& paths, QMainWindow& window, const Panels& panels,
                  view::CollagePanel& panel) {
    if (paths.size() != 1 || !isPlainPicture(paths.front(), &window)) return false;
    panels.show(Panel::Collage);
    panel.target()->read(paths.front());
    return true;
}
