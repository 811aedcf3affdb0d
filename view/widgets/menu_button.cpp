// SPDX-License-Identifier: MIT
#include "widgets/menu_button.h"

#include <QStyleOptionToolButton>
#include <QStylePainter>

namespace view {

namespace {

constexpr int arrow = 10; // pixels
constexpr int margin = 4;

} // namespace

MenuButton::MenuButton(QWidget* parent) : QToolButton(parent) {
    setPopupMode(QToolButton::InstantPopup);
}

QSize MenuButton::sizeHint() const {
    return QToolButton::sizeHint() + QSize(arrow, 0);
}

void MenuButton::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    option.features &= ~QStyleOptionToolButton::ToolButtonFeatures(QStyleOptionToolButton::HasMenu);
    painter.drawComplexControl(QStyle::CC_ToolButton, option);
    const QRect area(width() - arrow - margin, (height() - arrow) / 2, arrow, arrow);
    option.rect = QStyle::visualRect(layoutDirection(), rect(), area);
    painter.drawPrimitive(QStyle::PE_IndicatorArrowDown, option);
}

} // namespace view
