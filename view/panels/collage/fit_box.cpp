// SPDX-License-Identifier: MIT
#include "panels/collage/fit_box.h"

#include "io/picture/plane_export.h"
#include "widgets/choices.h"
#include "widgets/layout/vertical_scroll_area.h"
#include "widgets/numbers/number_box.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

namespace view {

namespace {

constexpr int minMaps = 2, maxMaps = 16;
constexpr int rangeEnd = 8; // greatest number of maps that is tried by default

void addRow(QGridLayout* grid, const QString& text, QWidget* field) {
    auto* label = new QLabel(text, field->parentWidget());
    label->setBuddy(field);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(field, row, 1);
}

QGridLayout* gridOf(QWidget* box) {
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    return grid;
}

} // namespace

FitBox::FitBox(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    m_start = makeStart();
    layout->addWidget(makeSearch());
    layout->addWidget(makeTasks());
    setProgress(std::nullopt);
}

QWidget* FitBox::makeSearch() {
    auto* box = new QWidget(this);
    QGridLayout* grid = gridOf(box);
    m_maps = new QComboBox(box);
    addChoice(m_maps, tr("Best of 2 to 8"), 0);
    for (int maps = minMaps; maps <= maxMaps; ++maps)
        addChoice(m_maps, QString::number(maps), maps);
    m_maps->setToolTip(
        tr("How many maps a suggestion has; in a range, a map is added only if it improves the fit enough"));
    m_maps->setAccessibleName(tr("Number of maps"));
    addRow(grid, tr("Maps:"), m_maps);
    m_seconds = new NumberBox(box);
    m_seconds->setRange(0.5, 600);
    m_seconds->setDecimals(1);
    m_seconds->setValue(2);
    m_seconds->setAccessibleName(tr("Seconds to search"));
    m_seconds->setToolTip(tr("How long to search for suggestions"));
    addRow(grid, tr("Seconds:"), m_seconds);
    m_seed = new WholeNumberBox(box);
    m_seed->setRange(1, 999'999);
    m_seed->setAccessibleName(tr("Seed of the random numbers"));
    m_seed->setToolTip(tr("Another seed gives another search"));
    addRow(grid, tr("Seed:"), m_seed);
    addConstraints(grid);
    return box;
}

// Adds constraints in the same columns.
void FitBox::addConstraints(QGridLayout* grid) {
    QWidget* box = grid->parentWidget();
    const auto check = [&](const QString& text, const QString& tip) {
        auto* made = new QCheckBox(text, box);
        made->setToolTip(tip);
        grid->addWidget(made, grid->rowCount(), 0, 1, 2);
        return made;
    };
    m_similarities = check(tr("Similarities only"), tr("Only maps that keep all angles"));
    m_noMirrors = check(tr("No mirror images"), tr("Only maps without reflection"));
    m_stem = check(tr("First map a stem"),
                   tr("The first map flattens the shape to a line, like the stem of a fern"));
    m_angles = new QComboBox(box);
    addChoice(m_angles, tr("Any"), 0);
    for (const int degrees : {60, 90})
        addChoice(m_angles, tr("Multiples of %1°").arg(degrees), degrees);
    m_angles->setAccessibleName(tr("Angles"));
    m_angles->setToolTip(tr("The angles by which the maps may rotate"));
    addRow(grid, tr("Angles:"), m_angles);
}

QPushButton* FitBox::taskButton(const QString& text, const QString& tip, Task task) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [this, task] { emit requested(task); });
    m_tasks.push_back(button);
    return button;
}

QWidget* FitBox::makeStart() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(
        taskButton(tr("Suggest"), tr("Find systems whose attractor looks like the target"), Task::Suggest));
    layout->addWidget(makeProgress());
    return box;
}

