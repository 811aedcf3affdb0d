// SPDX-License-Identifier: MIT
#include "dialogs/variations/random_dialog.h"

#include "dialogs/variations/picture_tiles.h"
#include "dialogs/variations/sheet_maker.h"
#include "document/edits/entries_edits.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_box.h"
#include "widgets/symmetry_groups.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>
#include <utility>

namespace view {

namespace {

constexpr int side = 132; // pixels; least side of a picture
constexpr int cell = side + 2 * PictureTiles::margin;
constexpr int columns = 4;
constexpr int slack = 8; // pixels of a row that keep the last tile from wrapping
constexpr int usualOrder = 5;

} // namespace

RandomDialog::RandomDialog(document::Document* document, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_sheet(new SheetMaker(count, this)),
      m_grid(new QListWidget(this)),
      m_dimension(new QComboBox(this)),
      m_maps(new QComboBox(this)),
      m_groups(new QComboBox(this)),
      m_order(new WholeNumberBox(this)),
      m_seed(new WholeNumberBox(this)) {
    setWindowTitle(tr("Random Fractals"));
    m_sheet->setSide(side, devicePixelRatioF());
    createGrid();
    auto* controls = new QGridLayout;
    createControls(controls);
    addSeed(controls);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_add = buttons->addButton(tr("&Add to the File"), QDialogButtonBox::AcceptRole);
    m_add->setObjectName(QStringLiteral("add"));
    m_add->setWhatsThis(tr("Adds the selected one as an entry of its own, in one step that you can undo."));
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(controls);
    layout->addWidget(m_grid, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &RandomDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &RandomDialog::reject);
    connect(m_grid, &QListWidget::itemDoubleClicked, this, &RandomDialog::accept);
    connect(m_grid, &QListWidget::itemSelectionChanged, this, [this] { m_add->setEnabled(chosen() >= 0); });
    connect(m_sheet, &SheetMaker::made, this, &RandomDialog::showPicture);
    connect(m_sheet, &SheetMaker::drawn, this, &RandomDialog::showPicture);
    connect(&m_resized, &QTimer::timeout, this, &RandomDialog::redraw);
    m_dimension->setCurrentIndex(document::dimension(document->fractal()) == 3 ? 1 : 0);
    chooseDimension();
    connect(m_dimension, &QComboBox::currentIndexChanged, this, &RandomDialog::chooseDimension);
    connect(m_groups, &QComboBox::currentIndexChanged, this, &RandomDialog::chooseSymmetry);
    connect(m_maps, &QComboBox::currentIndexChanged, this, &RandomDialog::makeSheet);
    connect(m_order, &QSpinBox::valueChanged, this, &RandomDialog::makeSheet);
    connect(m_seed, &QSpinBox::valueChanged, this, &RandomDialog::makeSheet);
    m_grid->setFocus();
}

RandomDialog::~RandomDialog() = default;

void RandomDialog::createGrid() {
    m_grid->setAccessibleName(tr("Random fractals"));
    m_grid->setWhatsThis(
        tr("Select one and confirm, or double-click it: it is added to the file, in one step that "
           "you can undo."));
    m_grid->setItemDelegate(new PictureTiles(m_grid));
    m_grid->setViewMode(QListView::IconMode);
    m_grid->setMovement(QListView::Static);
    m_grid->setResizeMode(QListView::Adjust);
    m_grid->setMouseTracking(true);
    m_grid->setIconSize({side, side});
    m_grid->setGridSize({cell, cell});
    // Otherwise the layout reserves room for them.
    m_grid->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_grid->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_grid->setMinimumSize(columns * cell + 2 * m_grid->frameWidth() + slack,
                           count / columns * cell + 2 * m_grid->frameWidth() + slack);
    m_grid->viewport()->installEventFilter(this);
    m_resized.setSingleShot(true);
    m_resized.setInterval(resizePause);
}

bool RandomDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_grid->viewport() && event->type() == QEvent::Resize) fitTiles();
    return QDialog::eventFilter(watched, event);
}

void RandomDialog::fitTiles() {
    const QSize room = m_grid->viewport()->size() - QSize(slack, slack);
    const QSize tile(std::max(cell, room.width() / columns),
                     std::max(cell, room.height() / (count / columns)));
    if (tile == m_grid->gridSize()) return;
    m_grid->setGridSize(tile);
    for (int i = 0; i < m_grid->count(); ++i)
        m_grid->item(i)->setSizeHint(tile);
    m_resized.start();
}

void RandomDialog::redraw() {
    const QSize tile = m_grid->gridSize();
    m_sheet->setSide(std::min(tile.width(), tile.height()) - 2 * PictureTiles::margin, devicePixelRatioF());
    for (int i = 0; i < m_grid->count(); ++i)
        showPicture(i);
}

