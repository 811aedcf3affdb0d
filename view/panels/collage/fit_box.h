// SPDX-License-Identifier: MIT
#pragma once

#include "collage/suggestions.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QProgressBar;
class QPushButton;
class QShortcut;
class QSpinBox;
class QToolButton;

namespace view {

// Automatic fits to a target, and their constraints.
class FitBox : public QWidget {
    Q_OBJECT

public:
    enum class Task { Suggest, RefineMaps, RefineAttractor, FitWeights, FitCage, AddMap };

    explicit FitBox(QWidget* parent);

    // The button that suggests, with the progress below it: for the panel to lay where it likes.
    QWidget* start() const { return m_start; }

    collage::SearchOptions searchOptions() const;
    collage::Constraints constraints() const;
    bool refinesSelectedOnly() const;
    int cageCorners() const;

    void setPossible(bool possible); // true if there is something to fit
    void setLocks(const QString& names, bool areSelectedLocked, bool isAnySelected);
    void setProgress(const std::optional<double>& share); // nullopt: no computation running

signals:
    void requested(view::FitBox::Task task);
    void lockRequested(bool lock); // sent for the selected maps
    void cancelled();

private:
    QWidget* makeSearch();
    void addConstraints(QGridLayout* grid);
    QWidget* makeTasks();
    QWidget* makeStart();
    QWidget* makeProgress();
    QPushButton* taskButton(const QString& text, const QString& tip, Task task);
    void enableTasks();

    QComboBox* m_maps = nullptr;
    QDoubleSpinBox* m_seconds = nullptr;
    QSpinBox* m_seed = nullptr;
    QCheckBox* m_similarities = nullptr;
    QCheckBox* m_noMirrors = nullptr;
    QCheckBox* m_stem = nullptr;
    QComboBox* m_angles = nullptr;
    QCheckBox* m_selectedOnly = nullptr;
    QToolButton* m_lock = nullptr;
    QSpinBox* m_corners = nullptr;
    QWidget* m_start = nullptr;
    QWidget* m_busy = nullptr;
    QProgressBar* m_progress = nullptr;
    QShortcut* m_escape = nullptr; // valid in the whole panel during a computation
    std::vector<QPushButton*> m_tasks;
    bool m_isPossible = false;
    bool m_isBusy = false;
};

} // namespace view
