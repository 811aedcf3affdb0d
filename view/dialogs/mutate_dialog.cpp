// SPDX-License-Identifier: MIT
#include "dialogs/mutate_dialog.h"

#include "document/edits/entries_edits.h"
#include "document/variations.h"
#include "io/file/background.h"
#include "widgets/thumbnail_tile.h"
#include "widgets/tooltip_text.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <utility>

namespace view {

namespace {

constexpr int side = 132; // of a picture
constexpr int columns = 4;
constexpr int strengthSteps = 100;

// Pictures without a text; the chosen one lies on a tile of the colour of selections.
class Tiles : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const QRect tile = option.rect.adjusted(1, 1, -1, -1);
        QRect picture(0, 0, side, side);
        picture.moveCenter(tile.center());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const QColor highlight = option.palette.color(QPalette::Highlight);
        painter->setPen(option.state & QStyle::State_HasFocus ? QPen(highlight, 1) : QPen(Qt::NoPen));
        painter->setBrush(option.state & QStyle::State_Selected ? QBrush(highlight) : QBrush(Qt::NoBrush));
        painter->drawRoundedRect(QRectF(tile).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        painter->restore();
        const QPixmap pixmap = index.data(Qt::DecorationRole)
                                   .value<QIcon>()
                                   .pixmap({side, side}, painter->device()->devicePixelRatioF());
        paintThumbnail(*painter, picture, {Thumbnail::State::Pending, pixmap}, option.palette);
    }
};

} // namespace

MutateDialog::MutateDialog(document::Document* document, Source source, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_source(source),
      m_parent(document->sharedFractal()),
      m_thumbnails(new Thumbnails(this)) {
    setWindowTitle(source == Source::Current ? tr("Variations of “%1”").arg(titleText(m_parent->name))
                                             : tr("Random Fractals"));
    m_thumbnails->setSize(side, devicePixelRatioF());
    connect(m_thumbnails, &Thumbnails::ready, this, [this](quint64 key) {
        if (key / count == quint64(m_seed->value())) showPicture(int(key % count));
    });
    m_grid = new QListWidget(this);
    m_grid->setAccessibleName(tr("Variations"));
    m_grid->setWhatsThis(tr("Select one and confirm, or double-click it: it replaces the fractal, in one "
                            "step that you can undo."));
    m_grid->setItemDelegate(new Tiles(m_grid));
    m_grid->setViewMode(QListView::IconMode);
    m_grid->setMovement(QListView::Static);
    m_grid->setResizeMode(QListView::Adjust);
    m_grid->setIconSize({side, side});
    m_grid->setGridSize({side + 12, side + 12});
    const int scrollBar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, m_grid);
    m_grid->setMinimumSize(columns * (side + 12) + 2 * m_grid->frameWidth() + scrollBar + 8,
                           count / columns * (side + 12) + 2 * m_grid->frameWidth() + 8);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_use = buttons->addButton(source == Source::Current ? tr("&Use This One") : tr("&Add to the File"),
                               QDialogButtonBox::AcceptRole);
    m_use->setWhatsThis(tr("Uses the selected one, in one step that you can undo."));
    m_vary = buttons->addButton(tr("&Mutate Again"), QDialogButtonBox::ActionRole);
    m_vary->setToolTip(tr("Use the selected one as the new starting point"));
    auto* layout = new QVBoxLayout(this);
    createControls();
    layout->addWidget(m_grid, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &MutateDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &MutateDialog::reject);
    connect(m_vary, &QPushButton::clicked, this, &MutateDialog::varyChosen);
    connect(m_grid, &QListWidget::itemDoubleClicked, this, &MutateDialog::accept);
    connect(m_grid, &QListWidget::itemSelectionChanged, this, &MutateDialog::updateButtons);
    connect(&m_making, &QFutureWatcherBase::resultReadyAt, this, &MutateDialog::take);
    makeAll();
}

MutateDialog::~MutateDialog() {
    m_making.cancel();
}

