// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace view {

// Coordinates of one vertex of the cage as numbers; the picture follows every number that is one. One undo
// step.
class VertexDialog : public QDialog {
    Q_OBJECT

public:
    VertexDialog(document::Document* document, int index, QWidget* parent);

    void done(int result) override;

private:
    void follow();

    document::Document* m_document;
    int m_index;
    document::EditGesture m_gesture;
    QLineEdit* m_x;
    QLineEdit* m_y;
    QLabel* m_problem;
    QPushButton* m_accept;
};

} // namespace view
