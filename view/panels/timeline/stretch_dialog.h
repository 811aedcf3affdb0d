// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/timeline/retiming.h"

#include <QDialog>

#include <memory>

class QLabel;
class QPushButton;
class QSpinBox;

namespace view {

class Timeline;

// Asks which frames are to last longer or shorter, and until when.
class StretchDialog : public QDialog {
    Q_OBJECT

public:
    StretchDialog(std::shared_ptr<const document::Fractal> entry, const document::Stretch& proposed,
                  QWidget* parent = nullptr);

    document::Stretch stretch() const;

private:
    QSpinBox* frameBox(int value, const QString& name, const QString& help);
    void check();

    std::shared_ptr<const document::Fractal> m_entry;
    QSpinBox* m_from;
    QSpinBox* m_to;
    QSpinBox* m_end;
    QLabel* m_note;
    QPushButton* m_stretch;
};

// Opens the dialog for the range of the selected keys, or for the whole animation, and stretches in one step
// of the history.
void askToStretch(Timeline& timeline, QWidget* parent);

} // namespace view
