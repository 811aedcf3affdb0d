// SPDX-License-Identifier: MIT
#include "panels/links/links_panel.h"

#include "document/edits/link_edits.h"
#include "panels/links/links_model.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace view {

LinksPanel::LinksPanel(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new LinksModel(document, this)),
      m_table(new QTableView(this)),
      m_notice(new QLabel(this)),
      m_remove(new QPushButton(tr("Remove All Links"), this)) {
    setAccessibleName(tr("Links"));
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Links between maps"));
    m_table->setToolTip(
        tr("Rows are maps applied before, columns maps applied after. A number multiplies the "
           "weight of the map of the column: 1 leaves it, 0 forbids it."));
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
    layout->addWidget(m_table, 1);
    layout->addWidget(m_notice);
    layout->addWidget(m_remove, 0, Qt::AlignLeft);
    connect(m_model, &LinksModel::refused, this, &LinksPanel::message);
    connect(m_model, &QAbstractItemModel::modelReset, this, &LinksPanel::showState);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &LinksPanel::showState);
    connect(m_remove, &QPushButton::clicked, this, &LinksPanel::removeLinks);
    showState();
}

void LinksPanel::showState() {
    const document::Fractal& fractal = m_document->fractal();
    const document::System2* system = document::system2(fractal);
    const QString obstacle = document::linkObstacle(fractal);
    const bool isLinked = system != nullptr && !system->links.empty();
    QString notice = obstacle;
    if (obstacle.isEmpty() && !isLinked) notice = tr("Any map may follow any other. Enter 0 to forbid it.");
    if (isLinked && ifs::countActive(*system) == 0)
        notice = tr("Every sequence of maps comes to an end, so nothing is drawn.");
    m_notice->setText(notice);
    m_notice->setVisible(!notice.isEmpty());
    m_table->setVisible(obstacle.isEmpty());
    m_remove->setEnabled(isLinked);
}

void LinksPanel::removeLinks() {
    m_document->edit(tr("Remove all links"), document::withoutLinks(m_document->fractal()));
}

} // namespace view
