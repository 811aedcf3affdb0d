// SPDX-License-Identifier: MIT
#include "room_for_picture.h"

#include <QDockWidget>
#include <QMainWindow>

namespace {

constexpr char gaveWay[] = "gaveWay"; // a property of panels that were hidden for the picture

bool isSmall(const QMainWindow& window) {
    return window.width() <= 800 && window.height() <= 600;
}

QList<QDockWidget*> panelsOf(const QMainWindow& window) {
    return window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly);
}

void hideLeftPanels(QMainWindow& window) {
    for (QDockWidget* panel : panelsOf(window))
        if (window.dockWidgetArea(panel) == Qt::LeftDockWidgetArea && !panel->isFloating() &&
            !panel->isHidden()) {
            panel->hide();
            panel->setProperty(gaveWay, true);
        }
}

} // namespace

void makeRoomForPicture(QMainWindow& window, const QWidget& picture) {
    if (isSmall(window)) hideLeftPanels(window);
    const int missing = window.width() / 2 - picture.width();
    if (missing <= 0) return;
    QList<QDockWidget*> beside;
    int together = 0;
    for (const Qt::DockWidgetArea area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea})
        for (QDockWidget* panel : panelsOf(window))
            if (window.dockWidgetArea(panel) == area && !panel->isFloating() &&
                !panel->visibleRegion().isEmpty()) {
                beside << panel;
                together += panel->width();
                break;
            }
    if (together <= 0) return;
    QList<int> widths;
    for (const QDockWidget* panel : beside)
        widths << panel->width() - missing * panel->width() / together;
    window.resizeDocks(beside, widths, Qt::Horizontal);
}

void giveRoomBack(QMainWindow& window) {
    if (!isSmall(window)) showHiddenPanels(window);
}

void showHiddenPanels(QMainWindow& window) {
    for (QDockWidget* panel : panelsOf(window))
        if (panel->property(gaveWay).toBool()) {
            panel->setProperty(gaveWay, false);
            panel->show();
        }
}
