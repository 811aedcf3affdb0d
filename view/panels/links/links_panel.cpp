// SPDX-License-Identifier: MIT
#include "panels/links/links_panel.h"

#include "document/edits/maps/link_edits.h"
#include "panels/links/link_graph.h"
#include "panels/links/links_model.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

// Returns true if the chaos game ever draws lots; else only the fixed points of the cycles are drawn.
bool leavesAChoice(const document::System2& system) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(system);
    const std::size_t count = active.maps.size();
    if (!active.isLinked()) return count > 1;
    for (std::size_t row = 0; row < count; ++row) {
        const auto begin = active.links.begin() + std::ptrdiff_t(row * count);
        if (std::count_if(begin, begin + std::ptrdiff_t(count), [](double p) { return p > 0; }) > 1)
            return true;
    }
    return false;
}

} // namespace

LinksPanel::LinksPanel(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new LinksModel(document, this)),
      m_graph(new LinkGraph(m_model, this)),
      m_table(new QTableView(this)),
      m_views(new QSplitter(Qt::Vertical, this)),
      m_notice(new QLabel(this)),
      m_remove(new QPushButton(tr("Remove All Links"), this)) {
    setAccessibleName(tr("Links"));
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Links between maps"));
    m_table->setToolTip(
        tr("Rows are the maps applied before, columns the maps applied after. A number multiplies the weight "
           "of the map in its column: 1 leaves it unchanged, 0 forbids the link."));
    m_table->setTabKeyNavigation(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setResizeContentsPrecision(32);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_notice->setWordWrap(true);
    m_notice->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_remove->setAccessibleName(m_remove->text());
    m_remove->setToolTip(tr("Any map may follow any other again"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(6);
    m_views->setChildrenCollapsible(false);
    m_views->addWidget(m_graph);
    m_views->addWidget(m_table);
    m_views->setStretchFactor(0, 3);
    m_views->setStretchFactor(1, 2);
    layout->addWidget(m_views, 1);
    layout->addWidget(m_notice);
    layout->addWidget(m_remove, 0, Qt::AlignLeft);
    for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace})
        new QShortcut(key, m_table, this, &LinksPanel::forbidSelected, Qt::WidgetShortcut);
    connect(m_model, &LinksModel::refused, this, &LinksPanel::message);
    connect(m_model, &QAbstractItemModel::modelReset, this, &LinksPanel::showState);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &LinksPanel::showState);
    connect(m_graph, &LinkGraph::selected, this, &LinksPanel::selectArrow);
    connect(m_graph, &LinkGraph::editWanted, this, [this](int from, int to) {
        m_table->setFocus();
        m_table->edit(m_model->index(from, to));
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &LinksPanel::selectCell);
    connect(m_remove, &QPushButton::clicked, this, &LinksPanel::removeLinks);
    showState();
}

void LinksPanel::showState() {
    const document::Fractal& fractal = m_document->fractal();
    const document::System2* system = document::system2(fractal);
    const QString obstacle = document::linkObstacle(fractal);
    const bool isLinked = system != nullptr && !system->links.empty();
    QString notice = obstacle;
    if (obstacle.isEmpty() && !isLinked)
        notice = tr("Any map may follow any other. Click an arrow and press Delete to forbid it.");
    if (isLinked && ifs::countActive(*system) == 0)
        notice = tr("Every sequence of maps ends, so nothing is drawn.");
    else if (isLinked && !leavesAChoice(*system))
        notice = tr("No map has a choice of what follows it, so only single points are drawn.");
    if (obstacle.isEmpty()) // what the numbers of the table mean
        notice = (notice + u' ' + tr("Row: the map before. Column: the map after.")).trimmed();
    m_notice->setText(notice);
    m_notice->setVisible(!notice.isEmpty());
    m_views->setVisible(obstacle.isEmpty());
    m_remove->setEnabled(isLinked);
}

void LinksPanel::selectArrow(int from, int to) {
    const QModelIndex current = m_table->currentIndex();
    const int column = to >= 0 ? to : current.isValid() ? current.column() : 0;
    m_table->setCurrentIndex(m_model->index(from, column));
    m_graph->select(from, to);
}

void LinksPanel::selectCell(const QModelIndex& index) {
    m_graph->select(index.row(), index.column());
}

void LinksPanel::forbidSelected() {
    m_model->forbid(m_table->selectionModel()->selectedIndexes());
}

void LinksPanel::removeLinks() {
    m_document->edit(tr("Remove all links"), document::withoutLinks(m_document->fractal()));
}

} // namespace view
