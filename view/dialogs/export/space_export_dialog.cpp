// SPDX-License-Identifier: MIT
#include "dialogs/export/space_export_dialog.h"

#include "dialogs/export/export_preview.h"
#include "dialogs/export/export_size_editor.h"
#include "dialogs/export/large_export.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"
#include "document/text/stereo_modes.h"
#include "document/text/text.h"
#include "io/exports/recipe_json.h"
#include "io/picture/picture_writers.h"
#include "io/solid/openscad.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_box.h"
#include "widgets/text/tooltip_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>

namespace view {

namespace {

// Replacements for the index of a saved view.
constexpr int theCanvas = -1, theAttractor = -2;

struct BodyKind {
    SpaceExportDialog::Format format;
    QString title;
    QString suffix; // default suffix
};

QList<BodyKind> bodyKinds() {
    QList<BodyKind> all;
    for (const io::PictureFileFacts& facts : io::pictureFiles())
        if (facts.inSpace)
            all << BodyKind{facts.file, Text::tr(facts.inSpace), QLatin1String(facts.suffixes.front())};
    for (const auto& [file, suffix] : ifs::names<io::ShapeFile>)
        all << BodyKind{file, Text::tr(io::titlesOf(file).inSpace), QLatin1String(suffix)};
    for (const auto& [mesh, suffix] : ifs::names<io::MeshFormat>)
        all << BodyKind{mesh, Text::tr(io::titleOf(mesh)), QLatin1String(suffix)};
    all << BodyKind{SpaceExportDialog::OpenScad(), SpaceExportDialog::tr("OpenSCAD program (.scad)"),
                    QStringLiteral("scad")};
    return all;
}

QString endings() {
    QStringList all;
    for (const BodyKind& kind : bodyKinds())
        all << u'.' + kind.suffix;
    return all.join(QStringLiteral(", "));
}

std::optional<SpaceExportDialog::Format> formatOf(const QString& ending) {
    if (const auto file = io::pictureFileOf(ending)) return *file; // one of several suffixes
    for (const BodyKind& kind : bodyKinds())
        if (kind.suffix == ending) return kind.format;
    return std::nullopt;
}

} // namespace

SpaceExportDialog::SpaceExportDialog(document::Document* document, const attractor::OrbitCamera& camera,
                                     QWidget* parent)
    : ExportShell(QStringLiteral("solid"), document->fractal().name, parent),
      m_fractal(document->fractal()),
      m_camera(camera),
      m_views(document::savedViews(m_fractal)),
      m_form(new QFormLayout) {
    setWindowTitle(tr("Export “%1”").arg(titleText(m_fractal.name)));
    m_format = new QComboBox(this);
    for (const BodyKind& kind : bodyKinds())
        addChoice(m_format, kind.title, kind.format);
    m_format->setWhatsThis(tr("A picture as the camera shows it, a watertight mesh that contains the "
                              "attractor, or the maps as a program for OpenSCAD."));
    m_form->addRow(tr("&Format:"), m_format);
    createPicture();
    createBody();
    m_preview = new ExportPreview(this);
    lay(m_form, m_preview, Qt::Horizontal);
    setStartHelp(tr("Asks for a file name and writes the file."));
    if (document::animationFacts(document->entryFractal())) addAnimationButton();
    addQueueButton(tr("Asks for a file name and adds the file to the queue in the Exports panel. "
                      "The queue continues after a restart."));
    setFormat(formatOf(last().format).value_or(io::PictureFile::Png));
    m_size->choose(last().size);
    showBody(last().more);
    connect(m_format, &QComboBox::currentIndexChanged, this, &SpaceExportDialog::update);
    connect(m_size, &ExportSizeEditor::changed, this, &SpaceExportDialog::showPreview);
    for (const QCheckBox* box : {m_transparent, m_cage})
        connect(box, &QCheckBox::toggled, this, &SpaceExportDialog::showPreview);
    connect(m_stereo, &QComboBox::currentIndexChanged, this, &SpaceExportDialog::update);
    connect(m_supersample, &QSpinBox::valueChanged, this, &SpaceExportDialog::showPreview);
    update();
}

SpaceExportDialog::~SpaceExportDialog() = default;

void SpaceExportDialog::createPicture() {
    m_section = new QComboBox(this);
    addChoice(m_section, tr("The view on the canvas"), theCanvas);
    if (document::isSpaceExtentKnown(m_fractal))
        addChoice(m_section, tr("The whole attractor"), theAttractor);
    for (int saved = 0; saved < int(m_views.size()); ++saved)
        addChoice(m_section, tr("The view “%1”").arg(m_views[std::size_t(saved)].name), saved);
    m_section->setAccessibleName(tr("Section"));
    m_section->setWhatsThis(tr("What the picture shows: the view on the canvas, or the whole attractor with "
                               "a small margin. Saved views are listed, too."));
    m_form->addRow(tr("Sect&ion:"), m_section);
    connect(m_section, &QComboBox::currentIndexChanged, this, &SpaceExportDialog::showPreview);
    m_section->setObjectName(QStringLiteral("section"));
    m_size = new ExportSizeEditor({m_camera.size.width, m_camera.size.height}, this);
    m_form->addRow(tr("&Size:"), m_size);
    m_supersample = new WholeNumberBox(this);
    m_supersample->setRange(1, 4);
    m_supersample->setValue(2);
    m_supersample->setWhatsThis(
        tr("Computes this many cells along each side of a pixel, for smoother edges."));
    m_form->addRow(tr("S&upersampling:"), m_supersample);
    m_depth = new QComboBox(this);
    using Depth = io::PictureFormat::Depth;
    addChoice(m_depth, tr("8 bits per channel"), Depth::Bits8);
    addChoice(m_depth, tr("16 bits per channel, for further editing"), Depth::Bits16);
    if (m_fractal.inSpace.look == attractor::LookInSpace::Normals) chooseValue(m_depth, Depth::Bits16);
    m_depth->setWhatsThis(tr("Bits per channel. Depths always have 16."));
    m_form->addRow(tr("C&olour depth:"), m_depth);
    m_transparent = new QCheckBox(tr("&Transparent background"), this);
    m_transparent->setWhatsThis(tr("Makes the surroundings of the solid transparent."));
    m_form->addRow(QString(), m_transparent);
    m_cage = new QCheckBox(tr("Include the ca&ge"), this);
    m_cage->setObjectName(QStringLiteral("cage"));
    m_cage->setWhatsThis(tr("Draws the cage over the picture."));
    m_form->addRow(QString(), m_cage);
    m_stereo = new QComboBox(this);
    for (const document::StereoMode& mode : document::stereoModes())
        addChoice(m_stereo, Text::tr(mode.title), mode.value);
    m_stereo->setWhatsThis(tr("For both eyes: two pictures side by side, or one in red and cyan."));
    m_form->addRow(tr("Stere&o:"), m_stereo);
}

void SpaceExportDialog::createBody() {
    const auto millimetres = [this](double value, double most, const QString& explanation) {
        auto* field = new NumberBox(this);
        field->setRange(0, most);
        field->setDecimals(2);
        field->setSuffix(tr(" mm"));
        field->setValue(value);
        field->setWhatsThis(explanation);
        return field;
    };
    m_longest = millimetres(80, 100'000, tr("The longest side of the mesh."));
    m_longest->setMinimum(1);
    m_form->addRow(tr("&Longest side:"), m_longest);
    m_resolution = new WholeNumberBox(this);
    m_resolution->setRange(io::SolidOptions::leastOffered, io::SolidOptions::maxResolution);
    m_resolution->setValue(128);
    m_resolution->setWhatsThis(
        tr("Voxels along the longest side: more voxels make finer steps. A solid has at most %1 million "
           "voxels and %2 million triangles.")
            .arg(attractor::VoxelGrid::maxVoxels / 1'000'000)
            .arg(attractor::SurfaceMesh::maxTriangles / 1'000'000));
    m_form->addRow(tr("&Resolution:"), m_resolution);
    m_wall = millimetres(0, 1000, tr("Thinner parts are thickened to this, so that they can be printed."));
    m_form->addRow(tr("Smallest &wall:"), m_wall);
    m_fill = new QCheckBox(tr("Fill closed ca&vities"), this);
    m_fill->setWhatsThis(tr("Fills spaces that are closed off from the outside."));
    m_form->addRow(QString(), m_fill);
    connect(m_longest, &QDoubleSpinBox::valueChanged, this, &SpaceExportDialog::check);
    connect(m_resolution, &QSpinBox::valueChanged, this, &SpaceExportDialog::check);
    connect(m_wall, &QDoubleSpinBox::valueChanged, this, &SpaceExportDialog::check);
}

// Restores what bodyText() remembered.
void SpaceExportDialog::showBody(const QString& text) {
    const auto recipe = io::recipeIn(QJsonDocument::fromJson(text.toUtf8()).object());
    const auto* body = recipe && io::isUsable(*recipe) ? std::get_if<io::BodyRecipe>(&*recipe) : nullptr;
    if (!body) return;
    m_longest->setValue(body->longest);
    m_resolution->setValue(body->resolution);
    m_wall->setValue(body->wall);
    m_fill->setChecked(body->fillsCavities);
}

QString SpaceExportDialog::bodyText() const {
    if (!isBody()) return {};
    return QString::fromUtf8(QJsonDocument(io::recipeJson(*recipe())).toJson(QJsonDocument::Compact));
}

SpaceExportDialog::Format SpaceExportDialog::format() const {
    return chosenValue<Format>(m_format);
}

std::optional<io::PictureFile> SpaceExportDialog::pictureFile() const {
    if (page()) return io::PictureFile::Png;
    const Format chosen = format();
    const auto* file = std::get_if<io::PictureFile>(&chosen);
    return file ? std::optional(*file) : std::nullopt;
}

std::optional<io::ShapeFile> SpaceExportDialog::page() const {
    const Format chosen = format();
    const auto* file = std::get_if<io::ShapeFile>(&chosen);
    return file ? std::optional(*file) : std::nullopt;
}

void SpaceExportDialog::setFormat(const Format& format) {
    chooseValue(m_format, format);
}

QString SpaceExportDialog::suffix() const {
    const QList<BodyKind> kinds = bodyKinds();
    return std::ranges::find(kinds, format(), &BodyKind::format)->suffix;
}

void SpaceExportDialog::beginWithAttractor() {
    if (m_section->findData(theAttractor) >= 0) chooseValue(m_section, theAttractor);
}

attractor::OrbitCamera SpaceExportDialog::camera() const {
    const int saved = chosenValue<int>(m_section);
    if (saved == theCanvas) return m_camera;
    if (saved == theAttractor) {
        attractor::OrbitCamera whole = m_camera;
        const auto stereo = chosenValue<io::Stereo>(m_stereo);
        whole.size = {std::max(1, m_size->pixels().width() / attractor::picturesAcross(stereo)),
                      m_size->pixels().height()};
        // The numbers of the corners take room.
        return m_cage->isChecked() && m_cage->isEnabled() ? document::fittedTo(m_fractal, whole, 0.06)
                                                          : document::fittedToPicture(m_fractal, whole, 0.02);
    }
    auto camera = std::get<attractor::OrbitCamera>(m_views[std::size_t(saved)].camera);
    camera.size = m_camera.size;
    return camera;
}

std::optional<io::ExportRecipe> SpaceExportDialog::recipe() const {
    if (std::holds_alternative<OpenScad>(format())) return std::nullopt;
    if (isBody()) {
        io::BodyRecipe body;
        body.format = std::get<io::MeshFormat>(format());
        body.longest = m_longest->value();
        body.resolution = m_resolution->value();
        body.wall = m_wall->value();
        body.fillsCavities = m_fill->isChecked();
        return body;
    }
    io::SpaceRecipe picture;
    picture.camera = camera();
    picture.size = {m_size->pixels().width(), m_size->pixels().height()};
    picture.file = *pictureFile();
    picture.page = page();
    picture.isTransparent = m_transparent->isChecked() && io::factsOf(picture.file).canBeTransparent;
    picture.stereo = chosenValue<io::Stereo>(m_stereo);
    picture.showsCage = m_cage->isChecked();
    picture.supersample = m_supersample->value();
    using enum io::PictureFormat::Depth;
    picture.depth = picture.page ? Bits8 : chosenValue<io::PictureFormat::Depth>(m_depth);
    if (!io::takes(picture.file, picture.depth)) picture.depth = picture.depth == Bits8 ? Bits16 : Bits8;
    picture.dotsPerInch = m_size->dotsPerInch();
    return picture;
}

void SpaceExportDialog::showPreview() {
    m_preview->setVisible(pictureFile().has_value());
    if (!pictureFile()) return;
    m_preview->show(m_size->pixels(), [recipe = *recipe(), fractal = m_fractal](const QSize& pixels,
                                                                                const std::stop_token& stop) {
        return io::previewOf(recipe, fractal, pixels, stop);
    });
}

void SpaceExportDialog::update() {
    showPreview();
    check();
    const auto file = pictureFile();
    const bool isPicture = file.has_value();
    using enum io::PictureFormat::Depth;
    const bool hasDepths = file && !page() && io::takes(*file, Bits8) && io::takes(*file, Bits16);
    const bool isDepth = m_fractal.inSpace.look == attractor::LookInSpace::Depth;
    const bool isNumbers = isDepth || m_fractal.inSpace.look == attractor::LookInSpace::Normals;
    m_form->setRowVisible(m_section, isPicture);
    m_form->setRowVisible(m_size, isPicture);
    m_form->setRowVisible(m_supersample,
                          isPicture && !isNumbers && !attractor::showsCloud(m_fractal.inSpace.look));
    m_form->setRowVisible(m_depth, hasDepths && !isDepth);
    m_form->setRowVisible(m_transparent, isPicture && !isNumbers && io::factsOf(*file).canBeTransparent);
    m_form->setRowVisible(m_stereo, isPicture && !isNumbers);
    m_form->setRowVisible(m_cage, isPicture && !isNumbers);
    m_cage->setEnabled(chosenValue<io::Stereo>(m_stereo) == io::Stereo::None);
    for (QWidget* row : std::initializer_list<QWidget*>{m_longest, m_resolution, m_wall, m_fill})
        m_form->setRowVisible(row, isBody());
}

void SpaceExportDialog::check() {
    m_obstacle = obstacle();
    enableButtons();
    QString sentence = m_obstacle      ? *m_obstacle
                       : page()        ? tr("A solid has no shapes: the file contains its picture in pixels.")
                       : pictureFile() ? QString()
                       : isBody()      ? tr("A closed surface around the attractor, for a printer.")
                                       : tr("One multmatrix for each map; open it in OpenSCAD to render it.");
    if (!pictureFile() && !m_obstacle && m_fractal.inSpace.clip)
        sentence += u' ' + tr("The whole solid is written, not only the slice.");
    say(sentence);
}

io::Failure SpaceExportDialog::obstacle() const {
    if (isBody())
        return io::obstacleToSolid(m_fractal,
                                   io::exportOf(std::get<io::BodyRecipe>(*recipe()), m_fractal).options);
    if (!pictureFile()) return io::obstacleToSolid(m_fractal);
    if (m_fractal.inSpace.look == attractor::LookInSpace::Depth &&
        (pictureFile() != io::PictureFile::Png || page()))
        return tr("Depths can be written only as PNG.");
    return std::nullopt;
}

QString SpaceExportDialog::chosenFile() {
    if (pictureFile() && !confirmLargeExport(this, m_size->pixels(), 0)) return {};
    const QString path = chooseFile({.title = tr("Export"), .suffix = suffix()});
    if (path.isEmpty() || !takeFormat(path)) return {};
    remember({suffix(), m_size->choice(), bodyText()}, path);
    return path;
}

bool SpaceExportDialog::takeFormat(const QString& path) {
    const auto format = formatOf(QFileInfo(path).suffix().toLower());
    if (format)
        setFormat(*format);
    else
        say(tr("The name “%1” does not determine the format. It must end with one of these: %2.")
                .arg(QFileInfo(path).fileName(), endings()));
    return format.has_value();
}

std::optional<io::ExportRecipe> SpaceExportDialog::recipeFor(const QString& path) {
    return takeFormat(path) && isPossible() ? recipe() : std::nullopt;
}

void SpaceExportDialog::exportTo(const QString& path) {
    if (!takeFormat(path) || !isPossible()) return;
    m_summary = std::make_shared<QString>();
    if (std::holds_alternative<OpenScad>(format())) {
        const io::OpenScad program = io::openScad(m_fractal);
        return program.failure ? finish({program.failure}, path) : writeText(program.text, path);
    }
    io::Export what = io::exportOf(*recipe(), m_fractal);
    if (auto* body = std::get_if<io::SolidExport>(&what))
        body->whenMade = [summary = m_summary, options = body->options](const io::SolidFacts& facts) {
            *summary = io::summaryOf(facts, options);
        };
    start(std::move(what), path);
}

QString SpaceExportDialog::sentenceFor(const io::ExportOutcome& outcome, const QString& path) const {
    const QString sentence = ExportShell::sentenceFor(outcome, path);
    const bool isWritten = !outcome.stopped && !outcome.failure;
    return isWritten && !m_summary->isEmpty() ? sentence + u'\n' + *m_summary : sentence;
}

} // namespace view
