// SPDX-License-Identifier: MIT
#include "panels/links/link_graph.h"

#include "panels/links/links_model.h"

#include <QAccessible>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr std::size_t manyArrows = 240; // limit; more arrows are shown for one map at a time
constexpr int usualSide = 240, minSide = 120;

QColor mixed(const QColor& a, const QColor& b, double t) {
    return QColor::fromRgbF(float(a.redF() + (b.redF() - a.redF()) * t),
                            float(a.greenF() + (b.greenF() - a.greenF()) * t),
                            float(a.blueF() + (b.blueF() - a.blueF()) * t));
}

QColor textOn(const QColor& ground) {
    const double light = 0.299 * ground.redF() + 0.587 * ground.greenF() + 0.114 * ground.blueF();
    return light > 0.55 ? QColor(20, 20, 24) : QColor(Qt::white);
}

} // namespace

LinkGraph::LinkGraph(LinksModel* model, QWidget* parent) : QWidget(parent), m_model(model) {
    setAccessibleName(tr("Graph of links"));
    setToolTip(
        tr("Drag from one map to another to link them; click an arrow and press Delete to remove it."));
    setWhatsThis(
        tr("Each circle is a map, and an arrow leads to each map that may follow it in the chaos game; "
           "thicker arrows have more weight. Drag from one map to another to link them, or out of a map "
           "and back to link it to itself. Click an arrow and press Delete to remove it, or double-click "
           "it to enter its weight. With the keyboard: Left and Right walk through the maps, Up and Down "
           "through the arrows of a map; Space begins a new arrow, Left and Right choose its end, Enter "
           "adds it. Maps with a dashed ring take no part; the reason is shown beside them."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    connect(model, &QAbstractItemModel::modelReset, this, [this] {
        m_map = m_to = m_pulledFrom = m_keyTarget = -1;
        lay();
    });
    connect(model, &QAbstractItemModel::dataChanged, this, &LinkGraph::lay);
    lay();
}

QSize LinkGraph::sizeHint() const {
    return {usualSide, usualSide};
}

QSize LinkGraph::minimumSizeHint() const {
    return {minSide, minSide};
}

void LinkGraph::lay() {
    const int maps = m_model->rowCount();
    const auto& matrix = m_model->matrix();
    const auto arrows = std::size_t(std::ranges::count_if(matrix, [](double weight) { return weight > 0; }));
    if (m_map >= maps) m_map = m_to = -1;
    if (m_to >= 0 && !isLinked(m_map, m_to)) m_to = -1;
    m_layout = LinkLayout(size(), maps, matrix, arrows > manyArrows ? std::max(m_map, 0) : -1);
    describe();
    update();
}

bool LinkGraph::isLinked(int from, int to) const {
    return m_model->weight(from, to) > 0;
}

void LinkGraph::select(int from, int to) {
    const bool exists = from >= 0 && from < m_model->rowCount() && to >= 0 && to < m_model->rowCount();
    const int shown = exists && isLinked(from, to) ? to : -1;
    if (from == m_map && shown == m_to) return;
    m_map = from;
    m_to = shown;
    lay();
}

void LinkGraph::choose(int from, int to) {
    select(from, to);
    if (from >= 0) emit selected(from, to);
}

// Describes the graph to screen readers.
void LinkGraph::describe() {
    QString text = tr("No map is selected.");
    if (m_keyTarget >= 0)
        text = tr("New arrow from map %1 to map %2. Enter adds it, Esc cancels.")
                   .arg(m_map + 1)
                   .arg(m_keyTarget + 1);
    else if (m_to >= 0)
        text = m_model->index(m_map, m_to).data(Qt::AccessibleTextRole).toString();
    else if (m_map >= 0)
        text = tr("Map %1: %2").arg(m_map + 1).arg(m_model->reason(m_map));
    if (text == accessibleDescription()) return;
    setAccessibleDescription(text);
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
}

void LinkGraph::link(int from, int to) {
    if (!isLinked(from, to)) m_model->setWeight(from, to, 1);
    choose(from, to);
}

void LinkGraph::removeSelected() {
    if (m_to < 0) return;
    const int from = m_map, to = m_to;
    m_model->setWeight(from, to, 0);
    choose(from, -1);
}

void LinkGraph::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    m_keyTarget = -1;
    m_pointer = event->position();
    if (const int map = m_layout.nodeAt(m_pointer); map >= 0) {
        m_pulledFrom = map;
        m_hasLeft = false;
        return choose(map, -1);
    }
    const int arrow = m_layout.arrowAt(m_pointer);
    if (arrow < 0) return choose(m_map, -1);
    const LinkLayout::Arrow& hit = m_layout.arrows()[std::size_t(arrow)];
    choose(hit.from, hit.to);
}

void LinkGraph::mouseMoveEvent(QMouseEvent* event) {
    m_pointer = event->position();
    const int over = m_layout.nodeAt(m_pointer);
    if (m_pulledFrom < 0) {
        const bool isHit = over >= 0 || m_layout.arrowAt(m_pointer) >= 0;
        return setCursor(isHit ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
    m_hasLeft = m_hasLeft || over != m_pulledFrom;
    update();
}

void LinkGraph::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_pulledFrom < 0) return;
    const int from = std::exchange(m_pulledFrom, -1), to = m_layout.nodeAt(event->position());
    update();
    if (m_hasLeft && to >= 0) link(from, to);
}

void LinkGraph::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event);
    if (m_to < 0) return;
    m_pulledFrom = -1;
    emit editWanted(m_map, m_to);
}

