// SPDX-License-Identifier: MIT
#include "focus_walk.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QPointer>
#include <QToolBar>

#include <algorithm>

namespace {

constexpr auto lastFocus = "lastFocus"; // property of a part

bool canTake(const QWidget& widget) {
    return widget.isVisible() && widget.isEnabled() && widget.focusPolicy() & Qt::TabFocus;
}

QWidget* firstIn(QWidget* part) {
    if (canTake(*part)) return part;
    const auto last = part->property(lastFocus).value<QPointer<QWidget>>();
    if (last && part->isAncestorOf(last) && canTake(*last)) return last;
    for (QWidget* next = part->nextInFocusChain(); next != part; next = next->nextInFocusChain())
        if (part->isAncestorOf(next) && canTake(*next)) return next;
    return nullptr;
}

// Parts that can take the focus, in the order in which they are visited.
QWidgetList parts(QMainWindow& window) {
    QWidgetList found{window.centralWidget()};
    for (const Qt::DockWidgetArea area :
         {Qt::LeftDockWidgetArea, Qt::TopDockWidgetArea, Qt::RightDockWidgetArea, Qt::BottomDockWidgetArea}) {
        QWidgetList panels;
        for (auto* panel : window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
            if (window.dockWidgetArea(panel) == area && !panel->isFloating() &&
                !panel->visibleRegion().isEmpty())
                panels << panel;
        std::ranges::sort(panels, {}, [](const QWidget* panel) { return std::pair(panel->y(), panel->x()); });
        found << panels;
    }
    QWidgetList bars;
    for (auto* bar : window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly))
        if (bar->isVisible()) bars << bar;
    std::ranges::sort(bars, {}, [](const QWidget* bar) { return std::pair(bar->y(), bar->x()); });
    found << bars;
    found.removeIf([](QWidget* part) { return firstIn(part) == nullptr; });
    return found;
}

} // namespace

void walkFocus(QMainWindow& window, int step) {
    const QWidgetList all = parts(window);
    if (all.isEmpty()) return;
    QWidget* focused = QApplication::focusWidget();
    const auto current = std::ranges::find_if(all, [&](const QWidget* part) {
        return part == focused || (focused && part->isAncestorOf(focused));
    });
    qsizetype next = 0;
    if (current != all.end()) {
        (*current)->setProperty(lastFocus, QVariant::fromValue(QPointer<QWidget>(focused)));
        next = (current - all.begin() + step + all.size()) % all.size();
    }
    window.setAttribute(Qt::WA_KeyboardFocusChange); // set as by Tab, so that styles show the focus
    firstIn(all[next])->setFocus(step > 0 ? Qt::TabFocusReason : Qt::BacktabFocusReason);
}
