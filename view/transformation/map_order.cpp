// SPDX-License-Identifier: MIT
#include "transformation/map_order.h"

#include "widgets/flat_buttons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPixmap>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

constexpr std::size_t maxListed = 256;
constexpr int letters = 7; // width in letters

QIcon swatch(const attractor::Rgba& colour, int side) {
    QPixmap pixmap(side, side);
    pixmap.fill(QColor(colour.red, colour.green, colour.blue));
    return pixmap;
}

std::vector<std::size_t> activeIndices(const document::Fractal& fractal) {
    const document::System2* system = document::system2(fractal);
    if (system == nullptr) return {};
    std::vector<std::size_t> indices = ifs::activeMaps(*system).index;
    indices.erase(std::unique(indices.begin(), indices.end()),
                  indices.end()); // keeps copies under a symmetry together
    return indices;
}

} // namespace

MapOrder::MapOrder(QWidget* parent) : QWidget(parent), m_list(new QListWidget(this)) {
    m_list->setAccessibleName(tr("Order of the maps"));
    m_list->setToolTip(
        tr("Where pieces overlap, the map that is higher in this list is on top; drag a map to "
           "move it"));
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_up = flatButton(QString(), QStringLiteral("↑"), tr("Move the map towards the top"), this);
    m_down = flatButton(QString(), QStringLiteral("↓"), tr("Move the map towards the bottom"), this);
    for (QToolButton* button : {m_up, m_down})
        button->setAccessibleName(button->toolTip());
    m_reset = flatButton(QStringLiteral("reset"), tr("Reset Order"),
                         tr("Reset Order: puts the maps back in the order of their numbers"), this);
    m_up->setObjectName(QStringLiteral("up"));
    m_down->setObjectName(QStringLiteral("down"));
    m_reset->setObjectName(QStringLiteral("reset-order"));
    m_reset->setWhatsThis(
        tr("Puts the maps back in the order of their numbers, which is that of the Maps panel: "
           "map 1 is on top. This is one step that you can undo."));
    auto* title = new QLabel(tr("On top"), this);
    title->setBuddy(m_list);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_up);
    buttons->addWidget(m_down);
    buttons->addWidget(m_reset);
    buttons->setSpacing(0);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(title);
    layout->addWidget(m_list, 1);
    layout->addLayout(buttons);
    setFixedWidth(std::max({letters * fontMetrics().averageCharWidth() + 36, title->sizeHint().width() + 8,
                            buttons->sizeHint().width() + 8}));
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
    connect(m_reset, &QToolButton::clicked, this, [this] { emit ordered({}); });
    connect(m_list, &QListWidget::currentRowChanged, this, &MapOrder::updateButtons);
    // Queued until after the drop, because the list will be refilled.
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &MapOrder::report, Qt::QueuedConnection);
    m_reset->setEnabled(false);
    updateButtons();
}

void MapOrder::show(const document::Fractal& fractal, const std::vector<std::size_t>& order) {
    m_maps = activeIndices(fractal);
    const bool isEach = order.size() == m_maps.size() && std::ranges::is_permutation(order, m_maps);
    m_reset->setEnabled(!order.empty());
    const int row = m_list->currentRow();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    if (m_maps.size() > maxListed) return updateButtons(); // too many to be sorted by hand
    for (const std::size_t map : isEach ? order : m_maps) {
        const auto& maps = document::system2(fractal)->maps;
        auto* item = new QListWidgetItem(
            swatch(attractor::mapColour(fractal.appearance, maps[map].id, map), fontMetrics().ascent()),
            QString::number(map + 1), m_list);
        item->setData(Qt::UserRole, qulonglong(map));
        item->setData(Qt::AccessibleTextRole, tr("Map %1").arg(map + 1));
    }
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
    updateButtons();
}

void MapOrder::move(int by) {
    const int from = m_list->currentRow(), to = from + by;
    if (from < 0 || to < 0 || to >= m_list->count()) return;
    m_list->insertItem(to, m_list->takeItem(from));
    m_list->setCurrentRow(to);
    report();
}

void MapOrder::report() {
    std::vector<std::size_t> order;
    for (int row = 0; row < m_list->count(); ++row)
        order.push_back(std::size_t(m_list->item(row)->data(Qt::UserRole).toULongLong()));
    if (order == m_maps) order.clear();
    emit ordered(order);
}

void MapOrder::updateButtons() {
    const int row = m_list->currentRow();
    m_up->setEnabled(row > 0);
    m_down->setEnabled(row >= 0 && row + 1 < m_list->count());
}

} // namespace view