void LinkGraph::walkMaps(int step) {
    const int maps = m_model->rowCount();
    if (maps == 0) return;
    int& walking = m_keyTarget >= 0 ? m_keyTarget : m_map;
    const int next = walking < 0 ? 0 : (walking + step + maps) % maps;
    if (m_keyTarget < 0) return choose(next, -1);
    m_keyTarget = next;
    describe();
    update();
}

void LinkGraph::walkArrows(int step) {
    if (m_map < 0 || m_keyTarget >= 0) return;
    const int maps = m_model->rowCount();
    int to = m_to < 0 && step < 0 ? 0 : m_to;
    for (int tried = 0; tried < maps; ++tried) {
        to = (to + step + maps) % maps;
        if (isLinked(m_map, to)) return choose(m_map, to);
    }
}

void LinkGraph::keyPressEvent(QKeyEvent* event) {
    const bool isNew = m_keyTarget >= 0;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        return walkMaps(event->key() == Qt::Key_Left ? -1 : 1);
    case Qt::Key_Up:
    case Qt::Key_Down:
        return walkArrows(event->key() == Qt::Key_Up ? -1 : 1);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return removeSelected();
    case Qt::Key_Space:
        if (m_map < 0 || isNew) return;
        m_keyTarget = m_map;
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (isNew) return link(m_map, std::exchange(m_keyTarget, -1));
        if (m_to >= 0) emit editWanted(m_map, m_to);
        return;
    case Qt::Key_Escape:
        if (!isNew && m_pulledFrom < 0) return QWidget::keyPressEvent(event);
        m_keyTarget = m_pulledFrom = -1;
        break;
    default:
        return QWidget::keyPressEvent(event);
    }
    describe();
    update();
}

QString LinkGraph::tipAt(const QPoint& position) const {
    if (const int map = m_layout.nodeAt(position); map >= 0)
        return tr("Map %1: %2").arg(map + 1).arg(m_model->reason(map));
    const int arrow = m_layout.arrowAt(position);
    if (arrow < 0) return toolTip();
    const LinkLayout::Arrow& hit = m_layout.arrows()[std::size_t(arrow)];
    return m_model->index(hit.from, hit.to).data(Qt::ToolTipRole).toString();
}

// Keys that are ours before they are a command of the window.
bool LinkGraph::takes(int key) const {
    switch (key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return m_to >= 0;
    case Qt::Key_Space:
        return m_map >= 0;
    case Qt::Key_Escape:
        return m_keyTarget >= 0 || m_pulledFrom >= 0;
    default:
        return false;
    }
}

