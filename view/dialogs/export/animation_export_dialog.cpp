// SPDX-License-Identifier: MIT
#include "dialogs/export/animation_export_dialog.h"

#include "bridges/attractor_watch.h"
#include "dialogs/animation/frame_size_editor.h"
#include "dialogs/export/cluster_queue.h"
#include "dialogs/export/export_preview.h"
#include "document/text/text.h"
#include "document/text/unique_names.h"
#include "io/animation/frames_view.h"
#include "io/file/background.h"
#include "widgets/background/wait_for.h"
#include "widgets/choices.h"
#include "widgets/file_dialogs.h"
#include "widgets/numbers/number_box.h"
#include "widgets/text/tooltip_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLatin1String>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <array>

namespace view {

namespace {

constexpr int usualPointsPerPixel = 100;
constexpr int usualSupersample = 2; // solids only
// The name of a format in the settings.
QString formatName(AnimationExportDialog::Format format) {
    return format ? io::videoSuffix(*format) : QStringLiteral("pictures");
}

QSpinBox* spinBox(const QString& name, int min, int max, int value, const QString& explanation) {
    auto* box = new WholeNumberBox;
    box->setRange(min, max);
    box->setValue(value);
    box->setAccessibleName(name);
    box->setWhatsThis(explanation);
    return box;
}

QComboBox* comboBox(const QString& name, const QString& explanation) {
    auto* box = new QComboBox;
    box->setAccessibleName(name);
    box->setWhatsThis(explanation);
    return box;
}

// "a × b"
QWidget* pair(QWidget* a, const QString& between, QWidget* b) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins({});
    layout->addWidget(a);
    layout->addWidget(new QLabel(between));
    layout->addWidget(b);
    layout->addStretch(1);
    row->setFocusProxy(a);
    return row;
}

template <int Dim> void setCamera(document::Shape<Dim>& shape, const AnimationExportDialog::Camera& camera) {
    if (const auto* pose = std::get_if<animation::CameraPose<Dim>>(&camera))
        shape.animation->camera = {{0, *pose, {}}};
}

} // namespace

AnimationExportDialog::AnimationExportDialog(document::Document* document, const Camera& camera,
                                             QWidget* parent)
    : ExportShell(QStringLiteral("animation"), document->entryFractal().name, parent),
      m_entry(document->entryFractal()),
      m_camera(camera),
      m_views(document::savedViews(m_entry)),
      m_form(new QFormLayout),
      m_queue(new ClusterQueue(this)),
      m_watch(new AttractorWatch(this)) {
    setWindowTitle(tr("Export the Animation “%1”").arg(titleText(m_entry.name)));
    createFormat();
    createFrames();
    auto* options = new QWidget(this);
    auto* layout = new QVBoxLayout(options);
    layout->setContentsMargins({});
    layout->addLayout(m_form);
    createPlan(options);
    layout->addStretch();
    lay(options, createPreview(), Qt::Horizontal);
    createButtons();
    connect(m_queue, &ClusterQueue::stateChanged, this, &AnimationExportDialog::say);
    connect(m_queue, &ClusterQueue::finished, this, [this] { m_cluster->setEnabled(true); });
    connect(m_watch, &AttractorWatch::changed, this, [this] {
        m_lost->setText(m_watch->sentence());
        m_lost->setVisible(m_watch->lost().has_value());
    });
    m_watch->look(document->currentEntry().fractal);
    update();
}

AnimationExportDialog::~AnimationExportDialog() = default;

