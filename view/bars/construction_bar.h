// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QButtonGroup;
class QComboBox;
class QSlider;
class QStackedWidget;
class QToolButton;

namespace view {

class Construction;
class Die;
class ElidedLabel;
class StartShapeBox;

// The controls of Construction in one row: density; the steps Wⁿ by a slider, with their start and their
// distance from the attractor; or a chaos game with its die that is started, paused, done jump by jump and
// begun again.
class ConstructionBar : public QWidget {
    Q_OBJECT

public:
    explicit ConstructionBar(Construction* construction, QWidget* parent = nullptr);

    QSlider* steps() const { return m_steps; }
    QToolButton* run() const { return m_run; }
    StartShapeBox* start() const { return m_start; }
    const Die& die() const { return *m_die; }
    QString distanceText() const;

private:
    QWidget* makeSteps();
    QWidget* makeChaosGame();
    void follow();
    void followSteps();
    void followChaosGame();

    Construction* m_construction;
    QButtonGroup* m_modes;
    QStackedWidget* m_pages;
    QSlider* m_steps = nullptr;
    StartShapeBox* m_start = nullptr;
    ElidedLabel* m_facts = nullptr; // number of copies and distance
    QToolButton* m_run = nullptr;
    QComboBox* m_speed = nullptr;
    Die* m_die = nullptr;
    ElidedLabel* m_count = nullptr;
};

} // namespace view
