// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QWidget>

class QLabel;
class QModelIndex;
class QPushButton;
class QSplitter;
class QTableView;

namespace view {

class LinkGraph;
class LinksModel;

// Links between maps in the chaos game, as a graph and as a matrix with a common selection; one undo step for
// each arrow drawn or removed and each cell edited.
class LinksPanel : public QWidget {
    Q_OBJECT

public:
    explicit LinksPanel(document::Document* document, QWidget* parent = nullptr);

    QTableView* table() const { return m_table; }
    LinksModel* model() const { return m_model; }
    LinkGraph* graph() const { return m_graph; }

signals:
    void message(const QString& text); // a sentence for the status bar

private:
    void showState();
    void selectArrow(int from, int to);
    void selectCell(const QModelIndex& index);
    void forbidSelected();
    void removeLinks();

    document::Document* m_document;
    LinksModel* m_model;
    LinkGraph* m_graph;
    QTableView* m_table;
    QSplitter* m_views; // parent of graph and table
    QLabel* m_notice;   // reason why there is no matrix, or its effect
    QPushButton* m_remove;
};

} // namespace view