void AnimationExportDialog::createFormat() {
    m_format = comboBox(tr("Format"),
                        tr("A video, an animated image for web pages and messages, or one picture for each "
                           "frame. All of them contain the animation, so Barycage can open them again."));
    for (const io::VideoFormatFacts& facts : io::videoFormats())
        addChoice(m_format, Text::tr(facts.listed), Format(facts.format));
    addChoice(m_format, tr("PNG: one picture for each frame"), Format());
    m_form->addRow(tr("&Format:"), m_format);
    m_section = comboBox(tr("Section"),
                         tr("What the frames show where the camera has no keys: the view on the canvas, or "
                            "everything that becomes visible, with a small margin."));
    addChoice(m_section, tr("The view on the canvas"), Section::View);
    addChoice(m_section, tr("The whole animation"), Section::Animation);
    for (int saved = 0; saved < int(m_views.size()); ++saved)
        addChoice(m_section, tr("The view “%1”").arg(m_views[std::size_t(saved)].name), saved);
    if (document::space(m_entry)) setSection(Section::Animation); // all of it, even if the camera orbits
    m_form->addRow(tr("Sect&ion:"), m_section);
    m_form->setRowVisible(m_section, !io::hasCameraKeys(m_entry));
    createSize();
    connect(m_format, &QComboBox::currentIndexChanged, this, [this] {
        say({}); // message about another file
        proposeSize();
        update();
    });
    connect(m_section, &QComboBox::currentIndexChanged, this, &AnimationExportDialog::showPreview);
}

// Begins with the size of the last export, for the format that it had.
void AnimationExportDialog::createSize() {
    m_size = new FrameSizeEditor;
    m_form->addRow(tr("&Size in pixels:"), m_size);
    for (int row = 0; row < m_format->count(); ++row) {
        const auto format = m_format->itemData(row).value<Format>();
        if (formatName(format) == last().format) chooseValue(m_format, format);
    }
    const QStringList sides = last().size.split(u' ');
    if (sides.size() == 2)
        m_size->setFrameSize({sides[0].toInt(), sides[1].toInt()});
    else
        proposeSize();
    connect(m_size, &FrameSizeEditor::edited, this, [this] { m_isSizeProposed = false; });
    connect(m_size, &FrameSizeEditor::changed, this, &AnimationExportDialog::update);
}

// Small for an animated image in 256 colours, which goes into mails and web pages.
void AnimationExportDialog::proposeSize() {
    if (!m_isSizeProposed) return;
    const auto format = chosenValue<Format>(m_format);
    const bool isPaletted = format && io::factsOf(*format).isPaletted;
    m_size->setFrameSize(isPaletted ? QSize(640, 360) : QSize(1920, 1080));
}

void AnimationExportDialog::createFrames() {
    const int last = io::frameCount(m_entry) - 1;
    m_first = spinBox(tr("First frame"), 0, last, 0, tr("The first frame to export."));
    m_last = spinBox(tr("Last frame"), 0, last, last, tr("The last frame to export."));
    m_form->addRow(tr("F&rames:"), pair(m_first, tr("to"), m_last));
    connect(m_first, &QSpinBox::valueChanged, this, [this](int first) {
        m_last->setMinimum(first);
        update();
    });
    connect(m_last, &QSpinBox::valueChanged, this, &AnimationExportDialog::update);
    m_quality = comboBox(tr("Quality"), tr("The number of points for each pixel of each frame: more "
                                           "points make smoother frames and take longer."));
    addChoice(m_quality, tr("Draft: 25 points per pixel"), 25);
    addChoice(m_quality, tr("Good: 100 points per pixel"), usualPointsPerPixel);
    addChoice(m_quality, tr("Fine: 400 points per pixel"), 400);
    addChoice(m_quality, tr("Finest: 2000 points per pixel"), 2000);
    chooseValue(m_quality, usualPointsPerPixel);
    m_form->addRow(tr("&Quality:"), m_quality);
    const auto* space = document::space(m_entry);
    const bool isSolid = space && !attractor::showsCloud(m_entry.inSpace.look);
    m_form->setRowVisible(m_quality, !isSolid);
    m_supersample = spinBox(tr("Supersampling"), 1, 4, usualSupersample,
                            tr("Computes this many cells along each side of a pixel, for smoother edges."));
    m_form->addRow(tr("S&upersampling:"), m_supersample);
    using attractor::LookInSpace;
    const bool isLit =
        m_entry.inSpace.look != LookInSpace::Depth && m_entry.inSpace.look != LookInSpace::Normals;
    m_form->setRowVisible(m_supersample, isSolid && isLit);
    connect(m_supersample, &QSpinBox::valueChanged, this, &AnimationExportDialog::update);
    m_shutter = spinBox(tr("Shutter"), 0, 360, 0,
                        tr("Motion blur: the angle for which the shutter is open around each frame. 180° is "
                           "half the time of a frame, as in films."));
    m_shutter->setSuffix(QStringLiteral("°"));
    m_shutter->setSpecialValueText(tr("No motion blur"));
    m_shutter->setSingleStep(45);
    m_form->addRow(tr("S&hutter:"), m_shutter);
    m_exposure = comboBox(tr("Exposure"),
                          tr("How bright the frames are: following the whole animation without flicker, all "
                             "like frame 0, or each as bright as it is on the canvas."));
    addChoice(m_exposure, tr("Smooth: no flicker"), io::Exposing::Smooth);
    addChoice(m_exposure, tr("Fixed: as in frame 0"), io::Exposing::Fixed);
    addChoice(m_exposure, tr("Each: frame by frame"), io::Exposing::Each);
    m_form->addRow(tr("E&xposure:"), m_exposure);
    m_form->setRowVisible(m_exposure, !isSolid);
    m_tasks = spinBox(tr("Tasks on a cluster"), 1, 10'000, 8,
                      tr("How many cluster tasks share the frames when you choose On a Cluster."));
    m_form->addRow(tr("&Tasks on a cluster:"), m_tasks);
    m_form->setRowVisible(m_tasks, ClusterQueue::isAvailable());
}

