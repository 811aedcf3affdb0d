// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QButtonGroup;
class QComboBox;
class QLabel;
class QSlider;
class QStackedWidget;
class QToolButton;

namespace view {

class Construction;

// The controls of Construction in one row: density, the steps Wⁿ by a slider, or a chaos game that is
// started, paused, done point by point and begun again.
class ConstructionBar : public QWidget {
    Q_OBJECT

public:
    explicit ConstructionBar(Construction* construction, QWidget* parent = nullptr);

    QSlider* steps() const { return m_steps; }
    QToolButton* run() const { return m_run; }

private:
    QWidget* makeSteps();
    QWidget* makeChaosGame();
    void follow();

    Construction* m_construction;
    QButtonGroup* m_modes;
    QStackedWidget* m_pages;
    QSlider* m_steps = nullptr;
    QLabel* m_copies = nullptr;
    QToolButton* m_run = nullptr;
    QComboBox* m_speed = nullptr;
    QLabel* m_count = nullptr;
};

} // namespace view
