// SPDX-License-Identifier: MIT
#include "panels/appearance/palettes/gradient_strip.h"

#include "attractor/colour/palette_edits.h"
#include "panels/appearance/controls/appearance_colour_button.h"
#include "panels/appearance/palettes/gradient_preview.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace view {

namespace {

constexpr int barHeight = 22;
constexpr int inset = 9; // pixels for the handles at the ends
constexpr double handleHalf = 6;
constexpr std::chrono::milliseconds runPause{600};

} // namespace

GradientStrip::GradientStrip(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Stops of the gradient"));
    setToolTip(
        tr("Double-click: add a stop, or change the colour of one. Drag: move. Del: delete.\nKeys: Page Up "
           "and Page Down select a stop, the arrow keys move it, Ins adds one, Enter opens its colour."));
    m_settled.setSingleShot(true);
    m_settled.setInterval(runPause);
    connect(&m_settled, &QTimer::timeout, this, &GradientStrip::accepted);
}

void GradientStrip::setGradient(const attractor::Palette& gradient) {
    m_gradient = gradient;
    if (m_selected >= gradient.stops.size()) select(gradient.stops.empty() ? 0 : gradient.stops.size() - 1);
    describe();
    update();
}

void GradientStrip::select(std::size_t stop) {
    settle();
    m_selected = stop;
    describe();
    update();
    emit selectionChanged();
}

void GradientStrip::describe() {
    if (m_selected >= m_gradient.stops.size()) return;
    const auto& stop = m_gradient.stops[m_selected];
    setAccessibleDescription(tr("Stop %1 of %2 at %3 %, %4")
                                 .arg(m_selected + 1)
                                 .arg(m_gradient.stops.size())
                                 .arg(100 * stop.position, 0, 'f', 1)
                                 .arg(toColour(stop.colour).name()));
}

void GradientStrip::add(double position) {
    if (m_gradient.stops.size() < 2) return;
    settle();
    attractor::Palette changed = m_gradient;
    const std::size_t added = addStop(changed, position);
    emit tried(tr("Add a stop to the palette"), changed);
    emit accepted();
    select(added);
}

void GradientStrip::addAfterSelected() {
    if (m_gradient.stops.size() < 2) return;
    const std::size_t left = std::min(m_selected, m_gradient.stops.size() - 2);
    add((m_gradient.stops[left].position + m_gradient.stops[left + 1].position) / 2);
}

void GradientStrip::removeSelected() {
    if (!canMove(m_gradient, m_selected)) return;
    settle();
    attractor::Palette changed = m_gradient;
    removeStop(changed, m_selected);
    emit tried(tr("Delete a stop of the palette"), changed);
    emit accepted();
    select(std::min(m_selected, changed.stops.size() - 1));
}

void GradientStrip::move(double position) {
    attractor::Palette changed = m_gradient;
    moveStop(changed, m_selected, position);
    if (!(changed == m_gradient)) emit tried(tr("Move a stop of the palette"), changed);
}

void GradientStrip::settle() {
    if (!m_settled.isActive()) return;
    m_settled.stop();
    emit accepted();
}

QRectF GradientStrip::bar() const {
    return {double(inset), 1, double(std::max(1, width() - 2 * inset)), double(barHeight)};
}

double GradientStrip::positionAt(double x) const {
    return (x - bar().left()) / bar().width();
}

QPoint GradientStrip::handleOf(std::size_t stop) const {
    return QPointF(bar().left() + m_gradient.stops[stop].position * bar().width(), barHeight + 11).toPoint();
}

int GradientStrip::stopAt(const QPointF& point) const {
    int found = -1;
    double nearest = handleHalf + 3;
    for (std::size_t i = 0; i < m_gradient.stops.size(); ++i) {
        const double distance = std::abs(point.x() - handleOf(i).x());
        // Prefers the selected stop to others at its place.
        if (distance < nearest || (distance == nearest && i == m_selected)) {
            nearest = distance;
            found = int(i);
        }
    }
    return found;
}

void GradientStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!isEnabled()) painter.setOpacity(0.4);
    painter.drawPixmap(bar().topLeft(),
                       gradientPixmap(m_gradient, bar().size().toSize(), devicePixelRatioF()));
    const auto paintHandle = [&](std::size_t i) {
        const QPointF middle(bar().left() + m_gradient.stops[i].position * bar().width(), barHeight + 11);
        QPainterPath house;
        house.moveTo(middle + QPointF(0, -9));
        house.lineTo(middle + QPointF(handleHalf, -3));
        house.lineTo(middle + QPointF(handleHalf, 8));
        house.lineTo(middle + QPointF(-handleHalf, 8));
        house.lineTo(middle + QPointF(-handleHalf, -3));
        house.closeSubpath();
        QColor colour = toColour(m_gradient.stops[i].colour);
        colour.setAlpha(255);
        const bool chosen = i == m_selected;
        QColor rim = palette().color(QPalette::WindowText);
        rim.setAlphaF(chosen ? 1.0F : 0.45F);
        painter.setPen(QPen(chosen && hasFocus() ? palette().color(QPalette::Highlight) : rim,
                            chosen ? 2.0 : 1.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(colour);
        painter.drawPath(house);
    };
    for (std::size_t i = 0; i < m_gradient.stops.size(); ++i)
        if (i != m_selected) paintHandle(i);
    if (m_selected < m_gradient.stops.size()) paintHandle(m_selected);
}

void GradientStrip::mousePressEvent(QMouseEvent* event) {
    const int stop = stopAt(event->position());
    if (event->button() != Qt::LeftButton || stop < 0) return;
    select(std::size_t(stop));
    m_dragging = true;
    m_grip = event->position().x() - handleOf(m_selected).x();
}

void GradientStrip::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) move(positionAt(event->position().x() - m_grip));
}

void GradientStrip::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_dragging) return;
    m_dragging = false;
    emit accepted();
}

void GradientStrip::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_dragging = false;
    if (stopAt(event->position()) >= 0)
        emit colourWanted();
    else
        add(positionAt(event->position().x()));
}

void GradientStrip::keyPressEvent(QKeyEvent* event) {
    if (m_gradient.stops.empty()) return QWidget::keyPressEvent(event);
    const std::size_t last = m_gradient.stops.size() - 1;
    const bool choosing = event->modifiers() & Qt::ControlModifier;
    const double step = event->modifiers() & Qt::ShiftModifier ? 0.1 : 0.01;
    const auto neighbour = [&](int way) {
        select(std::size_t(std::clamp(int(m_selected) + way, 0, int(last))));
    };
    const auto nudge = [&](double by) {
        if (!canMove(m_gradient, m_selected)) return;
        m_settled.start();
        move(m_gradient.stops[m_selected].position + by);
    };
    switch (event->key()) {
    case Qt::Key_Left:
        return choosing ? neighbour(-1) : nudge(-step);
    case Qt::Key_Right:
        return choosing ? neighbour(1) : nudge(step);
    case Qt::Key_PageUp:
        return neighbour(-1);
    case Qt::Key_PageDown:
        return neighbour(1);
    case Qt::Key_Home:
        return select(0);
    case Qt::Key_End:
        return select(last);
    case Qt::Key_Insert:
    case Qt::Key_Plus:
        return addAfterSelected();
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return removeSelected();
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        return emit colourWanted();
    case Qt::Key_Escape:
        if (!m_dragging && !m_settled.isActive()) return QWidget::keyPressEvent(event);
        m_dragging = false;
        m_settled.stop();
        return emit rejected();
    default:
        QWidget::keyPressEvent(event);
    }
}

void GradientStrip::focusOutEvent(QFocusEvent* event) {
    settle();
    QWidget::focusOutEvent(event);
    update();
}

// The keys above are this widget's, even where the window has commands on them.
bool GradientStrip::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
        case Qt::Key_Insert:
        case Qt::Key_Plus:
        case Qt::Key_Space:
        case Qt::Key_Escape:
            event->accept();
            return true;
        default:
            break;
        }
    }
    return QWidget::event(event);
}

} // namespace view