QWidget* AnimationExportDialog::createPreview() {
    auto* side = new QWidget(this);
    m_preview = new ExportPreview(side);
    m_previewed = new QSlider(Qt::Horizontal, side);
    const int last = io::frameCount(m_entry) - 1;
    m_previewed->setRange(0, last);
    m_previewed->setValue(last / 2);
    m_previewed->setAccessibleName(tr("Frame of the preview"));
    m_previewed->setToolTip(tr("The frame that the preview shows"));
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins({});
    layout->addWidget(m_preview, 1);
    layout->addWidget(m_previewed);
    connect(m_previewed, &QSlider::valueChanged, this, &AnimationExportDialog::showPreview);
    return side;
}

void AnimationExportDialog::showPreview() {
    if (m_preview == nullptr) return;
    m_preview->show(m_size->size(), [what = chosen(), frame = m_previewed->value()](
                                        const QSize& pixels, const std::stop_token& stop) {
        return io::framePreview(what, frame, pixels, stop);
    });
}

void AnimationExportDialog::createPlan(QWidget* options) {
    m_plan = new QLabel(options);
    m_plan->setWordWrap(true);
    m_plan->setAccessibleName(tr("Summary of the export"));
    m_lost = new QLabel(options);
    m_lost->setWordWrap(true);
    m_lost->setAccessibleName(tr("Frame without an attractor"));
    m_lost->hide();
    options->layout()->addWidget(m_plan);
    options->layout()->addWidget(m_lost);
}

void AnimationExportDialog::createButtons() {
    setStartHelp(tr("Asks for a file name and writes the animation. You can continue editing in the "
                    "meantime: the animation is exported as it was when this dialog opened."));
    m_cluster = addButton(tr("On a &Cluster…"),
                          tr("Writes a folder with the animation and with scripts that draw it on a Slurm "
                             "cluster, and submits the job if sbatch is found."));
    m_cluster->setObjectName(QStringLiteral("cluster"));
    connect(m_cluster, &QPushButton::clicked, this, &AnimationExportDialog::chooseFolder);
}

ExportShell::Unfinished AnimationExportDialog::unfinished() const {
    return {tr("The animation “%1” is still being exported.").arg(m_entry.name),
            isPictures() ? tr("The pictures written so far are complete and will be kept.")
                         : ExportShell::unfinished().ifStopped};
}

void AnimationExportDialog::reject() {
    const bool wasIdle = !isBusy();
    // An export that has ended meanwhile shows its outcome.
    if (mayClose() && (wasIdle || isBusy())) QDialog::reject();
}

