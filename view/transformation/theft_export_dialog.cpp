// SPDX-License-Identifier: MIT
#include "transformation/theft_export_dialog.h"

#include "dialogs/export/export_camera.h"
#include "dialogs/export/export_preview.h"
#include "dialogs/export/export_size_editor.h"
#include "dialogs/export/large_export.h"
#include "io/file/background.h"
#include "transformation/theft_export.h"
#include "widgets/choices.h"
#include "widgets/text/tooltip_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>

#include <algorithm>
#include <cmath>

namespace view {

TheftExportDialog::TheftExportDialog(const document::TheftJob& job, QWidget* parent)
    : ExportShell(QStringLiteral("transformation"), job.from.fractal->name, parent), m_job(job) {
    setWindowTitle(tr("Export “%1”").arg(titleText(m_job.from.fractal->name)));
    QFormLayout* options = createOptions();
    m_preview = new ExportPreview(this);
    lay(options, m_preview, Qt::Horizontal);
    setStartHelp(tr("Asks for a file name and writes the picture. You can keep working in the meantime."));
    connect(m_section, &QComboBox::currentIndexChanged, this, &TheftExportDialog::update);
    connect(m_size, &ExportSizeEditor::changed, this, &TheftExportDialog::update);
    connect(&m_extent, &QFutureWatcherBase::finished, this, &TheftExportDialog::update);
    m_extent.setFuture(io::inBackground<std::optional<document::Box>>(
        [fractal = m_job.from.fractal](QPromise<std::optional<document::Box>>& promise) {
            promise.addResult(document::displayedBox(*fractal));
        }));
    update();
}

QFormLayout* TheftExportDialog::createOptions() {
    m_section = new QComboBox(this);
    addChoice(m_section, tr("The view on the canvas"), Section::View);
    addChoice(m_section, tr("The whole attractor"), Section::Attractor);
    m_section->setAccessibleName(tr("Section"));
    m_section->setWhatsThis(
        tr("What the picture shows: the view on the canvas, or the whole attractor with a small margin."));
    const double ratio = devicePixelRatioF(); // resolution of the screen
    m_size = new ExportSizeEditor({std::max(1, int(std::lround(m_job.from.camera.width * ratio))),
                                   std::max(1, int(std::lround(m_job.from.camera.height * ratio)))},
                                  this);
    m_size->choose(last().size);
    auto* form = new QFormLayout;
    form->addRow(tr("Sect&ion:"), m_section);
    form->addRow(tr("Size:"), m_size);
    return form;
}

void TheftExportDialog::setSection(Section section) {
    chooseValue(m_section, section);
}

QSize TheftExportDialog::pixels() const {
    return m_size->pixels();
}

attractor::Camera TheftExportDialog::camera(const QSize& size) const {
    const attractor::Camera camera = resized(m_job.from.camera, size);
    if (chosenValue<Section>(m_section) == Section::View) return camera;
    const std::optional<document::Box> box = m_extent.result(); // blocks until found
    return box ? attractor::fitted(camera, box->min, box->max) : camera;
}

void TheftExportDialog::update() {
    const bool isKnown = chosenValue<Section>(m_section) == Section::View || m_extent.future().isFinished();
    if (!isKnown) return m_preview->show(pixels(), nullptr);
    m_preview->show(pixels(),
                    [job = m_job, whole = camera(pixels())](const QSize& size, const std::stop_token& stop) {
                        return stolenPicture(job, resized(whole, size), stop);
                    });
}

QString TheftExportDialog::chosenFile() {
    if (!confirmLargeExport(this, m_size->pixels(), 0)) return {};
    const QString png = QStringLiteral("png");
    const QString path =
        chooseFile({.title = tr("Export Stolen Picture"), .suffix = png, .filter = tr("Pictures (*.png)")});
    if (!path.isEmpty()) remember({png, m_size->choice()}, path);
    return path;
}

void TheftExportDialog::exportTo(const QString& path) {
    if (isBusy()) return;
    // Refuses other suffixes, because the user was not asked about such a file.
    if (QFileInfo(path).suffix().toLower() != QStringLiteral("png"))
        return say(
            tr("The name “%1” does not end with .png. Choose another name.").arg(QFileInfo(path).fileName()));
    start([job = m_job, camera = camera(pixels()), path](
              const io::Progress& progress,
              const std::stop_token& stop) { return exportStolenPicture(job, camera, path, progress, stop); },
          path);
}

} // namespace view
