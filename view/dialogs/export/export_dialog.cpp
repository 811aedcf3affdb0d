// SPDX-License-Identifier: MIT
#include "dialogs/export/export_dialog.h"

#include "dialogs/export/export_camera.h"
#include "dialogs/export/export_preview.h"
#include "dialogs/export/export_size_editor.h"
#include "dialogs/export/large_export.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "document/text/text.h"
#include "ifs/copies/copy_hierarchy.h"
#include "io/file/background.h"
#include "io/picture/picture_writers.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_text.h"
#include "widgets/text/tooltip_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <variant>

namespace view {

namespace {

constexpr int maxFirstWidth = 780; // pixels of the dialog; fits the smallest screens

struct Kind {
    ExportDialog::File file;
    const char* title;    // for Text::tr()
    QStringList suffixes; // default first
};

QList<Kind> kinds() {
    QList<Kind> all;
    for (const io::PictureFileFacts& facts : io::pictureFiles()) {
        if (!facts.inPlane) continue;
        QStringList suffixes;
        for (const char* suffix : facts.suffixes)
            suffixes << QLatin1String(suffix);
        all << Kind{facts.file, facts.inPlane, suffixes};
    }
    for (const auto& [file, suffix] : ifs::names<io::ShapeFile>)
        all << Kind{file, io::titlesOf(file).inPlane, {QLatin1String(suffix)}};
    return all;
}

std::optional<Kind> kindOf(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    for (const Kind& kind : kinds())
        if (kind.suffixes.contains(suffix)) return kind;
    return std::nullopt;
}

// Pixels as they are, or in millimetres on paper.
QString lengthOf(double pixels, const ExportSizeEditor& size) {
    return size.isOnPaper() ? ExportDialog::tr("%1 mm").arg(25.4 * pixels / size.dotsPerInch(), 0, 'f', 3)
                            : ExportDialog::tr("%1 px").arg(pixels, 0, 'f', 2);
}

// A maker measures the shape, not the page around it. Empty where its box is not known or not all of it is
// on the page.
QString sizeOfShape(const document::Fractal& fractal, const attractor::Camera& camera,
                    const ExportSizeEditor& size) {
    const auto box = camera.rotation == 0 ? document::displayedBox(fractal) : std::nullopt;
    if (!box) return {};
    const ifs::Vector<2> page = ifs::Vector<2>(camera.width, camera.height) / camera.pixelsPerUnit;
    const ifs::Vector<2> low = camera.centre - page / 2, high = camera.centre + page / 2;
    if ((box->min.array() < low.array()).any() || (box->max.array() > high.array()).any()) return {};
    const ifs::Vector<2> pixels = camera.pixelsPerUnit * (box->max - box->min);
    return ExportDialog::tr("The shape itself measures %1 × %2.")
        .arg(lengthOf(pixels.x(), size), lengthOf(pixels.y(), size));
}

} // namespace

ExportDialog::ExportDialog(document::Document* document, const attractor::Camera& camera, QWidget* parent)
    : ExportShell(QStringLiteral("picture"), document->fractal().name, parent),
      m_fractal(document->fractal()),
      m_camera(camera),
      m_views(document::savedViews(m_fractal)) {
    setWindowTitle(tr("Export “%1”").arg(titleText(m_fractal.name)));
    m_options = new QWidget(this);
    m_preview = new ExportPreview(this);
    createFormat();
    lay(m_options, m_preview, Qt::Horizontal);
    setStartHelp(tr("Asks for a file name and writes the file. You can keep working in the meantime."));
    if (document::animationFacts(document->entryFractal())) addAnimationButton();
    addQueueButton(tr("Asks for a file name and adds the picture to the queue in the Exports panel. "
                      "The queue continues after a restart."));
    m_planTimer.setSingleShot(true);
    m_planTimer.setInterval(150);
    connect(&m_planTimer, &QTimer::timeout, this, &ExportDialog::updateSvgPlan);
    connect(&m_planning, &QFutureWatcherBase::finished, this, &ExportDialog::showSvgPlan);
    connectOptions();
    connect(&m_extent, &QFutureWatcherBase::finished, this, &ExportDialog::update);
    m_extent.setFuture(io::inBackground<std::optional<document::Box>>(
        [fractal = m_fractal, yAxis = m_camera.yAxis](QPromise<std::optional<document::Box>>& promise) {
            promise.addResult(document::boxWithShadow(fractal, yAxis));
        }));
    update();
    resize(sizeHint().boundedTo({maxFirstWidth, QWIDGETSIZE_MAX}));
}

ExportDialog::~ExportDialog() = default;

void ExportDialog::createFormat() {
    m_format = new QComboBox(m_options);
    for (const Kind& kind : kinds())
        addChoice(m_format, Text::tr(kind.title), kind.file);
    m_format->setAccessibleName(tr("Format"));
    m_format->setWhatsThis(
        tr("SVG and PDF are made of shapes, which stay sharp at every size; the others are made of pixels. "
           "If the file name has the ending of another format, that format is written."));
    const double ratio = devicePixelRatioF(); // resolution of the screen
    m_size = new ExportSizeEditor({std::max(1, int(std::lround(m_camera.width * ratio))),
                                   std::max(1, int(std::lround(m_camera.height * ratio)))},
                                  m_options);
    if (const auto kind = kindOf(QStringLiteral("last.") + last().format)) chooseValue(m_format, kind->file);
    m_size->choose(last().size);
    m_transparent = new QCheckBox(tr("&Transparent background"), m_options);
    m_transparent->setChecked(m_fractal.appearance.background.alpha == 0);
    m_transparent->setWhatsThis(tr("The picture has no background and can be placed over another."));
    m_triangle = new QCheckBox(tr("Include the ca&ge"), m_options);
    m_triangle->setWhatsThis(tr("Draws the cage over the picture."));
    m_form = new QFormLayout(m_options);
    m_form->setContentsMargins({});
    m_section = new QComboBox(m_options);
    addChoice(m_section, tr("The view on the canvas"), Section::View);
    addChoice(m_section, tr("The whole attractor"), Section::Attractor);
    for (int saved = 0; saved < int(m_views.size()); ++saved)
        addChoice(m_section, tr("The view “%1”").arg(m_views[std::size_t(saved)].name), saved);
    m_section->setAccessibleName(tr("Section"));
    m_section->setWhatsThis(tr("What the picture shows: the view on the canvas, or the whole attractor with "
                               "a small margin. Saved views are listed, too."));
    m_form->addRow(tr("&Format:"), m_format);
    m_form->addRow(tr("Sect&ion:"), m_section);
    m_form->addRow(tr("Size:"), m_size);
    setTabOrder(m_format, m_section); // order of their positions
    m_form->addRow(QString(), m_transparent);
    m_form->addRow(QString(), m_triangle);
    createPngOptions();
    createSvgOptions();
}

void ExportDialog::createPngOptions() {
    m_quality = new QComboBox(m_options);
    addChoice(m_quality, tr("Draft: 25 points per pixel"), 25);
    addChoice(m_quality, tr("Good: 100 points per pixel"), 100);
    addChoice(m_quality, tr("Fine: 400 points per pixel"), 400);
    addChoice(m_quality, tr("Finest: 2000 points per pixel"), 2000);
    chooseValue(m_quality, 100);
    m_quality->setAccessibleName(tr("Quality"));
    m_quality->setWhatsThis(tr(
        "The number of points drawn for each pixel: more points make a smoother picture and take longer."));
    m_supersample = new WholeNumberBox(m_options);
    m_supersample->setRange(1, 4);
    m_supersample->setValue(m_fractal.appearance.supersample);
    m_supersample->setAccessibleName(tr("Cells along each side of a pixel"));
    m_supersample->setWhatsThis(tr("The number of smaller cells along each side of a pixel: more cells make "
                                   "smoother edges, at the cost of memory and time."));
    m_depthOfColour = new QComboBox(m_options);
    using Depth = io::PictureFormat::Depth;
    addChoice(m_depthOfColour, tr("8 bits per channel"), Depth::Bits8);
    addChoice(m_depthOfColour, tr("16 bits per channel, for further editing"), Depth::Bits16);
    m_depthOfColour->setAccessibleName(tr("Colour depth"));
    m_depthOfColour->setWhatsThis(
        tr("16 bits keep fine gradations for later editing; 8 bits are enough for viewing."));
    m_memory = new QLabel(m_options);
    m_memory->setAccessibleName(tr("Memory needed"));
    m_form->addRow(tr("&Quality:"), m_quality);
    m_form->addRow(tr("S&upersampling:"), m_supersample);
    m_form->addRow(tr("C&olour depth:"), m_depthOfColour);
    m_form->addRow(tr("Memory:"), m_memory);
}

void ExportDialog::createSvgOptions() {
    m_style = new QComboBox(m_options);
    m_style->setObjectName(QStringLiteral("style"));
    addChoice(m_style, tr("Copies of copies: a small file"), io::ShapeStyle::Structured);
    addChoice(m_style, tr("Outline, for cutters and plotters"), io::ShapeStyle::Outline);
    addChoice(m_style, tr("Points"), io::ShapeStyle::Points);
    m_style->setAccessibleName(tr("Kind of shapes"));
    m_style->setWhatsThis(tr("Copies of copies make a small file that drawing programs can edit; the outline "
                             "is one path; points are dots of the chaos game."));
    m_points = new WholeNumberBox(m_options);
    m_points->setRange(1, int(io::SvgFormat::maxPoints));
    m_points->setValue(int(io::SvgFormat().points));
    m_points->setSingleStep(10'000);
    m_points->setGroupSeparatorShown(true);
    m_points->setAccessibleName(tr("Number of points"));
    m_points->setWhatsThis(tr("How many dots of the chaos game are drawn."));
    m_autoDepth = new QCheckBox(tr("&Automatic depth"), m_options);
    m_autoDepth->setChecked(true);
    m_autoDepth->setWhatsThis(
        tr("Makes the copies smaller until they cannot be distinguished from the attractor at this pixel "
           "size, or until programs would take long to draw them."));
    m_depth = new WholeNumberBox(m_options);
    m_depth->setRange(0, 200);
    m_depth->setAccessibleName(tr("Levels of copies"));
    m_depth->setWhatsThis(tr("The number of levels of copies. More levels hardly enlarge the file, but the "
                             "picture takes longer to draw."));
    m_plan = new QLabel(m_options);
    m_plan->setWordWrap(true);
    m_plan->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_plan->setAccessibleName(tr("Description of the picture"));
    if (const auto style = ifs::named<io::ShapeStyle>(last().more.toStdString()))
        chooseValue(m_style, *style);
    m_form->addRow(tr("S&hapes:"), m_style);
    m_form->addRow(tr("&Points:"), m_points);
    m_form->addRow(tr("&Depth:"), m_depth);
    m_form->addRow(QString(), m_autoDepth);
    m_form->addRow(m_plan);
}

void ExportDialog::connectOptions() {
    connect(m_format, &QComboBox::currentIndexChanged, this, [this] {
        say({}); // message about another file
        update();
    });
    connect(m_section, &QComboBox::currentIndexChanged, this, &ExportDialog::update);
    connect(m_size, &ExportSizeEditor::changed, this, &ExportDialog::update);
    connect(m_supersample, &QSpinBox::valueChanged, this, &ExportDialog::update);
    connect(m_depthOfColour, &QComboBox::currentIndexChanged, this, &ExportDialog::update);
    connect(m_depth, &QSpinBox::valueChanged, this, &ExportDialog::update);
    connect(m_style, &QComboBox::currentIndexChanged, this, &ExportDialog::update);
    connect(m_autoDepth, &QCheckBox::toggled, this, &ExportDialog::update);
    connect(m_transparent, &QCheckBox::toggled, this, &ExportDialog::showPreview);
    connect(m_triangle, &QCheckBox::toggled, this, &ExportDialog::update); // may enlarge the section
    connect(m_quality, &QComboBox::currentIndexChanged, this, &ExportDialog::showPreview);
}

std::optional<io::PictureFile> ExportDialog::pixels() const {
    const auto file = chosenValue<File>(m_format);
    const auto* picture = std::get_if<io::PictureFile>(&file);
    return picture ? std::optional(*picture) : std::nullopt;
}

bool ExportDialog::isSvg() const {
    return !pixels();
}

bool ExportDialog::isTransparent() const {
    return m_transparent->isChecked() && (isSvg() || io::factsOf(*pixels()).canBeTransparent);
}

// The chosen depth, if the format takes it.
io::PictureFormat::Depth ExportDialog::depthOfColour() const {
    using enum io::PictureFormat::Depth;
    const auto chosen = chosenValue<io::PictureFormat::Depth>(m_depthOfColour);
    const io::PictureFile file = pixels().value_or(io::PictureFile::Png);
    if (io::takes(file, chosen)) return chosen;
    return chosen == Bits8 ? Bits16 : Bits8;
}

io::ShapeStyle ExportDialog::style() const {
    return chosenValue<io::ShapeStyle>(m_style);
}

attractor::Camera ExportDialog::camera() const {
    const attractor::Camera camera = resized(m_camera, m_size->pixels());
    if (chosenValue<Section>(m_section) == Section::View) return camera;
    if (const int saved = chosenValue<int>(m_section); saved >= 0)
        return attractor::cameraOf(std::get<attractor::View>(m_views[std::size_t(saved)].camera),
                                   {camera.width, camera.height});
    std::optional<document::Box> box = m_extent.result(); // blocks until found
    if (!box) return camera;
    if (m_triangle->isChecked())
        for (const ifs::Vector<2>& corner : document::effectiveCage(m_fractal).current) {
            box->min = box->min.cwiseMin(corner);
            box->max = box->max.cwiseMax(corner);
        }
    return attractor::fitted(camera, box->min, box->max);
}

io::ExportRecipe ExportDialog::recipe(const attractor::Camera& camera) const {
    const auto cage = m_triangle->isChecked() ? io::CageVisibility::Shown : io::CageVisibility::Hidden;
    if (isSvg()) {
        io::ShapeRecipe shapes;
        shapes.camera = camera;
        shapes.file = std::get<io::ShapeFile>(chosenValue<File>(m_format));
        shapes.style = style();
        if (!m_autoDepth->isChecked()) shapes.depth = m_depth->value();
        shapes.points = m_points->value();
        if (m_size->isOnPaper()) shapes.dotsPerInch = m_size->dotsPerInch();
        shapes.cage = cage;
        shapes.isTransparent = isTransparent();
        return shapes;
    }
    io::PixelRecipe picture;
    picture.camera = camera;
    picture.file = *pixels();
    picture.depth = depthOfColour();
    picture.samplesPerPixel = chosenValue<int>(m_quality);
    picture.supersample = m_supersample->value();
    picture.dotsPerInch = m_size->dotsPerInch();
    picture.cage = cage;
    picture.isTransparent = isTransparent();
    return picture;
}

void ExportDialog::showPreview() {
    const bool isKnown = chosenValue<Section>(m_section) == Section::View || m_extent.future().isFinished();
    if (!isKnown || document::system2(m_fractal) == nullptr)
        return m_preview->show(m_size->pixels(), nullptr);
    m_preview->show(m_size->pixels(), [recipe = recipe(camera()), fractal = m_fractal](
                                          const QSize& pixels, const std::stop_token& stop) {
        return io::previewOf(recipe, fractal, pixels, stop);
    });
}

void ExportDialog::update() {
    m_size->setResolutionVisible(!isSvg());
    m_depth->setEnabled(!m_autoDepth->isChecked());
    enableButtons();
    showPreview();
    if (!isPossible()) say(tr("Only systems in the plane can be exported as a picture."));
    const bool points = style() == io::ShapeStyle::Points;
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_quality, m_supersample, m_depthOfColour, m_memory})
        m_form->setRowVisible(field, !isSvg());
    const auto takes = [this](io::PictureFormat::Depth depth) {
        return pixels() && io::takes(*pixels(), depth);
    };
    m_form->setRowVisible(m_depthOfColour, // visible if there is a choice
                          takes(io::PictureFormat::Depth::Bits8) && takes(io::PictureFormat::Depth::Bits16));
    for (QWidget* field : std::initializer_list<QWidget*>{m_style, m_plan})
        m_form->setRowVisible(field, isSvg());
    m_form->setRowVisible(m_points, isSvg() && points);
    for (QWidget* field : std::initializer_list<QWidget*>{m_depth, m_autoDepth})
        m_form->setRowVisible(field, isSvg() && !points);
    m_transparent->setEnabled(isSvg() ? style() != io::ShapeStyle::Outline
                                      : io::factsOf(*pixels()).canBeTransparent);
    if (isSvg()) {
        m_planTimer.start();
        return;
    }
    m_memory->setText(tr("about %1").arg(QLocale::c().formattedDataSize(qint64(memory()))));
}

