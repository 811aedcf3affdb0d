// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QComboBox;
class QLineEdit;

namespace view {

class StepsBridge;

// Chooses what the steps Wⁿ start from: the cage, a square, typed letters or a picture.
class StartShapeBox : public QWidget {
    Q_OBJECT

public:
    explicit StartShapeBox(StepsBridge* steps, QWidget* parent = nullptr);

    QComboBox* choice() const { return m_choice; }
    QLineEdit* letter() const { return m_letter; }

private:
    void choose();
    void follow();

    StepsBridge* m_steps;
    QComboBox* m_choice;
    QLineEdit* m_letter;
};

} // namespace view