void AnimationExportDialog::setSection(Section section) {
    chooseValue(m_section, section);
}

void AnimationExportDialog::setFormat(Format format) {
    chooseValue(m_format, format);
}

bool AnimationExportDialog::isPictures() const {
    return !chosenValue<Format>(m_format);
}

QString AnimationExportDialog::suffix() const {
    const auto format = chosenValue<Format>(m_format);
    return format ? io::videoSuffix(*format) : QStringLiteral("png");
}

// The entry with the view of the canvas as a key, if that is to be shown.
document::Fractal AnimationExportDialog::entryInView() const {
    document::Fractal entry = m_entry;
    if (io::hasCameraKeys(entry) || chosenValue<Section>(m_section) == Section::Animation) return entry;
    const int saved = chosenValue<int>(m_section);
    const Camera& camera = saved < 0 ? m_camera : m_views[std::size_t(saved)].camera;
    if (auto* shape = document::plane(entry)) setCamera(*shape, camera);
    if (auto* shape = document::space(entry)) setCamera(*shape, camera);
    return entry;
}

io::AnimationExport AnimationExportDialog::chosen() const {
    io::AnimationExport what;
    what.entry = entryInView();
    const auto* solid = std::get_if<attractor::OrbitCamera>(&m_camera);
    const bool isWhole = chosenValue<Section>(m_section) == Section::Animation;
    if (solid && isWhole && !io::hasCameraKeys(m_entry)) what.seenFrom = *solid;
    what.format = chosenValue<Format>(m_format);
    what.size = m_size->size();
    const int perPixel = chosenValue<int>(m_quality);
    if (perPixel != usualPointsPerPixel)
        what.points =
            std::uint64_t(perPixel) * std::uint64_t(what.size.width()) * std::uint64_t(what.size.height());
    if (m_supersample->value() != usualSupersample) what.supersample = m_supersample->value();
    what.frames.shutter = 1000 * m_shutter->value();
    what.frames.exposing = chosenValue<io::Exposing>(m_exposure);
    what.first = m_first->value();
    what.last = m_last->value();
    return what;
}

void AnimationExportDialog::update() {
    const document::AnimationFacts facts = *document::animationFacts(m_entry);
    const int count = m_last->value() - m_first->value() + 1;
    const double seconds = double(count) * facts.rate.seconds / facts.rate.frames;
    QString plan = tr("%n frame(s), %1 s.", nullptr, count).arg(seconds, 0, 'g', 3);
    const io::AnimationExport what = chosen();
    const bool isOdd = what.size.width() % 2 != 0 || what.size.height() % 2 != 0;
    const io::VideoFormatFacts* video = what.format ? &io::factsOf(*what.format) : nullptr;
    if (video && video->needsEvenSides && isOdd)
        plan += u' ' + tr("%1 needs even sides: the last column or row is shown twice.")
                           .arg(QLatin1String(video->title));
    if (video && !video->storesAlpha && m_entry.appearance.background.alpha < 255)
        plan += u' ' +
                tr("%1 has no transparency: the background becomes black.").arg(QLatin1String(video->title));
    m_plan->setText(plan);
    m_obstacle = io::animationObstacle(what);
    if (m_obstacle) say(*m_obstacle);
    enableButtons();
    showPreview();
}

void AnimationExportDialog::adoptEnding(const QString& path) {
    const auto format = io::videoFormat(QFileInfo(path).suffix());
    m_isSizeProposed = false; // keeps the size shown
    if (format && !isPictures()) chooseValue(m_format, format);
}