QWidget* FitBox::makeTasks() {
    auto* box = new QWidget(this);
    QGridLayout* grid = gridOf(box);
    grid->setColumnStretch(0, 1);
    grid->addWidget(taskButton(tr("Add a Map"), tr("Add a map where the agreement is worst"), Task::AddMap),
                    0, 0, 1, 2);
    grid->addWidget(taskButton(tr("Refine Maps"),
                               tr("Move the maps so that their images of the target cover it better"),
                               Task::RefineMaps),
                    1, 0);
    grid->addWidget(taskButton(tr("Refine Attractor"),
                               tr("Move the maps so that the attractor itself comes closer to the target"),
                               Task::RefineAttractor),
                    1, 1);
    grid->addWidget(taskButton(tr("Fit Weights"),
                               tr("Find the weights that reproduce the shades of the picture"),
                               Task::FitWeights),
                    2, 0);
    grid->addWidget(taskButton(tr("Fit Cage"),
                               tr("Deform the attractor by a cage so that its outline follows that of the "
                                  "target"),
                               Task::FitCage),
                    2, 1);
    m_selectedOnly = new QCheckBox(tr("Refine selected maps only"), box);
    m_selectedOnly->setToolTip(tr("The maps that are not selected stay as they are"));
    grid->addWidget(m_selectedOnly, 3, 0, 1, 2);
    m_lock = new QToolButton(box);
    m_lock->setCheckable(true);
    m_lock->setToolTip(tr("Locked maps stay as they are while others are refined"));
    connect(m_lock, &QToolButton::clicked, this, &FitBox::lockRequested);
    grid->addWidget(m_lock, 4, 0, 1, 2);
    m_corners = new WholeNumberBox(box);
    m_corners->setRange(3, 24);
    m_corners->setValue(8);
    m_corners->setAccessibleName(tr("Corners of the cage"));
    m_corners->setToolTip(tr("How many corners the fitted cage has"));
    addRow(grid, tr("Corners of the cage:"), m_corners);
    setLocks({}, false, false);
    return box;
}

QWidget* FitBox::makeProgress() {
    m_busy = new QWidget(this);
    auto* row = new QHBoxLayout(m_busy);
    row->setContentsMargins(0, 0, 0, 0);
    m_progress = new QProgressBar(m_busy);
    m_progress->setAccessibleName(tr("Progress"));
    auto* cancel = new QPushButton(tr("Cancel"), m_busy);
    cancel->setToolTip(tr("Stop without changing anything"));
    connect(cancel, &QPushButton::clicked, this, &FitBox::cancelled);
    m_escape = new QShortcut(QKeySequence(Qt::Key_Escape), parentWidget());
    m_escape->setContext(Qt::WidgetWithChildrenShortcut);
    connect(m_escape, &QShortcut::activated, this, [this] {
        if (QWidget* list = QApplication::activePopupWidget()) // the list gets the key
            list->close();
        else
            emit cancelled();
    });
    row->addWidget(m_progress, 1);
    row->addWidget(cancel);
    return m_busy;
}

collage::Constraints FitBox::constraints() const {
    collage::Constraints constraints;
    if (m_similarities->isChecked()) constraints.mapClass = collage::MapClass::Similarity;
    if (m_noMirrors->isChecked()) constraints.mirrors = collage::Mirrors::Excluded;
    if (m_stem->isChecked()) constraints.first = collage::FirstMap::Stem;
    constraints.angleStep = chosenValue<int>(m_angles);
    return constraints;
}

collage::SearchOptions FitBox::searchOptions() const {
    collage::SearchOptions options;
    const int maps = chosenValue<int>(m_maps);
    options.minMaps = maps > 0 ? maps : minMaps;
    options.maxMaps = maps > 0 ? maps : rangeEnd;
    options.constraints = constraints();
    options.seed = std::uint64_t(m_seed->value());
    options.time = std::chrono::duration<double>(m_seconds->value());
    options.threads = io::threadsOfThisMachine();
    return options;
}

bool FitBox::refinesSelectedOnly() const {
    return m_selectedOnly->isChecked();
}

int FitBox::cageCorners() const {
    return m_corners->value();
}

void FitBox::setPossible(bool possible) {
    m_isPossible = possible;
    enableTasks();
}

void FitBox::setLocks(const QString& names, bool areSelectedLocked, bool isAnySelected) {
    const QSignalBlocker blocker(m_lock);
    m_lock->setText(names.isEmpty() ? tr("Lock Selected Maps") : tr("Locked: %1").arg(names));
    m_lock->setChecked(areSelectedLocked);
    m_lock->setEnabled(isAnySelected);
}

void FitBox::setProgress(const std::optional<double>& share) {
    m_isBusy = share.has_value();
    m_progress->setRange(0, share && *share < 0 ? 0 : 100); // negative: unknown duration
    if (share && *share >= 0) m_progress->setValue(int(100 * *share));
    if (m_isBusy && m_busy->isHidden()) scrollIntoView(m_busy);
    m_busy->setVisible(m_isBusy);
    m_escape->setEnabled(m_isBusy);
    enableTasks();
}

void FitBox::enableTasks() {
    for (QPushButton* task : m_tasks)
        task->setEnabled(m_isPossible && !m_isBusy);
}

} // namespace view