void MutateDialog::createControls() {
    m_strength = new QSlider(Qt::Horizontal, this);
    m_strength->setRange(2, strengthSteps);
    m_strength->setValue(30);
    m_strength->setAccessibleName(tr("How strongly the variations differ"));
    m_strength->setWhatsThis(tr(
        "On the left, the variations stay close to their starting point; on the right, they differ wildly."));
    m_seed = new QSpinBox(this);
    m_seed->setRange(1, 999'999);
    m_seed->setAccessibleName(tr("Seed of the random numbers"));
    m_seed->setToolTip(tr("The same seed gives the same sheet again"));
    auto* other = new QPushButton(tr("&New Set"), this);
    other->setToolTip(tr("Show another sheet, from the next seed"));
    auto* strengthLabel = new QLabel(tr("S&trength:"), this);
    strengthLabel->setBuddy(m_strength);
    auto* seedLabel = new QLabel(tr("&Seed:"), this);
    seedLabel->setBuddy(m_seed);
    auto* row = new QHBoxLayout;
    row->addWidget(strengthLabel);
    row->addWidget(m_strength, 1);
    row->addStretch();
    row->addWidget(seedLabel);
    row->addWidget(m_seed);
    row->addWidget(other);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    strengthLabel->setVisible(m_source == Source::Current);
    m_strength->setVisible(m_source == Source::Current);
    connect(m_strength, &QSlider::valueChanged, this, &MutateDialog::makeAll);
    connect(m_seed, &QSpinBox::valueChanged, this, &MutateDialog::makeAll);
    connect(other, &QPushButton::clicked, m_seed, &QSpinBox::stepUp);
}

void MutateDialog::makeAll() {
    m_making.cancel();
    m_thumbnails->clear();
    io::freeInBackground(std::exchange(m_fractals, {}));
    m_grid->clear();
    for (int i = 0; i < count; ++i) {
        auto* item = new QListWidgetItem(m_grid);
        item->setSizeHint(m_grid->gridSize()); // before its picture is there
    }
    const std::uint64_t first = std::uint64_t(m_seed->value()) * count;
    const double strength = double(m_strength->value()) / strengthSteps;
    m_making.setFuture(io::inBackground<FractalPointer>(
        [source = m_source, parent = m_parent, first, strength](QPromise<FractalPointer>& made) {
            for (std::uint64_t seed = first; seed < first + count && !made.isCanceled(); ++seed)
                made.addResult(std::make_shared<const document::Fractal>(
                    source == Source::Current ? document::variation(*parent, strength, seed)
                                              : document::randomFractal(seed)));
        }));
    updateButtons();
}

void MutateDialog::take(int index) {
    m_fractals.push_back(m_making.resultAt(index));
    m_grid->item(index)->setData(Qt::AccessibleTextRole, tr("Variation %1").arg(index + 1));
    showPicture(index);
    updateButtons();
}

void MutateDialog::showPicture(int index) {
    if (index >= int(m_fractals.size())) return;
    const auto key = quint64(m_seed->value()) * count + quint64(index);
    const QPixmap pixmap = m_thumbnails->thumbnail(key, m_fractals[std::size_t(index)]).pixmap;
    if (!pixmap.isNull()) m_grid->item(index)->setIcon(pixmap);
}

int MutateDialog::chosen() const {
    const QModelIndexList selected = m_grid->selectionModel()->selectedIndexes();
    const int row = selected.isEmpty() ? -1 : selected.front().row();
    return row < int(m_fractals.size()) ? row : -1;
}

void MutateDialog::updateButtons() {
    m_use->setEnabled(chosen() >= 0);
    m_vary->setEnabled(chosen() >= 0);
    m_vary->setVisible(m_source == Source::Current);
}

void MutateDialog::varyChosen() {
    if (chosen() < 0) return;
    m_parent = m_fractals[std::size_t(chosen())];
    makeAll();
}

void MutateDialog::accept() {
    if (chosen() < 0) return;
    const auto& fractal = m_fractals[std::size_t(chosen())];
    if (m_source == Source::Current) {
        m_document->edit(tr("Mutate"), *fractal);
    } else {
        document::Entry entry;
        entry.fractal = fractal;
        const document::Inserted added = inserted(m_document->file(), {entry}, m_document->currentId());
        m_document->editFile(tr("Add Random Fractal"), added.file, added.ids.value(0));
    }
    QDialog::accept();
}

} // namespace view