QString AnimationExportDialog::chosenFile() {
    WantedFile wanted{.title = tr("Export Animation"), .suffix = suffix(), .asksToReplace = !isPictures()};
    // Asks about the first picture; mayReplace() checks all of them.
    if (isPictures())
        wanted.name = [this](const QString& name) {
            return io::framePath(name, m_first->value(), m_last->value());
        };
    const QString path = chooseFile(wanted);
    if (path.isEmpty()) return {};
    adoptEnding(path);
    const QString size = QStringLiteral("%1 %2").arg(m_size->size().width()).arg(m_size->size().height());
    remember({formatName(chosenValue<Format>(m_format)), size}, path);
    const QString number = io::framePath(QStringLiteral(".png"), m_first->value(), m_last->value());
    const QString file =
        isPictures() && path.endsWith(number) ? path.chopped(number.size()) + QStringLiteral(".png") : path;
    return !isPictures() || mayReplace(file) ? file : QString();
}

bool AnimationExportDialog::mayReplace(const QString& path) {
    const QFuture<QStringList> work = io::inBackground<QStringList>(
        io::Lane::Reading, [what = chosen(), path](QPromise<QStringList>& promise) {
            promise.addResult(io::replacedFiles(what, path));
        });
    const QPointer self(this);
    if (!waitFor(QFuture<void>(work), tr("Looking for existing pictures…"), this) || !self) return false;
    const QStringList files = work.result();
    if (files.isEmpty()) return true;
    QMessageBox box(QMessageBox::Warning, tr("Replace Files?"),
                    tr("%n file(s) with the names of these pictures exist already and hold something else.",
                       nullptr, int(files.size())),
                    QMessageBox::Cancel, this);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(tr("The first one is “%1”. If you replace them, their contents are lost.")
                               .arg(QFileInfo(files[0]).fileName()));
    QPushButton* replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
    replace->setObjectName(QStringLiteral("replace"));
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return self && box.clickedButton() == replace;
}

void AnimationExportDialog::exportTo(const QString& path) {
    adoptEnding(path);
    m_cluster->setEnabled(false);
    start(chosen(), path, tr("Measuring the brightness…"));
}

void AnimationExportDialog::whenFinished() {
    m_cluster->setEnabled(true);
    update();
}

QString AnimationExportDialog::sentenceFor(const io::ExportOutcome& outcome, const QString& path) const {
    const auto picture = [&](int frame) { return io::framePath(path, frame, m_last->value()); };
    if (outcome.failure || !isPictures()) return ExportShell::sentenceFor(outcome, path);
    return outcome.stopped
               ? tr("Export stopped. The pictures written so far are complete; export again to draw the "
                    "others.")
               : tr("Written to %1 and so on, up to %2.")
                     .arg(picture(m_first->value()), QFileInfo(picture(m_last->value())).fileName());
}

void AnimationExportDialog::chooseFolder() {
    if (!m_form->isRowVisible(m_tasks)) { // Slurm not found: the folder is for another computer
        m_form->setRowVisible(m_tasks, true);
        m_tasks->setFocus();
        return say(tr("Choose how many tasks share the frames, then click On a Cluster… again."));
    }
    const QString folder = view::chooseFolder(this, tr("Folder That the Cluster Can Read and Write"));
    if (!folder.isEmpty()) prepareCluster(folder);
}

void AnimationExportDialog::prepareCluster(const QString& folder) {
    const io::ClusterJob job{chosen(), m_tasks->value()};
    QFuture<io::WrittenJob> work =
        io::inBackground<io::WrittenJob>(io::Lane::Saving, [folder, job](QPromise<io::WrittenJob>& promise) {
            promise.addResult(io::writeClusterJob(folder, {io::withViewKeyed(job.animation), job.tasks}));
        });
    const QPointer self(this);
    const bool isWritten = waitFor(QFuture<void>(work), tr("Writing the job folder…"), this);
    if (!self) return;
    if (!isWritten) return say(tr("Cancelled; the folder may be incomplete."));
    const io::WrittenJob written = work.result();
    if (written.failure) return say(*written.failure);
    if (!ClusterQueue::isAvailable()) {
        say(tr("The job is in %1. sbatch was not found on this computer: run submit.sh in this folder on the "
               "cluster.")
                .arg(written.folder));
    } else {
        m_cluster->setEnabled(false);
        m_queue->submit(written.folder);
    }
    offerFolderOf(written.folder + u'/');
    emit exported(written.folder);
}

} // namespace view