// Memory that the picture of pixels takes, in bytes.
std::uint64_t ExportDialog::memory() const {
    const auto pixels = std::get<io::PixelRecipe>(recipe(resized(m_camera, m_size->pixels())));
    return io::memoryFor(io::exportOf(pixels, m_fractal));
}

void ExportDialog::updateSvgPlan() {
    m_isPlanOld = m_planning.isRunning();
    if (!isSvg() || m_isPlanOld || !m_extent.future().isFinished()) return;
    m_planning.setFuture(
        io::inBackground<io::SvgPlan>([svg = io::exportOf(std::get<io::ShapeRecipe>(recipe(camera())),
                                                          m_fractal)](QPromise<io::SvgPlan>& promise) {
            promise.addResult(io::svgPlan(svg.fractal, svg.camera, svg.format));
        }));
    QTimer::singleShot(300, this, [this] {
        if (m_planning.isRunning()) showPlan(tr("Computing the shapes…"));
    });
}

void ExportDialog::showSvgPlan() {
    if (m_isPlanOld) return updateSvgPlan();
    const io::SvgPlan plan = m_planning.result();
    if (plan.failure) {
        showPlan(*plan.failure);
        return;
    }
    m_depth->setMaximum(plan.deepest);
    if (m_autoDepth->isChecked()) {
        const QSignalBlocker quiet(m_depth);
        m_depth->setValue(plan.depth);
    }
    const bool isOutline = style() == io::ShapeStyle::Outline;
    const QString accuracy = lengthOf(plan.errorInPixels, *m_size);
    QStringList sentences;
    if (style() == io::ShapeStyle::Points)
        sentences << tr("One dot for every visible point of the chaos game.");
    else if (isOutline)
        sentences << tr("Guaranteed accuracy: %1.").arg(accuracy)
                  << sizeOfShape(m_fractal, camera(), *m_size);
    else
        sentences << tr("Guaranteed accuracy: %2. Copies drawn by programs that open the file: %1 (the limit "
                        "is %3).")
                         .arg(groupedNumber(double(plan.references)), accuracy,
                              groupedNumber(double(ifs::CopyHierarchy::maxReferences)));
    if (!isOutline && m_fractal.appearance.colourBy == attractor::ColourBy::Density)
        sentences << tr("Shades of density need pixels: the shapes have one colour.");
    if (style() != io::ShapeStyle::Points && plan.isCutShort)
        sentences << tr("More levels would be more accurate, but programs would take long to draw them.");
    if (style() != io::ShapeStyle::Points && plan.unbent)
        sentences << tr("The cage bends the picture, which copies cannot reproduce: the affine fit of the "
                        "cage is written instead. A PNG shows the bend.");
    sentences.removeAll(QString());
    showPlan(sentences.join(QChar::Space));
}