bool LinkGraph::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && takes(static_cast<QKeyEvent*>(event)->key())) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void LinkGraph::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    lay();
}

void LinkGraph::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::EnabledChange) update();
}

void LinkGraph::paintArrows(QPainter& painter) const {
    const QColor ground = palette().color(QPalette::Base), ink = palette().color(QPalette::Text);
    const auto paint = [&](const LinkLayout::Arrow& arrow, const QColor& colour, double more) {
        painter.setPen(QPen(colour, arrowWidth(arrow.weight) + more, Qt::SolidLine, Qt::FlatCap));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(arrow.line);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawPolygon(arrow.head);
    };
    const LinkLayout::Arrow* chosen = nullptr;
    for (const LinkLayout::Arrow& arrow : m_layout.arrows()) {
        const bool isOfMap = arrow.from == m_map;
        if (isOfMap && arrow.to == m_to) chosen = &arrow;
        paint(arrow, mixed(ink, ground, isOfMap ? 0.15 : 0.5), 0);
    }
    if (chosen) paint(*chosen, palette().color(QPalette::Highlight), 1.5);
}

void LinkGraph::paintNode(QPainter& painter, int map) const {
    const QColor ground = palette().color(QPalette::Base), ink = palette().color(QPalette::Text);
    const double r = m_layout.nodeRadius();
    const QPointF at = m_layout.node(map);
    const bool takesPart = m_model->state(map) == ifs::LinkState::TakesPart;
    const QColor colour = m_model->colour(map);
    painter.setPen(takesPart ? QPen(mixed(ink, colour, 0.4), 1.2) : QPen(ink, 1.2, Qt::DashLine));
    painter.setBrush(takesPart ? colour : ground);
    painter.drawEllipse(at, r, r);
    if (map == m_map || map == m_keyTarget) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), hasFocus() ? 2.5 : 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, r + 3, r + 3);
    }
    QFont font = this->font();
    font.setPixelSize(std::max(7, int(r * (map < 99 ? 1.05 : 0.8))));
    painter.setFont(font);
    painter.setPen(takesPart ? textOn(colour) : ink);
    if (r >= 7)
        painter.drawText(QRectF(at.x() - 2 * r, at.y() - r, 4 * r, 2 * r), Qt::AlignCenter,
                         QString::number(map + 1));
    if (takesPart) return;
    painter.setFont(this->font());
    const QString why = m_model->reason(map).section(u':', 0, 0);
    QRectF place = painter.fontMetrics().boundingRect(why).toRectF().adjusted(-3, -1, 3, 1);
    place.moveCenter(at - (r + place.height() / 2 + 5) * m_layout.outwards(map));
    place.moveLeft(std::clamp(place.left(), 0.0, std::max(0.0, width() - place.width())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRect(place);
    painter.setPen(ink);
    painter.drawText(place, Qt::AlignCenter, why);
}

void LinkGraph::paintPull(QPainter& painter) const {
    const int from = m_pulledFrom >= 0 ? m_pulledFrom : m_map;
    const bool isPulled = m_pulledFrom >= 0 && m_hasLeft;
    if (!isPulled && m_keyTarget < 0) return;
    const QPointF end = isPulled ? m_pointer : m_layout.node(m_keyTarget);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2, Qt::DashLine));
    painter.drawLine(m_layout.node(from), end);
    const int over = isPulled ? m_layout.nodeAt(m_pointer) : m_keyTarget;
    painter.setBrush(Qt::NoBrush);
    if (over >= 0)
        painter.drawEllipse(m_layout.node(over), m_layout.nodeRadius() + 3, m_layout.nodeRadius() + 3);
}

void LinkGraph::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setPen(hasFocus() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Mid));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    paintArrows(painter);
    paintPull(painter);
    for (int map = 0; map < m_layout.maps(); ++map)
        paintNode(painter, map);
}

} // namespace view
