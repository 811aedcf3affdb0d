// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QTableView;

namespace view {

class LinksModel;

// Which maps may follow which in the chaos game, as a matrix; one step of the history for each cell edited.
class LinksPanel : public QWidget {
    Q_OBJECT

public:
    explicit LinksPanel(document::Document* document, QWidget* parent = nullptr);

    QTableView* table() const { return m_table; }
    LinksModel* model() const { return m_model; }

signals:
    void message(const QString& text); // a sentence for the status bar

private:
    void showState();
    void removeLinks();

    document::Document* m_document;
    LinksModel* m_model;
    QTableView* m_table;
    QLabel* m_notice; // why there is no matrix, or what it comes to
    QPushButton* m_remove;
};

} // namespace view
