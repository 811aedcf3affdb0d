// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>
#include <QEvent>
#include <QLayout>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>

namespace view {

// Scrolls a panel that needs more height than the window has. The scroll bar takes its place in the right
// margin of the panel, so that the panel needs no more width than without; or it stands beside a part of a
// panel, which keeps its margins.
class VerticalScrollArea : public QScrollArea {
public:
    enum class Bar { InMargin, Beside };

    explicit VerticalScrollArea(QWidget* content, QWidget* parent = nullptr, Bar bar = Bar::InMargin)
        : QScrollArea(parent), m_bar(bar) {
        setAccessibleName(content->accessibleName());
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus); // focus goes to the fields of the content
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        if (bar == Bar::InMargin) {
            QMargins margins = content->layout()->contentsMargins();
            margins.setRight(std::max(margins.right(), verticalScrollBar()->sizeHint().width()));
            content->layout()->setContentsMargins(margins);
        } else {
            setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
        }
        setWidget(content);
    }

    // Widgets under one another, as high as they need to be where there is room.
    static VerticalScrollArea* ofRows(std::initializer_list<QWidget*> rows, QWidget* parent) {
        auto* content = new QWidget(parent);
        auto* layout = new QVBoxLayout(content);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(6);
        for (QWidget* row : rows)
            layout->addWidget(row);
        return new VerticalScrollArea(content, parent, Bar::Beside);
    }

    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override {
        const int beside = m_bar == Bar::Beside ? verticalScrollBar()->sizeHint().width() : 0;
        return {widget()->minimumSizeHint().width() + beside, QScrollArea::minimumSizeHint().height()};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }

private:
    Bar m_bar;
};

// Holds a panel that needs more height than a small screen can give to one: there the panel scrolls.
class PanelArea : public QScrollArea {
public:
    explicit PanelArea(QWidget* panel) {
        setAccessibleName(panel->accessibleName());
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        setWidget(panel);
        connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, [this] { updateGeometry(); });
    }

    QSize sizeHint() const override { return widget()->sizeHint(); }
    // The scroll bar takes its width from the picture only while there is one.
    QSize minimumSizeHint() const override {
        // Share of the screen, so that two areas fit above each other with the bars.
        constexpr double share = 0.26;
        const QSize needed = widget()->minimumSizeHint().expandedTo(widget()->minimumSize());
        const int most = int(share * screen()->availableSize().height());
        const int bar = verticalScrollBar()->maximum() > 0 ? verticalScrollBar()->sizeHint().width() : 0;
        return {needed.width() + bar, std::min(needed.height(), most)};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }
};

// Scrolls the areas around the widget to show all of it, once it has its place.
inline void scrollIntoView(QWidget* widget) {
    QTimer::singleShot(0, widget, [widget] {
        for (QWidget* at = widget->parentWidget(); at != nullptr; at = at->parentWidget()) {
            if (at->layout() != nullptr)
                at->layout()->activate(); // immediate layout; layouts would notify their parents only later
            if (auto* area = qobject_cast<QScrollArea*>(at)) {
                QEvent request(QEvent::LayoutRequest); // tells the area about the new layout
                QCoreApplication::sendEvent(area, &request);
                area->ensureWidgetVisible(widget, 0);
            }
        }
    });
}

} // namespace view
