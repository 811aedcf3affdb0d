// SPDX-License-Identifier: MIT
#include "panels/collage/target_box.h"

#include "collage/measure/agreement.h"
#include "document/edits/collage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "io/file/save_file.h"
#include "io/picture/decoding/grey_picture.h"
#include "panels/collage/target_preview.h"
#include "widgets/choices.h"
#include "widgets/file_dialogs.h"
#include "widgets/menus/menu_button.h"
#include "widgets/menus/menu_text.h"
#include "widgets/text/tooltip_text.h"

#include <QAction>
#include <QBuffer>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <utility>

namespace view {

namespace {

constexpr int entrySide = 448;  // pixels along the longer side of a traced attractor
constexpr int entryMargin = 16; // pixels around it
constexpr int usualOpacity = 40;

using Shape = document::TraceOptions::Shape;

QToolButton* button(const QString& text, const QString& tip, QWidget* parent) {
    auto* made = new QToolButton(parent);
    made->setText(text);
    made->setToolTip(tip);
    return made;
}

// The attractor, dark on light; null with a sentence.
std::shared_ptr<const collage::GreyPicture> pictureOf(const document::Fractal& fractal, QString& sentence) {
    const auto box = document::displayedBox(fractal);
    const auto shown = document::effectiveSystem(fractal);
    // Includes the maps that a symmetry stands for.
    const auto maps = shown ? ifs::activeMaps(*shown) : ifs::ActiveMaps<2>{};
    if (!box || maps.maps.empty() || maps.isLinked() || collage::contraction(maps.maps) >= 1) {
        sentence = document::collageObstacle(fractal);
        if (sentence.isEmpty()) sentence = TargetBox::tr("Only maps that contract give a shape to trace.");
        return nullptr;
    }
    const ifs::Vector<2> size = box->max - box->min;
    collage::Grid grid;
    grid.cell = size.maxCoeff() / entrySide;
    if (!(grid.cell > 0)) {
        sentence = TargetBox::tr("The attractor is a single point.");
        return nullptr;
    }
    grid.left = box->min.x() - entryMargin * grid.cell;
    grid.top = box->max.y() + entryMargin * grid.cell;
    grid.width = int(size.x() / grid.cell) + 2 * entryMargin + 1;
    grid.height = int(size.y() / grid.cell) + 2 * entryMargin + 1;
    const collage::Mask mask = collage::attractorMask(grid, maps.maps);
    auto picture = std::make_shared<collage::GreyPicture>();
    picture->width = mask.width;
    picture->height = mask.height;
    for (const std::uint8_t cell : mask.cells)
        picture->grey.push_back(cell != 0 ? 0 : 255);
    picture->opacity.assign(mask.cells.size(), 255);
    return picture;
}

// The file of a picture, to be asked for in the background; nullptr without one. What another program offers
// is not decoded here: that may take all memory, or minutes.
std::function<QByteArray()> pictureIn(const QMimeData& data) {
    for (const char* kind : {"png", "bmp", "tiff", "webp", "jpeg", "gif"}) {
        const QString type = QStringLiteral("image/") + QLatin1String(kind);
        if (data.hasFormat(type)) return [bytes = data.data(type)] { return bytes; };
    }
    // Checks first, because asking for an image makes Qt decode data of other programs.
    if (data.inherits("QInternalMimeData") || !data.hasImage()) return nullptr;
    return [image = qvariant_cast<QImage>(data.imageData())] {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        image.save(&buffer, "PNG");
        return bytes;
    };
}

} // namespace

TargetBox::TargetBox(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_shown(document->currentId()),
      m_reading([this](std::optional<Read> read) { finishReading(std::move(read)); }, io::Lane::Reading),
      m_tracing([this](std::optional<TracedPointer> traced) { show(traced ? *traced : nullptr); }) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    createSources();
    m_name = new QLabel(this);
    m_name->setWordWrap(true);
    m_name->setTextFormat(Qt::PlainText);
    m_name->setAccessibleName(tr("Target"));
    layout->addWidget(m_name);
    m_preview = new TargetPreview(this);
    layout->addWidget(m_preview);
    createControls();
    connect(m_preview, &TargetPreview::cropChosen, this,
            [this](const std::optional<collage::PixelBox>& crop) {
                setOptions([&](document::TraceOptions& options) { options.crop = crop; });
            });
    connect(document, &document::Document::changed, this, &TargetBox::follow);
    showState();
}

TargetBox::~TargetBox() = default;

void TargetBox::createSources() {
    auto* row = new QHBoxLayout;
    auto* choose = new MenuButton(this);
    choose->setText(tr("Choose"));
    choose->setToolTip(tr("Choose the picture that the fractal should look like"));
    choose->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(choose);
    menu->addAction(tr("Picture…"), this, &TargetBox::choose);
    QMenu* entries = menu->addMenu(tr("Entry of This File"));
    connect(entries, &QMenu::aboutToShow, this, [this, entries] { fillEntries(entries); });
    choose->setMenu(menu);
    row->addWidget(choose);
    QToolButton* paste = button(tr("Paste"), tr("Use the picture on the clipboard"), this);
    connect(paste, &QToolButton::clicked, this, &TargetBox::paste);
    row->addWidget(paste);
    m_remove = button(tr("Remove"), tr("Remove the target and work without one"), this);
    connect(m_remove, &QToolButton::clicked, this, &TargetBox::remove);
    row->addWidget(m_remove);
    row->addStretch();
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void TargetBox::createControls() {
    m_controls = new QWidget(this);
    auto* grid = new QGridLayout(m_controls);
    grid->setContentsMargins(0, 0, 0, 0);
    createShape(*grid);
    auto* crops = new QHBoxLayout;
    m_toShape = button(tr("Crop to Shape"), tr("Use only the part around the shape"), m_controls);
    m_whole = button(tr("Whole Picture"), tr("Use the whole picture again"), m_controls);
    crops->addWidget(m_toShape);
    crops->addWidget(m_whole);
    crops->addStretch();
    grid->addLayout(crops, 3, 0, 1, 3);
    auto* note = new QLabel(tr("The target is not saved with the file. It is kept while the file is open."),
                            m_controls);
    note->setWordWrap(true);
    note->setForegroundRole(QPalette::PlaceholderText);
    grid->addWidget(note, 4, 0, 1, 3);
    layout()->addWidget(m_controls);
    connectControls();
}

void TargetBox::createShape(QGridLayout& grid) {
    grid.setColumnStretch(1, 1);
    const auto add = [&](int row, const QString& text, QWidget* field) {
        auto* label = new QLabel(text, m_controls);
        label->setBuddy(field);
        grid.addWidget(label, row, 0);
        grid.addWidget(field, row, 1);
    };
    m_shape = new QComboBox(m_controls);
    addChoice(m_shape, tr("Automatic"), Shape::Automatic);
    addChoice(m_shape, tr("Dark pixels"), Shape::Dark);
    addChoice(m_shape, tr("Opaque pixels"), Shape::Opaque);
    m_shape->setAccessibleName(tr("Shape"));
    m_shape->setToolTip(tr("Which pixels belong to the shape"));
    m_shape->setWhatsThis(
        tr("Which pixels belong to the shape. Automatic takes the opaque pixels if any part "
           "of the picture is transparent, otherwise the dark ones."));
    add(0, tr("Shape:"), m_shape);
    m_inverted = new QCheckBox(tr("Invert"), m_controls);
    m_inverted->setToolTip(tr("Trace the background instead"));
    grid.addWidget(m_inverted, 0, 2);
    m_threshold = new QSlider(Qt::Horizontal, m_controls);
    m_threshold->setRange(0, 255);
    m_threshold->setAccessibleName(tr("Threshold"));
    m_threshold->setToolTip(tr("The shade up to which a pixel belongs to the shape"));
    add(1, tr("Threshold:"), m_threshold);
    m_automatic = new QCheckBox(tr("Automatic"), m_controls);
    m_automatic->setAccessibleName(tr("Automatic threshold"));
    m_automatic->setToolTip(tr("Find the threshold that best separates dark from light (Otsu)"));
    grid.addWidget(m_automatic, 1, 2);
    m_opacity = new QSlider(Qt::Horizontal, m_controls);
    m_opacity->setRange(0, 100);
    m_opacity->setValue(usualOpacity);
    m_opacity->setAccessibleName(tr("Opacity of the target"));
    m_opacity->setToolTip(tr("How strongly the target is shown on the canvas"));
    add(2, tr("Opacity:"), m_opacity);
}

void TargetBox::connectControls() {
    connect(m_shape, &QComboBox::currentIndexChanged, this,
            [this] { setOptions([&](auto& options) { options.shape = chosenValue<Shape>(m_shape); }); });
    connect(m_inverted, &QCheckBox::toggled, this, [this](bool on) {
        setOptions([&](auto& options) {
            options.polarity = on ? collage::Polarity::Background : collage::Polarity::Shape;
        });
    });
    connect(m_threshold, &QSlider::valueChanged, this,
            [this](int value) { setOptions([&](auto& options) { options.threshold = value; }); });
    connect(m_automatic, &QCheckBox::toggled, this, [this](bool on) {
        setOptions([&](auto& options) {
            options.threshold = on ? std::nullopt : std::optional(m_threshold->value());
        });
    });
    connect(m_opacity, &QSlider::valueChanged, this, &TargetBox::opacityChanged);
    connect(m_whole, &QToolButton::clicked, this,
            [this] { setOptions([](auto& options) { options.crop.reset(); }); });
    connect(m_toShape, &QToolButton::clicked, this, [this] {
        if (!m_traced) return;
        collage::PixelBox box = collage::boxOf(m_traced->mask);
        setOptions([&](document::TraceOptions& options) {
            const auto before = options.crop.value_or(collage::PixelBox{});
            options.crop = {before.left + box.left, before.top + box.top, before.left + box.right,
                            before.top + box.bottom};
        });
    });
}

void TargetBox::fillEntries(QMenu* menu) {
    menu->clear();
    for (const document::Entry& entry : m_document->file().entries) {
        if (document::dimension(*entry.fractal) != 2) continue;
        const QString& name = entry.fractal->name;
        QAction* action = menu->addAction(menuText(name, menu->fontMetrics()), this,
                                          [this, fractal = entry.fractal] { take(fractal); });
        action->setToolTip(tooltipText(name)); // plain text, since the default may look like markup
    }
    menu->setDisabled(menu->isEmpty());
}

void TargetBox::choose() {
    const QString path = choosePictureToOpen(this, tr("Choose a Picture"));
    if (!path.isEmpty()) read(path);
}

void TargetBox::paste() {
    const QMimeData* offered = QGuiApplication::clipboard()->mimeData();
    std::function<QByteArray()> picture = offered == nullptr ? nullptr : pictureIn(*offered);
    if (!picture) {
        m_name->setText(tr("There is no picture on the clipboard."));
        return;
    }
    submit(
        [picture = std::move(picture)](const std::stop_token& stop) {
            State state;
            const io::LoadedGrey grey = io::readGreyPicture(picture(), stop);
            keep(grey, state);
            return state;
        },
        tr("Pasted picture"));
}

void TargetBox::keep(const io::LoadedGrey& grey, State& state) {
    if (grey.flaw) {
        state.sentence = *grey.flaw;
        return;
    }
    state.picture = std::make_shared<const collage::GreyPicture>(document::reducedForTracing(grey.picture));
    state.isReduced = grey.isReduced || state.picture->width < grey.picture.width;
}

void TargetBox::read(const QString& path) {
    submit(
        [path](const std::stop_token& stop) {
            State state;
            const io::Loaded loaded = io::loadFile(path);
            if (loaded.failure) {
                state.sentence = *loaded.failure;
                return state;
            }
            const io::LoadedGrey grey = io::readGreyPicture(loaded.bytes, stop);
            keep(grey, state);
            return state;
        },
        QFileInfo(path).fileName());
}

void TargetBox::take(const std::shared_ptr<const document::Fractal>& entry) {
    submit(
        [entry](const std::stop_token& /*stop*/) {
            State state;
            state.picture = pictureOf(*entry, state.sentence);
            return state;
        },
        entry->name);
}

bool TargetBox::State::isTracedAs(const State& other) const {
    const auto isAlike = [](const std::optional<document::Box>& a, const std::optional<document::Box>& b) {
        return a.has_value() == b.has_value() && (!a || (a->min == b->min && a->max == b->max));
    };
    return picture && picture == other.picture && options == other.options && isAlike(onto, other.onto);
}

QString TargetBox::name() const {
    return m_states.value(m_document->currentId()).name;
}

bool TargetBox::hasTargets() const {
    return std::any_of(m_states.cbegin(), m_states.cend(),
                       [](const State& state) { return state.picture != nullptr; });
}

void TargetBox::remove() {
    m_reading.cancel();
    m_states.remove(m_document->currentId());
    showState();
}

void TargetBox::submit(const std::function<State(const std::stop_token&)>& reading, const QString& name) {
    m_name->setText(tr("Reading “%1”…").arg(name));
    m_reading.submit([reading, name, entry = m_document->currentId(),
                      fractal = m_document->sharedFractal()](const std::stop_token& stop) {
        Read read{entry, reading(stop)};
        read.state.name = name;
        read.state.onto = document::displayedBox(*fractal);
        return std::optional(std::move(read));
    });
}

void TargetBox::finishReading(std::optional<Read> read) {
    if (read && read->state.picture)
        m_states[read->entry] = read->state;
    else if (read) // keeps the previous picture
        m_states[read->entry].sentence = QStringLiteral("%1: %2").arg(read->state.name, read->state.sentence);
    else
        state().sentence = tr("The picture could not be read.");
    showState();
}

void TargetBox::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & Change::File) {
        m_reading.cancel();
        m_states.clear();
    }
    if (!(change.parts & (Change::Current | Change::File))) return;
    const document::EntryId before = std::exchange(m_shown, m_document->currentId());
    const bool isSame = m_traced && m_states.value(before).isTracedAs(m_states.value(m_shown));
    if (isSame) return; // suggestion used in an entry of its own
    m_tracing.cancel(); // traces the picture of another entry
    m_traced = nullptr; // result for another entry
    showState();
}

