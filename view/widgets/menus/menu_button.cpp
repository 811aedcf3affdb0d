// SPDX-License-Identifier: MIT
#include "widgets/menus/menu_button.h"

#include <QStyleOptionToolButton>
#include <QStylePainter>

namespace view {

namespace {

constexpr int arrow = 10; // pixels
constexpr int margin = 4;
constexpr int gap = 4; // pixels between text and arrow

} // namespace

MenuButton::MenuButton(QWidget* parent) : QToolButton(parent) {
    setPopupMode(QToolButton::InstantPopup);
}

// The style knows of no menu: it would draw its own arrow.
void MenuButton::initStyleOption(QStyleOptionToolButton* option) const {
    QToolButton::initStyleOption(option);
    option->features.setFlag(QStyleOptionToolButton::HasMenu, false);
}

QSize MenuButton::sizeHint() const {
    return QToolButton::sizeHint() + QSize(arrow + gap, 0);
}

QRect MenuButton::labelRect() const {
    return QStyle::visualRect(layoutDirection(), rect(), rect().adjusted(0, 0, -(arrow + gap), 0));
}

QRect MenuButton::arrowRect() const {
    const QRect area(width() - arrow - margin, (height() - arrow) / 2, arrow, arrow);
    return QStyle::visualRect(layoutDirection(), rect(), area);
}

void MenuButton::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    QStyleOptionToolButton panel = option;
    panel.text.clear();
    panel.icon = {};
    painter.drawComplexControl(QStyle::CC_ToolButton, panel);
    QStyleOptionToolButton label = option;
    label.rect = labelRect();
    painter.drawControl(QStyle::CE_ToolButtonLabel, label);
    option.rect = arrowRect();
    painter.drawPrimitive(QStyle::PE_IndicatorArrowDown, option);
}

} // namespace view
