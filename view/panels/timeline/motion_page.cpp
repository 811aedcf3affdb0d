// SPDX-License-Identifier: MIT
#include "panels/timeline/motion_page.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace view {

namespace {

constexpr int iconSide = 32;

QToolButton* tile(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setIconSize({iconSide, iconSide});
    button->setAutoRaise(true);
    button->setAccessibleName(action->text().remove(u'&').remove(u'…'));
    button->setFocusPolicy(Qt::StrongFocus);
    button->setMinimumWidth(14 * button->fontMetrics().averageCharWidth());
    return button;
}

} // namespace

MotionPage::MotionPage(const QList<QAction*>& actions, QWidget* parent) : QWidget(parent) {
    auto* tiles = new QHBoxLayout;
    tiles->setSpacing(4);
    for (QAction* action : actions)
        tiles->addWidget(tile(action));
    tiles->addStretch(1);
    auto* keys = new QPushButton(tr("Make Keys"));
    keys->setToolTip(tr("Show the tracks, to make keys of your own"));
    keys->setAutoDefault(false);
    auto* how = new QLabel(tr("Or set a key, move the playhead, and change the fractal."));
    how->setWordWrap(true);
    auto* below = new QHBoxLayout;
    below->addWidget(how, 1);
    below->addWidget(keys);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->addWidget(new QLabel(tr("Nothing moves yet. Choose a motion:")));
    column->addLayout(tiles);
    column->addLayout(below);
    column->addStretch(1);
    connect(keys, &QPushButton::clicked, this, &MotionPage::tableWanted);
}

} // namespace view
