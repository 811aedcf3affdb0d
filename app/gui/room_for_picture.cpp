// SPDX-License-Identifier: MIT
#include "room_for_picture.h"

#include <QDockWidget>
#include <QEvent>
#include <QGuiApplication>
#include <QMainWindow>
#include <QTabBar>

#include <algorithm>

namespace {

constexpr char gaveWay[] = "gaveWay"; // property of panels that were hidden for the picture
constexpr double least = 0.4; // share of the window that a layout made by the user leaves to the picture

// The width of a panel with the names of those that share its place: the window divides its room among both.
int widthOf(const QDockWidget* panel) {
    int width = panel->width();
    for (const auto* names : panel->parentWidget()->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
        const QRect bar = names->geometry(), box = panel->geometry();
        const bool isBeside = bar.left() == box.right() + 1 || bar.right() == box.left() - 1;
        if (names->isVisible() && isBeside && bar.top() <= box.bottom() && box.top() <= bar.bottom())
            width += bar.width();
    }
    return width;
}

} // namespace

RoomForPicture::RoomForPicture(QMainWindow* window, const QWidget* picture)
    : QObject(window), m_window(window), m_picture(picture) {}

bool RoomForPicture::isSmall() const {
    return m_window->width() <= 800 && m_window->height() <= 600;
}

QList<QDockWidget*> RoomForPicture::panels() const {
    return m_window->findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly);
}

QList<QDockWidget*> RoomForPicture::columns() const {
    QList<QDockWidget*> found;
    for (const Qt::DockWidgetArea area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea})
        for (QDockWidget* panel : panels())
            if (m_window->dockWidgetArea(panel) == area && !panel->isFloating() &&
                panel->features() != QDockWidget::NoDockWidgetFeatures && // not fixed, like a lesson's text
                !panel->visibleRegion().isEmpty()) {
                found << panel;
                break;
            }
    return found;
}

void RoomForPicture::hideLeftPanels() {
    QStringList titles;
    for (QDockWidget* panel : panels())
        if (m_window->dockWidgetArea(panel) == Qt::LeftDockWidgetArea && !panel->isFloating() &&
            !panel->isHidden()) {
            panel->hide();
            panel->setProperty(gaveWay, true);
            titles << panel->windowTitle();
            m_hasYielded = true;
        }
    if (!titles.isEmpty()) emit hidden(titles);
}

bool RoomForPicture::showHiddenPanels() {
    bool hasShown = false;
    for (QDockWidget* panel : panels())
        if (panel->property(gaveWay).toBool()) {
            panel->setProperty(gaveWay, false);
            panel->show();
            hasShown = true;
        }
    return hasShown;
}

void RoomForPicture::rememberWidths() {
    for (QDockWidget* column : columns())
        m_widths[m_window->dockWidgetArea(column)] = widthOf(column);
}

// Follows the user, who makes panels wider and narrower while the window keeps its size.
bool RoomForPicture::eventFilter(QObject* watched, QEvent* event) {
    const bool isDragged = QGuiApplication::mouseButtons().testFlag(Qt::LeftButton);
    if (event->type() == QEvent::Resize && m_window->size() == m_size && (isDragged || !m_hasYielded)) {
        rememberWidths();
        m_hasYielded = false;
    }
    return QObject::eventFilter(watched, event);
}

void RoomForPicture::windowShown(bool isAsItWasLeft) {
    for (QDockWidget* panel : panels())
        panel->installEventFilter(this);
    if (!m_hasYielded) rememberWidths(); // remembered for the next time
    if (isSmall()) hideLeftPanels();
    if (!isAsItWasLeft || m_picture->width() < least * m_window->width()) divide();
    m_size = m_window->size();
}

void RoomForPicture::windowResized(const QSize& before) {
    m_size = {}; // unset until the panels have their places
    const bool isNarrower = m_window->width() < before.width();
    if (isNarrower && isSmall()) hideLeftPanels();
    const bool appear = !isNarrower && !isSmall() && showHiddenPanels();
    const auto settle = [this, mayYield = isNarrower || appear] {
        if (mayYield || m_hasYielded) divide();
        m_size = m_window->size();
    };
    if (appear) // appearing panels are laid out first
        QMetaObject::invokeMethod(this, settle, Qt::QueuedConnection);
    else
        settle();
}

// Gives panels their former widths if half of the window is enough for that; else they become only as narrow
// as they must be.
void RoomForPicture::divide() {
    const QList<QDockWidget*> columns = this->columns();
    const int spare = m_picture->width() - m_window->width() / 2;
    if (columns.isEmpty() || (!m_hasYielded && spare >= 0)) return;
    int together = 0;
    double wanted = 0;
    QList<int> widths;
    for (QDockWidget* column : columns) {
        together += widthOf(column);
        widths << m_widths.value(m_window->dockWidgetArea(column), widthOf(column));
        wanted += widths.last();
    }
    const double share = std::clamp((together + spare) / wanted, 0.0, 1.0);
    for (int& width : widths)
        width = int(share * width);
    m_hasYielded = share < 1;
    m_window->resizeDocks(columns, widths, Qt::Horizontal);
}