void ExportDialog::showPlan(const QString& text) {
    m_plan->setText(text);
    makeRoomForPlan();
}

// The window grows with it.
void ExportDialog::makeRoomForPlan() {
    const int usual = 3 * m_plan->fontMetrics().lineSpacing(); // rarely exceeded
    m_plan->setMinimumHeight(std::max(usual, m_plan->heightForWidth(m_plan->width())));
}

void ExportDialog::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    makeRoomForPlan();
}

void ExportDialog::setSection(Section section) {
    chooseValue(m_section, section);
}

void ExportDialog::beginAsPoster() {
    chooseValue(m_format, File(io::PictureFile::Png));
    m_size->chooseLargestSheet();
}

void ExportDialog::beginAsOutline() {
    chooseValue(m_format, File(io::ShapeFile::Svg));
    chooseValue(m_style, io::ShapeStyle::Outline);
    m_size->chooseMillimetres();
}

bool ExportDialog::isPossible() const {
    return document::system2(m_fractal) != nullptr;
}

QString ExportDialog::chosenFile() {
    if (!isSvg() && !confirmLargeExport(this, m_size->pixels(), memory())) return {};
    const QList<Kind> allKinds = kinds();
    const QStringList suffixes =
        std::ranges::find(allKinds, chosenValue<File>(m_format), &Kind::file)->suffixes;
    const QString& suffix = suffixes.first();
    const QString filter =
        QStringLiteral("%1 (*.%2)").arg(suffix.toUpper(), suffixes.join(QStringLiteral(" *.")));
    const QString path = chooseFile({.title = tr("Export Picture"), .suffix = suffix, .filter = filter});
    const QString shapes = isSvg() ? QString::fromLatin1(ifs::nameOf(style())) : QString();
    if (const auto kind = kindOf(path)) remember({kind->suffixes.first(), m_size->choice(), shapes}, path);
    return path;
}

bool ExportDialog::takeFormat(const QString& path) {
    const auto kind = kindOf(path);
    if (kind)
        chooseValue(m_format, kind->file);
    else
        say(tr("The name “%1” does not determine the format: it must end with .png, .jpg, .webp, .tiff, "
               ".exr, .svg "
               "or .pdf.")
                .arg(QFileInfo(path).fileName()));
    return kind.has_value();
}

void ExportDialog::exportTo(const QString& path) {
    if (takeFormat(path)) start(io::exportOf(recipe(camera()), m_fractal), path);
}

std::optional<io::ExportRecipe> ExportDialog::recipeFor(const QString& path) {
    return takeFormat(path) ? std::optional(recipe(camera())) : std::nullopt;
}

} // namespace view
