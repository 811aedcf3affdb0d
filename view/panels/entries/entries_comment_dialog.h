// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace view {

// Edits what an entry says about itself: the comment behind its opening brace and its comment lines.
class EntriesCommentDialog : public QDialog {
    Q_OBJECT

public:
    explicit EntriesCommentDialog(const document::Fractal& fractal, QWidget* parent = nullptr);

    document::Fractal fractal() const; // fractal with the edited comments

signals:
    void edited(); // sent for edits that can be kept

private:
    QStringList lines() const;
    void check();

    document::Fractal m_before;
    QLineEdit* m_header;
    QPlainTextEdit* m_lines;
    QLabel* m_problem;
    QDialogButtonBox* m_buttons;
};

} // namespace view
