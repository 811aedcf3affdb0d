// SPDX-License-Identifier: MIT
#include "transformation/theft_export_dialog.h"

#include "dialogs/export/export_camera.h"
#include "dialogs/export/export_preview.h"
#include "dialogs/export/export_size_editor.h"
#include "dialogs/export/large_export.h"
#include "dialogs/export/last_export.h"
#include "document/fractal_file.h"
#include "io/file/background.h"
#include "transformation/theft_export.h"
#include "widgets/choices.h"
#include "widgets/file_dialogs.h"
#include "widgets/text/tooltip_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

const QString exportKind = QStringLiteral("transformation");

} // namespace

TheftExportDialog::TheftExportDialog(const document::TheftJob& job, QWidget* parent)
    : ExportShell(parent), m_job(job) {
    setWindowTitle(tr("Export “%1”").arg(titleText(m_job.from.fractal->name)));
    createOptions();
    m_preview = new ExportPreview(this);
    lay(m_options, m_preview, Qt::Horizontal);
    setStartHelp(tr("Asks for a file name and writes the picture. You can keep working in the meantime."));
    connect(m_section, &QComboBox::currentIndexChanged, this, &TheftExportDialog::update);
    connect(m_size, &ExportSizeEditor::changed, this, &TheftExportDialog::update);
    connect(&m_work, &QFutureWatcherBase::finished, this, &TheftExportDialog::whenWorked);
    connect(&m_work, &QFutureWatcherBase::progressValueChanged, this,
            [this](int thousandths) { setFraction(thousandths / 1000.0); });
    connect(&m_extent, &QFutureWatcherBase::finished, this, &TheftExportDialog::update);
    m_extent.setFuture(io::inBackground<std::optional<document::Box>>(
        [fractal = m_job.from.fractal](QPromise<std::optional<document::Box>>& promise) {
            promise.addResult(document::displayedBox(*fractal));
        }));
    update();
}

TheftExportDialog::~TheftExportDialog() {
    m_stop.request_stop();
}

void TheftExportDialog::createOptions() {
    m_options = new QWidget(this);
    m_section = new QComboBox(m_options);
    addChoice(m_section, tr("The view on the canvas"), Section::View);
    addChoice(m_section, tr("The whole attractor"), Section::Attractor);
    m_section->setAccessibleName(tr("Section"));
    m_section->setWhatsThis(
        tr("What the picture shows: the view on the canvas, or the whole attractor with a small margin."));
    const double ratio = devicePixelRatioF(); // as many pixels as the screen shows
    m_size = new ExportSizeEditor({std::max(1, int(std::lround(m_job.from.camera.width * ratio))),
                                   std::max(1, int(std::lround(m_job.from.camera.height * ratio)))},
                                  m_options);
    m_size->choose(lastExport(exportKind).size);
    auto* form = new QFormLayout(m_options);
    form->setContentsMargins({});
    form->addRow(tr("Sect&ion:"), m_section);
    form->addRow(tr("Size:"), m_size);
}

void TheftExportDialog::setSection(Section section) {
    chooseValue(m_section, section);
}

void TheftExportDialog::setFolder(const QString& folder) {
    m_folder = folder;
}

QSize TheftExportDialog::pixels() const {
    return m_size->pixels();
}

attractor::Camera TheftExportDialog::camera(const QSize& size) const {
    const attractor::Camera camera = resized(m_job.from.camera, size);
    if (chosenValue<Section>(m_section) == Section::View) return camera;
    const std::optional<document::Box> box = m_extent.result(); // waits
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
    const QString name = document::uniqueName({}, m_job.from.fractal->name) + QStringLiteral(".png");
    const QString path =
        chooseFileToSave(this, tr("Export Stolen Picture"), suggestedPath(exportKind, name, m_folder),
                         tr("Pictures (*.png)"), QStringLiteral("png"));
    if (!path.isEmpty()) rememberExport(exportKind, {QStringLiteral("png"), m_size->choice()}, path);
    return path;
}

void TheftExportDialog::exportTo(const QString& path) {
    if (m_work.isRunning()) return;
    // Not under a name with another ending either: nobody was asked about a file that has it.
    if (QFileInfo(path).suffix().toLower() != QStringLiteral("png"))
        return say(
            tr("The name “%1” does not end with .png. Choose another name.").arg(QFileInfo(path).fileName()));
    m_path = path;
    m_stop = {};
    begin([this] { m_stop.request_stop(); });
    m_work.setFuture(io::inBackground<io::ExportOutcome>(
        io::Lane::Saving, [job = m_job, camera = camera(pixels()), path,
                           stop = m_stop.get_token()](QPromise<io::ExportOutcome>& promise) {
            promise.setProgressRange(0, 1000);
            const auto progress = [&](double fraction) { promise.setProgressValue(int(fraction * 1000)); };
            promise.addResult(exportStolenPicture(job, camera, path, progress, stop));
        }));
}

void TheftExportDialog::whenWorked() {
    io::ExportOutcome outcome;
    if (m_work.future().resultCount() > 0)
        outcome = m_work.result();
    else
        outcome.failure = tr("There is not enough memory for this picture. Reduce its size.");
    finish(outcome, m_path);
}

} // namespace view
