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

class Arising;

// The controls of Arising in one row: density, the steps Wⁿ by a slider, or a chaos game that is started,
// paused, done point by point and begun again.
class ArisingBar : public QWidget {
    Q_OBJECT

public:
    explicit ArisingBar(Arising* arising, QWidget* parent = nullptr);

    QSlider* steps() const { return m_steps; }
    QToolButton* run() const { return m_run; }

private:
    QWidget* makeSteps();
    QWidget* makeChaosGame();
    QToolButton* button(const QString& iconName, const QString& text, const QString& tip);
    void follow();

    Arising* m_arising;
    QButtonGroup* m_modes;
    QStackedWidget* m_pages;
    QSlider* m_steps = nullptr;
    QLabel* m_copies = nullptr;
    QToolButton* m_run = nullptr;
    QComboBox* m_speed = nullptr;
    QLabel* m_count = nullptr;
};

} // namespace view