void RandomDialog::createControls(QGridLayout* layout) {
    addChoice(m_dimension, tr("In the plane"), 2);
    addChoice(m_dimension, tr("In space"), 3);
    m_dimension->setAccessibleName(tr("Plane or space"));
    m_dimension->setToolTip(tr("Make systems in the plane or in space"));
    m_dimension->setWhatsThis(
        tr("In the plane, the contraction of the maps follows a rule that makes the fractal fill its view. "
           "In space there is no such rule: the two larger scale factors of each map follow that of the "
           "plane, and the third is smaller."));
    m_maps->setToolTip(tr("How many maps the systems have"));
    m_maps->setWhatsThis(
        tr("How many maps each system lists. With a symmetry, each of them also acts rotated or "
           "mirrored."));
    m_groups->setAccessibleName(tr("Symmetry"));
    m_groups->setToolTip(tr("Make systems that are symmetric about the origin"));
    m_groups->setWhatsThis(
        tr("Each map also acts rotated or mirrored about the origin, so the fractal is symmetric. "
           "You can change the symmetry later in the Maps panel. The tetrahedral, octahedral and "
           "icosahedral groups exist in space only."));
    m_order->setRange(ifs::minSymmetryOrder, ifs::maxSymmetryOrder);
    m_order->setValue(usualOrder);
    m_order->setAccessibleName(tr("Order of the symmetry"));
    m_order->setToolTip(tr("How many times the fractal repeats in a full turn"));
    m_order->setWhatsThis(tr("A rotation of order 5 repeats the fractal five times in a full turn."));
    const auto add = [&](int column, const QString& text, QWidget* field) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        layout->addWidget(label, 0, column);
        layout->addWidget(field, 0, column + 1);
    };
    layout->addWidget(m_dimension, 0, 0);
    add(1, tr("&Maps:"), m_maps);
    add(3, tr("S&ymmetry:"), m_groups);
    layout->addWidget(m_order, 0, 5);
    layout->setColumnStretch(6, 1);
}

void RandomDialog::addSeed(QGridLayout* layout) {
    m_seed->setRange(1, 999'999);
    m_seed->setValue(QRandomGenerator::global()->bounded(1, 1'000'000)); // different sheet each time
    m_seed->setAccessibleName(tr("Seed of the random numbers"));
    m_seed->setToolTip(tr("The same seed gives the same sheet again"));
    m_seed->setWhatsThis(
        tr("The number from which the systems are generated. With the same settings and the same seed you "
           "get the same sheet again."));
    auto* other = new QPushButton(tr("&New Set"), this);
    other->setToolTip(tr("Show another sheet, from the next seed"));
    other->setWhatsThis(tr("Shows other systems of the same kind, from the next seed."));
    other->setAutoDefault(false);
    auto* label = new QLabel(tr("&Seed:"), this);
    label->setBuddy(m_seed);
    layout->addWidget(label, 0, 7);
    layout->addWidget(m_seed, 0, 8);
    layout->addWidget(other, 0, 9);
    connect(other, &QPushButton::clicked, m_seed, &QSpinBox::stepUp);
}

document::RandomChoice RandomDialog::choice() const {
    document::RandomChoice choice;
    choice.dimension = chosenValue<int>(m_dimension);
    choice.maps = chosenValue<int>(m_maps);
    choice.symmetry = chosenSymmetryGroup(m_groups);
    choice.order = hasOrder(choice.symmetry) ? m_order->value() : 1;
    return choice;
}

void RandomDialog::chooseDimension() {
    const auto group = chosenSymmetryGroup(m_groups);
    const QSignalBlocker quiet(m_groups);
    fillSymmetryGroups(m_groups, chosenValue<int>(m_dimension));
    if (!chooseValue(m_groups, group)) chooseValue(m_groups, ifs::SymmetryGroup::None);
    chooseSymmetry();
}

// A single map needs one: without, it has a point.
void RandomDialog::chooseSymmetry() {
    const auto group = chosenSymmetryGroup(m_groups);
    const int before = chosenValue<int>(m_maps);
    const QSignalBlocker quiet(m_maps);
    m_maps->clear();
    addChoice(m_maps, tr("Any"), 0);
    for (int maps = group == ifs::SymmetryGroup::None ? 2 : 1; maps <= document::maxRandomMaps; ++maps)
        addChoice(m_maps, QString::number(maps), maps);
    if (!chooseValue(m_maps, before)) chooseValue(m_maps, 0);
    m_order->setEnabled(hasOrder(group));
    makeSheet();
}

void RandomDialog::makeSheet() {
    m_grid->clear();
    for (int i = 0; i < count; ++i) {
        auto* item = new QListWidgetItem(m_grid);
        item->setSizeHint(m_grid->gridSize()); // fixed before its picture exists
    }
    const auto prepare = [choice = choice()]() -> SheetMaker::Make {
        return [choice](std::uint64_t seed, const std::stop_token&) {
            return document::randomFractal(choice, seed);
        };
    };
    m_sheet->make(prepare, std::uint64_t(m_seed->value()) * count);
    m_add->setEnabled(false);
}

void RandomDialog::showPicture(int index) {
    if (!m_sheet->fractal(index)) return;
    m_grid->item(index)->setData(Qt::AccessibleTextRole, tr("Fractal %1").arg(index + 1));
    const QModelIndex tile = m_grid->model()->index(index, 0);
    Thumbnail picture = m_sheet->picture(index);
    if (picture.pixmap.isNull() && picture.state == Thumbnail::State::Pending)
        picture.pixmap = PictureTiles::shown(tile).pixmap; // picture in the previous size
    PictureTiles::show(m_grid->model(), tile, picture);
    m_add->setEnabled(chosen() >= 0);
}

int RandomDialog::chosen() const {
    const QModelIndexList selected = m_grid->selectionModel()->selectedIndexes();
    const int row = selected.isEmpty() ? -1 : selected.front().row();
    return m_sheet->fractal(row) ? row : -1;
}

void RandomDialog::accept() {
    if (chosen() < 0) return;
    document::Fractal taken = *m_sheet->fractal(chosen());
    taken.name = QStringLiteral("random"); // neutral name, since the seed is meaningless in the file
    document::Entry entry;
    entry.fractal = std::make_shared<const document::Fractal>(std::move(taken));
    const document::Inserted added = inserted(m_document->file(), {entry}, m_document->currentId());
    m_document->editFile(tr("Add Random Fractal"), added.file, added.ids.value(0));
    QDialog::accept();
}

} // namespace view
