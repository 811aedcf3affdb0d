// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QWidget>

class QLabel;
class QTreeView;

namespace view {

class ProblemsModel;

// The reader's problems with the file: choosing a line shows the entry it concerns.
class ProblemsPanel : public QWidget {
    Q_OBJECT

public:
    explicit ProblemsPanel(document::Document* document, QWidget* parent = nullptr);

    int count() const;
    void setFileName(const QString& fileName); // name for the copied text

public slots:
    void copySelected(); // lines "file:line:column: severity: sentence"; all problems if none is selected

signals:
    void countChanged(int count); // number of problems that call for attention

private:
    void createActions();
    void showEntry(const QModelIndex& index);
    void updateCount();

    document::Document* m_document;
    ProblemsModel* m_model;
    QTreeView* m_list;
    QLabel* m_summary;
    QString m_fileName;
};

} // namespace view
