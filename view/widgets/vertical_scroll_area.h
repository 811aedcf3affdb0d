// SPDX-License-Identifier: MIT
#pragma once

#include <QEvent>
#include <QLayout>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace view {

// Scrolls a panel that needs more height than the window has. The scroll bar takes its place in the right
// margin of the panel, so that the panel needs no more width than without.
class VerticalScrollArea : public QScrollArea {
public:
    explicit VerticalScrollArea(QWidget* content, QWidget* parent = nullptr) : QScrollArea(parent) {
        setAccessibleName(content->accessibleName());
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus); // the content has the fields that take it
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        QMargins margins = content->layout()->contentsMargins();
        margins.setRight(std::max(margins.right(), verticalScrollBar()->sizeHint().width()));
        content->layout()->setContentsMargins(margins);
        setWidget(content);
    }

    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override {
        return {widget()->minimumSizeHint().width(), QScrollArea::minimumSizeHint().height()};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }
};

} // namespace view