void TargetBox::setOptions(const std::function<void(document::TraceOptions&)>& change) {
    if (!state().picture) return;
    state().sentence.clear(); // about another picture
    change(state().options);
    showState();
}

void TargetBox::showState() {
    const State now = m_states.value(m_document->currentId());
    const document::TraceOptions& options = now.options;
    m_controls->setVisible(now.picture != nullptr);
    m_remove->setEnabled(now.picture != nullptr);
    m_name->setText(
        !now.sentence.isEmpty() ? now.sentence
        : now.picture
            ? (now.isReduced ? tr("%1, reduced to %2 × %3 pixels") : tr("%1, %2 × %3 pixels"))
                  .arg(now.name, QString::number(now.picture->width), QString::number(now.picture->height))
            : tr("Choose, paste or drop a picture on the window."));
    m_preview->setPicture(now.picture);
    if (!now.picture) {
        m_tracing.cancel();
        show(nullptr);
        return;
    }
    const QSignalBlocker shape(m_shape), inverted(m_inverted), threshold(m_threshold), automatic(m_automatic);
    m_shape->setCurrentIndex(int(options.shape));
    m_inverted->setChecked(options.polarity == collage::Polarity::Background);
    m_automatic->setChecked(!options.threshold);
    m_threshold->setValue(document::thresholdOf(*now.picture, options).value_or(127));
    m_whole->setEnabled(options.crop.has_value());
    trace();
}

void TargetBox::trace() {
    const State& now = state();
    m_tracing.submit([picture = now.picture, options = now.options,
                      onto = now.onto](const std::stop_token&) -> std::optional<TracedPointer> {
        auto traced = document::tracedPicture(*picture, options, onto);
        if (!traced) return std::nullopt;
        return std::make_shared<const document::TracedPicture>(*std::move(traced));
    });
}

void TargetBox::show(TracedPointer traced) {
    m_traced = std::move(traced);
    const State now = m_states.value(m_document->currentId());
    if (m_traced)
        m_preview->setShape(m_traced->mask, now.options.crop);
    else if (now.picture)
        m_name->setText(tr("With these settings, the shape is empty or fills the picture."));
    m_toShape->setEnabled(m_traced != nullptr);
    emit tracedChanged();
}

} // namespace view
