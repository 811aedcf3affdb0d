// SPDX-License-Identifier: MIT
#include "dialogs/variations/mutate_dialog.h"

#include "dialogs/variations/sheet_maker.h"
#include "document/edits/maps/map_locks.h"
#include "widgets/choices.h"
#include "widgets/layout/vertical_scroll_area.h"
#include "widgets/numbers/number_box.h"
#include "widgets/text/tooltip_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

namespace view {

namespace {

constexpr int smallSide = 56; // pixels of a picture of the line
constexpr int strengthSteps = 100;
constexpr int controlsWidth = 230;
constexpr quint64 partnerKey = quint64{1} << 40;

bool areAllLocked(const document::Fractal& fractal) {
    const document::System2* plane = document::system2(fractal);
    const document::System3* space = document::system3(fractal);
    const std::size_t count = plane ? plane->maps.size() : space ? space->maps.size() : 0;
    return count > 0 && document::lockedMaps(fractal).size() == count;
}

} // namespace

MutateDialog::MutateDialog(document::Document* document, QWidget* parent)
    : MutateDialog(document, parent, Descent()) {}

MutateDialog::MutateDialog(document::Document* document, QWidget* parent, const Descent& left)
    : QDialog(parent),
      m_document(document),
      m_line{{document->sharedFractal(), 1, {}}},
      m_sheet(new SheetMaker(count, this)),
      m_large(new Thumbnails(this)),
      m_small(new Thumbnails(this)),
      m_ring(new VariationRing(this)) {
    setWindowTitle(tr("Variations of “%1”").arg(titleText(middle()->name)));
    m_small->setSize(smallSide, devicePixelRatioF());
    m_ring->setAccessibleName(tr("Variations"));
    m_ring->setWhatsThis(tr("Around the picture in the middle are its variations. Click one, or press Enter "
                            "on it, to put it in the "
                            "middle. Double-click one to use it at once."));
    auto* columns = new QHBoxLayout;
    columns->addLayout(createLine());
    columns->addWidget(m_ring, 1);
    columns->addSpacing(6);
    auto* controls = new QWidget(this);
    controls->setLayout(createControls());
    controls->layout()->setContentsMargins({});
    columns->addWidget(new VerticalScrollArea(controls, this)); // scrolls, since large fonts need more height
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_use = buttons->addButton(tr("&Use This One"), QDialogButtonBox::AcceptRole);
    m_use->setObjectName(QStringLiteral("use"));
    m_use->setWhatsThis(
        tr("The fractal in the middle replaces the one that you began with, in one step that you "
           "can undo."));
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(columns, 1);
    layout->addWidget(buttons);
    m_resized.setSingleShot(true);
    m_resized.setInterval(resizePause);
    connect(buttons, &QDialogButtonBox::accepted, this, &MutateDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &MutateDialog::reject);
    connect(m_ring, &VariationRing::chosen, this, &MutateDialog::take);
    connect(m_ring, &VariationRing::used, this, &MutateDialog::accept);
    connect(m_ring, &VariationRing::resized, &m_resized, qOverload<>(&QTimer::start));
    connect(&m_resized, &QTimer::timeout, this, &MutateDialog::redraw);
    connect(m_sheet, &SheetMaker::made, this, &MutateDialog::showChild);
    connect(m_sheet, &SheetMaker::drawn, this, &MutateDialog::showChild);
    connect(m_large, &Thumbnails::ready, this, &MutateDialog::showParent);
    connect(m_small, &Thumbnails::ready, this, &MutateDialog::showLine);
    startFrom(left);
    redraw();
    makeSheet();
    m_ring->setFocus();
}

MutateDialog::~MutateDialog() = default;

QLayout* MutateDialog::createLine() {
    m_descent = new QListWidget(this);
    m_descent->setAccessibleName(tr("Line of descent"));
    m_descent->setWhatsThis(tr("Every parent so far, the oldest at the top. Select one to go back to it. Its "
                               "descendants stay in the list until you choose another child of it."));
    m_descent->setIconSize({smallSide, smallSide});
    m_descent->setSpacing(2);
    m_descent->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_descent->setMinimumWidth(smallSide + fontMetrics().horizontalAdvance(tr("Original")) + 48);
    m_descent->setMaximumWidth(m_descent->minimumWidth());
    auto* label = new QLabel(tr("Line of &descent"), this);
    label->setBuddy(m_descent);
    connect(m_descent, &QListWidget::currentRowChanged, this, &MutateDialog::goTo);
    auto* layout = new QVBoxLayout;
    layout->addWidget(label);
    layout->addWidget(m_descent, 1);
    return layout;
}

QLayout* MutateDialog::createControls() {
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setRowWrapPolicy(QFormLayout::WrapAllRows);
    addChanges(form);
    m_strength = new QSlider(Qt::Horizontal, this);
    m_strength->setRange(2, strengthSteps);
    m_strength->setValue(30);
    m_strength->setAccessibleName(tr("How strongly the variations differ"));
    m_strength->setToolTip(tr("How far the variations are from their parent"));
    m_strength->setWhatsThis(
        tr("On the left, the variations stay close to their parent; on the right, they differ greatly."));
    connect(m_strength, &QSlider::valueChanged, this, &MutateDialog::makeSheet);
    form->addRow(tr("S&trength:"), m_strength);
    addPartners(form);
    addSeed(form);
    m_hint = new QLabel(this);
    m_hint->setWordWrap(true);
    m_hint->setMinimumWidth(controlsWidth);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    auto* layout = new QVBoxLayout;
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(m_hint);
    return layout;
}

void MutateDialog::addChanges(QFormLayout* form) {
    const auto add = [this](const QString& text, const QString& tip, const QString& whatsThis, bool on) {
        auto* box = new QCheckBox(text, this);
        box->setToolTip(tip);
        box->setWhatsThis(whatsThis);
        box->setChecked(on);
        connect(box, &QCheckBox::toggled, this, &MutateDialog::makeSheet);
        return box;
    };
    m_shape =
        add(tr("Sha&pe"), tr("Turn, stretch and move the maps"),
            tr("The maps are turned, stretched and moved, and occasionally one is added or removed. Locked "
               "maps, and maps that are off, stay as they are."),
            true);
    m_colours = add(tr("C&olour"), tr("Try other colours"),
                    tr("The hues of the palette, the plain colour and the colours of the maps change. The "
                       "background and the meaning of the colours stay the same."),
                    false);
    m_weights =
        add(tr("&Weights"), tr("Make some maps denser and others fainter"),
            tr("The weights change at random and follow the sizes of the maps. Otherwise, each map keeps its "
               "weight. A solid in space does not depend on weights; a cloud does."),
            true);
    m_shape->setObjectName(QStringLiteral("shape"));
    m_colours->setObjectName(QStringLiteral("colour"));
    m_weights->setObjectName(QStringLiteral("weights"));
    auto* boxes = new QVBoxLayout;
    for (QCheckBox* box : {m_shape, m_colours, m_weights})
        boxes->addWidget(box);
    form->addRow(tr("What may change:"), boxes);
}

void MutateDialog::addPartners(QFormLayout* form) {
    m_partner = new QComboBox(this);
    m_partner->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    addChoice(m_partner, tr("Nothing"), FractalPointer());
    for (const document::Entry& entry : m_document->file().entries) {
        if (entry.id == m_document->currentId() ||
            document::dimension(*entry.fractal) != document::dimension(*middle()))
            continue;
        addChoice(m_partner, entry.fractal->name, entry.fractal);
    }
    const bool hasOthers = m_partner->count() > 1;
    m_partner->setEnabled(hasOthers);
    m_partner->setToolTip(!hasOthers ? tr("This file has no other fractal of this dimension.")
                                     : tr("Mix the parent with another entry of this file"));
    m_partner->setWhatsThis(
        tr("The variations take some maps from the parent, some from the other entry, and some that are "
           "halfway between two corresponding maps. The checkboxes above determine whether shape, colour and "
           "weights are mixed. Every child has an attractor."));
    m_partnerPicture = new QLabel(this);
    m_partnerPicture->setFixedSize(smallSide, smallSide);
    m_partnerPicture->hide();
    auto* field = new QVBoxLayout;
    field->addWidget(m_partner);
    field->addWidget(m_partnerPicture, 0, Qt::AlignLeft);
    auto* label = new QLabel(tr("C&ross with:"), this);
    label->setBuddy(m_partner);
    form->addRow(label, field);
    connect(m_partner, &QComboBox::currentIndexChanged, this, [this] {
        showPartner();
        makeSheet();
    });
}

void MutateDialog::addSeed(QFormLayout* form) {
    m_seed = new WholeNumberBox(this);
    m_seed->setRange(1, 999'999);
    m_seed->setAccessibleName(tr("Seed of the random numbers"));
    m_seed->setToolTip(tr("The same seed gives the same sheet again"));
    m_seed->setWhatsThis(
        tr("The number from which the variations are generated. With the same parent, the same settings "
           "and the same seed you get the same sheet again."));
    auto* other = new QPushButton(tr("&New Set"), this);
    other->setToolTip(tr("Show another sheet, from the next seed"));
    other->setWhatsThis(tr("Shows other variations of the same parent, from the next seed."));
    other->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->addWidget(m_seed, 1);
    row->addWidget(other);
    auto* label = new QLabel(tr("&Seed:"), this);
    label->setBuddy(m_seed);
    form->addRow(label, row);
    connect(m_seed, &QSpinBox::valueChanged, this, &MutateDialog::makeSheet);
    connect(other, &QPushButton::clicked, m_seed, &QSpinBox::stepUp);
}

document::Mutation MutateDialog::mutation() const {
    document::Mutation mutation;
    mutation.strength = double(m_strength->value()) / strengthSteps;
    mutation.may = {m_shape->isChecked(), m_colours->isChecked(), m_weights->isChecked()};
    mutation.partner = chosenValue<FractalPointer>(m_partner);
    return mutation;
}

void MutateDialog::makeSheet() {
    m_line[std::size_t(m_generation)].seed = m_seed->value();
    m_sheet->clear();
    for (int child = 0; child < count; ++child)
        m_ring->showChild(child, {}, tr("Variation %1, not ready yet").arg(child + 1));
    if (mutation().may.anything()) {
        const auto prepare = [parent = middle(), mutation = mutation()]() -> SheetMaker::Make {
            const auto variations = std::make_shared<const document::Variations>(parent, mutation);
            return [variations](std::uint64_t seed, const std::stop_token& stop) {
                return variations->of(seed, stop);
            };
        };
        m_sheet->make(prepare, std::uint64_t(m_seed->value()) * count);
    }
    showParent();
    follow();
}

void MutateDialog::take(int child) {
    const FractalPointer chosen = m_sheet->fractal(child);
    if (!chosen) return;
    m_line.resize(std::size_t(m_generation) + 1);
    m_line.push_back({chosen, m_seed->value(), m_sheet->picture(child).pixmap});
    const QSignalBlocker quiet(m_descent);
    while (m_descent->count() > m_generation + 1)
        delete m_descent->takeItem(m_descent->count() - 1);
    addToLine(++m_generation);
    makeSheet();
}

void MutateDialog::goTo(int generation) {
    if (generation < 0 || generation == m_generation) return;
    m_generation = generation;
    const QSignalBlocker quiet(m_seed);
    m_seed->setValue(m_line[std::size_t(generation)].seed);
    makeSheet();
}

void MutateDialog::startFrom(const Descent& left) {
    if (!left.line.empty() && *left.line.front().fractal == *middle()) {
        m_line = left.line;
        m_generation = left.middle;
    }
    for (int generation = 0; generation < int(m_line.size()); ++generation)
        addToLine(generation);
    const QSignalBlocker quiet(m_descent), still(m_seed);
    m_descent->setCurrentRow(m_generation);
    m_seed->setValue(m_line[std::size_t(m_generation)].seed);
}

void MutateDialog::addToLine(int generation) {
    const QSignalBlocker quiet(m_descent);
    m_descent->addItem(generation == 0 ? tr("Original") : QString::number(generation));
    m_descent->setCurrentRow(generation);
    m_descent->item(generation)
        ->setData(Qt::AccessibleTextRole,
                  generation == 0 ? tr("Original") : tr("Generation %1").arg(generation));
    showLine(quint64(generation));
}

void MutateDialog::showChild(int child) {
    if (!m_sheet->fractal(child)) return;
    Thumbnail picture = m_sheet->picture(child);
    if (picture.pixmap.isNull() && picture.state == Thumbnail::State::Pending)
        picture.pixmap = m_ring->childPicture(child); // picture in the previous size
    m_ring->showChild(child, picture, tr("Variation %1").arg(child + 1));
}

// Shows a smaller picture until the large one is drawn.
void MutateDialog::showParent() {
    Thumbnail thumbnail = m_large->thumbnail(quint64(m_generation), middle());
    if (thumbnail.state == Thumbnail::State::Pending)
        thumbnail.pixmap = m_line[std::size_t(m_generation)].seen;
    m_line[std::size_t(m_generation)].seen = thumbnail.pixmap;
    m_ring->showParent(thumbnail, m_generation == 0 ? tr("Parent: the original")
                                                    : tr("Parent: generation %1").arg(m_generation));
}

void MutateDialog::showPartner() {
    const auto partner = chosenValue<FractalPointer>(m_partner);
    m_partnerPicture->setVisible(partner != nullptr);
    if (!partner) return;
    const auto key = partnerKey + quint64(m_partner->currentIndex());
    m_partnerPicture->setPixmap(m_small->thumbnail(key, partner).pixmap);
}

void MutateDialog::showLine(quint64 key) {
    if (key >= partnerKey) return showPartner();
    const int generation = int(key);
    if (generation >= m_descent->count()) return;
    const Thumbnail thumbnail = m_small->thumbnail(key, m_line[key].fractal);
    QIcon icon(thumbnail.pixmap);
    icon.addPixmap(thumbnail.pixmap, QIcon::Selected); // own colours, without highlight
    m_descent->item(generation)->setIcon(icon);
}

void MutateDialog::redraw() {
    m_sheet->setSide(m_ring->childSide(), devicePixelRatioF());
    m_large->setSize(m_ring->parentSide(), devicePixelRatioF());
    for (int child = 0; child < count; ++child)
        showChild(child);
    showParent();
}

void MutateDialog::follow() {
    m_use->setEnabled(m_generation > 0);
    const document::Mutation wanted = mutation();
    if (!wanted.may.anything())
        m_hint->setText(
            tr("Nothing may change, so there are no variations. Tick at least one of the checkboxes."));
    else if (areAllLocked(*middle()) && !wanted.partner)
        m_hint->setText(tr("All maps are locked and keep their weights: the variations differ only in "
                           "colours and, occasionally, in an added map. Many look like their parent."));
    else
        m_hint->setText(tr("Click a picture to put it in the middle, with variations of its own around it."));
}

void MutateDialog::accept() {
    if (m_generation == 0) return;
    m_document->edit(tr("Use a variation"), *middle());
    QDialog::accept();
}

} // namespace view
