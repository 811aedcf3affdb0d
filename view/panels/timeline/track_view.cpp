// SPDX-License-Identifier: MIT
#include "panels/timeline/track_view.h"

#include "desktop/settings.h"
#include "panels/timeline/key_mark.h"
#include "panels/timeline/timeline.h"
#include "panels/timeline/track_menu.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

using document::KeyAt;
using document::KeyMove;

namespace {

constexpr double minScale = 0.01, maxScale = 64; // pixels per frame
constexpr int edge = 12;                         // pixels left of frame 0 and right of the last one
constexpr double reach = 8;                      // pixels around a diamond
constexpr int snapReach = 6;                     // pixels
constexpr char unitSetting[] = "timeline/seconds";

} // namespace

TrackView::TrackView(Timeline* timeline, QWidget* parent)
    : QAbstractScrollArea(parent), m_timeline(timeline), m_unit(new QToolButton(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Tracks and keys"));
    setWhatsThis(tr(
        "One row for each part that can move. The diamond on the left sets a key at the "
        "playhead, or deletes it. Drag keys to move them: Alt moves all later ones too, Ctrl "
        "copies. Drag in the ruler to move the playhead, or from an empty area to select keys. "
        "Ctrl + wheel zooms. Right-click a key for its ease. Round keys are smooth: the motion runs "
        "through them without a corner. Double-click a motion to change its strength or number of turns."));
    viewport()->setMouseTracking(false);
    m_unit->setCheckable(true);
    m_unit->setAutoRaise(true);
    m_unit->setFocusPolicy(Qt::NoFocus);
    m_unit->setAccessibleName(tr("Unit of the ruler"));
    m_unit->setToolTip(tr("Switch the ruler between frames and seconds"));
    m_unit->setChecked(stored(QLatin1String(unitSetting), false).toBool());
    const auto showUnit = [this] {
        m_unit->setText(m_unit->isChecked() ? tr("Seconds") : tr("Frames"));
        viewport()->update();
    };
    showUnit();
    connect(m_unit, &QToolButton::toggled, this, [showUnit](bool on) {
        store(QLatin1String(unitSetting), on);
        showUnit();
    });
    connect(timeline, &Timeline::changed, this, [this] {
        layOut();
        refresh();
    });
    connect(timeline, &Timeline::frameChanged, this, [this] {
        if (m_drag != Drag::Playhead && hasFocus()) revealPlayhead();
        refresh();
    });
    connect(timeline, &Timeline::selectionChanged, this, &TrackView::refresh);
    layOut();
    describe();
}

QSize TrackView::sizeHint() const {
    return {namesWidth() + 60 * fontMetrics().averageCharWidth(), 7 * rowHeight()};
}

QSize TrackView::minimumSizeHint() const {
    return {namesWidth() + 20 * fontMetrics().averageCharWidth(), 3 * rowHeight()};
}

int TrackView::rowHeight() const {
    return std::max(22, fontMetrics().height() + 8);
}

int TrackView::namesWidth() const {
    int widest = std::max(m_unit->sizeHint().width(), 14 * fontMetrics().averageCharWidth());
    for (int row = 0; row < std::min(m_timeline->rowCount(), 40); ++row)
        widest = std::max(widest, fontMetrics().horizontalAdvance(m_timeline->rowName(row)));
    return std::min(widest, 30 * fontMetrics().averageCharWidth()) + rowHeight() + 26;
}

int TrackView::left() const {
    return namesWidth() + edge;
}

double TrackView::xOf(double frame) const {
    return left() + frame * m_scale - horizontalScrollBar()->value();
}

int TrackView::frameAt(double x) const {
    return int(std::lround((x - left() + horizontalScrollBar()->value()) / m_scale));
}

int TrackView::topOf(int row) const {
    return (row + 1) * rowHeight() - verticalScrollBar()->value();
}

int TrackView::rowAt(double y) const {
    if (y < rowHeight()) return -1;
    return std::min(int(y + verticalScrollBar()->value()) / rowHeight() - 1, m_timeline->rowCount());
}

QPoint TrackView::keyPosition(int row, int frame) const {
    return QPointF(xOf(frame), topOf(row) + rowHeight() / 2.0).toPoint();
}

QPoint TrackView::rulerPosition(int frame) const {
    return QPointF(xOf(frame), rowHeight() / 2.0).toPoint();
}

QPoint TrackView::toggleOf(int row) const {
    return {rowHeight() / 2 + 2, topOf(row) + rowHeight() / 2};
}

void TrackView::fitLength() {
    m_isFitted = true;
    layOut();
    viewport()->update();
}

void TrackView::layOut() {
    const QSize size = viewport()->size();
    const int width = std::max(1, size.width() - left() - edge);
    const int length = m_timeline->timing().length;
    if (m_isFitted) m_scale = std::clamp(double(width) / length, minScale, maxScale);
    horizontalScrollBar()->setRange(0, std::max(0, int(std::ceil(length * m_scale)) - width));
    horizontalScrollBar()->setPageStep(width);
    horizontalScrollBar()->setSingleStep(std::max(1, int(m_scale)));
    const int height = size.height() - rowHeight();
    const int down = m_down; // limited by the present rows; m_down stays for rows that undo brings back
    verticalScrollBar()->setRange(0, std::max(0, m_timeline->rowCount() * rowHeight() - height));
    verticalScrollBar()->setValue(down);
    m_down = down;
    verticalScrollBar()->setPageStep(height);
    verticalScrollBar()->setSingleStep(rowHeight());
    m_unit->setGeometry(2, 1, namesWidth() - 4, rowHeight() - 2);
}

void TrackView::zoomAt(double x, double factor) {
    const double frame = (x - left() + horizontalScrollBar()->value()) / m_scale;
    m_isFitted = false;
    m_scale = std::clamp(m_scale * factor, minScale, maxScale);
    layOut();
    horizontalScrollBar()->setValue(int(std::lround(frame * m_scale - x + left())));
    viewport()->update();
}

void TrackView::revealPlayhead() {
    const double x = xOf(m_timeline->frame());
    QScrollBar* across = horizontalScrollBar();
    if (x < left() || x > viewport()->width() - edge)
        across->setValue(int(m_timeline->frame() * m_scale) - across->pageStep() / 2);
}

void TrackView::reveal() {
    revealPlayhead();
    QScrollBar* down = verticalScrollBar();
    const int top = m_timeline->row() * rowHeight();
    if (top < down->value()) down->setValue(top);
    if (top + rowHeight() > down->value() + down->pageStep())
        down->setValue(top + rowHeight() - down->pageStep());
}

// Describes the place of the keyboard to screen readers.
void TrackView::describe() {
    const int row = m_timeline->row();
    if (row >= m_timeline->rowCount()) return setAccessibleDescription({});
    QString said = tr("%1, frame %2").arg(m_timeline->rowName(row), QString::number(m_timeline->frame()));
    if (m_timeline->hasKey(row, m_timeline->frame())) said += tr(", key");
    if (m_timeline->isTrack(row))
        said += tr(", keys in this row: %1").arg(m_timeline->tracks()[std::size_t(row)].keys.size());
    setAccessibleDescription(said);
}

std::optional<KeyAt> TrackView::keyAt(const QPointF& point) const {
    const int row = rowAt(point.y());
    if (!m_timeline->isTrack(row) || point.x() < namesWidth()) return std::nullopt;
    const auto& one = m_timeline->tracks()[std::size_t(row)];
    std::optional<KeyAt> found;
    double nearest = reach;
    for (const auto& key : one.keys)
        if (const double distance = std::abs(xOf(key.frame) - point.x()); distance <= nearest) {
            nearest = distance;
            found = KeyAt{one.track, key.frame};
        }
    return found;
}

std::vector<KeyAt> TrackView::keysIn(const QRectF& band) const {
    std::vector<KeyAt> found = m_before;
    for (int row = 0; m_timeline->isTrack(row); ++row) {
        const auto& one = m_timeline->tracks()[std::size_t(row)];
        for (const auto& key : one.keys) {
            const KeyAt at{one.track, key.frame};
            const bool isNew = std::ranges::find(found, at) == found.end();
            if (isNew && band.contains(keyPosition(row, key.frame))) found.push_back(at);
        }
    }
    return found;
}

void TrackView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_pressed = m_pointer = event->position();
    m_modifiers = event->modifiers();
    m_hasMoved = false;
    m_by = 0;
    const int row = rowAt(m_pressed.y());
    if (row < 0) {
        m_drag = Drag::Playhead;
        m_timeline->setFrame(frameAt(m_pressed.x()));
        return;
    }
    if (row < m_timeline->rowCount()) m_timeline->setRow(row);
    if (m_pressed.x() < rowHeight() + 4 && m_timeline->isTrack(row)) {
        m_timeline->keys().toggle(row);
    } else if (const auto key = keyAt(m_pressed)) {
        m_drag = Drag::Keys;
        pressKey(*key);
    } else {
        m_drag = Drag::Band;
        const bool adds = m_modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
        m_before = adds ? m_timeline->selected() : std::vector<KeyAt>();
        m_timeline->select(m_before);
    }
}

void TrackView::pressKey(const KeyAt& key) {
    m_held = key;
    std::vector<KeyAt> keys = m_timeline->selected();
    m_wasSelected = std::ranges::find(keys, key) != keys.end();
    if (m_wasSelected) return;
    if (!(m_modifiers & (Qt::ShiftModifier | Qt::ControlModifier))) keys.clear();
    keys.push_back(key);
    m_timeline->select(std::move(keys));
}

void TrackView::mouseMoveEvent(QMouseEvent* event) {
    m_pointer = event->position();
    m_modifiers = event->modifiers();
    m_hasMoved = m_hasMoved || (m_pointer - m_pressed).manhattanLength() >= QApplication::startDragDistance();
    if (m_drag == Drag::Playhead) m_timeline->setFrame(frameAt(m_pointer.x()));
    if (!m_hasMoved) return;
    if (m_drag == Drag::Keys) dragKeysTo(m_pointer);
    if (m_drag == Drag::Band) m_timeline->select(keysIn(QRectF(m_pressed, m_pointer).normalized()));
    viewport()->update();
}

KeyMove TrackView::moveKind() const {
    if (m_modifiers & Qt::AltModifier) return KeyMove::Ripple;
    return m_modifiers & Qt::ControlModifier ? KeyMove::Copy : KeyMove::Move;
}

// A key that was not selected moves alone, though Ctrl and Shift have added it to the others.
void TrackView::dragKeysTo(const QPointF& point) {
    if (!std::exchange(m_wasSelected, true)) m_timeline->select({m_held});
    const int by = snapped(int(std::lround((point.x() - m_pressed.x()) / m_scale)));
    m_by =
        document::possibleMove(m_timeline->document().entryFractal(), m_timeline->selected(), by, moveKind());
}

// The key that is held comes to the playhead, to the ends, and to keys of other tracks nearby.
int TrackView::snapped(int by) const {
    const int wanted = m_held.frame + by;
    int best = wanted;
    double nearest = snapReach / m_scale;
    const auto offer = [&](int frame) {
        if (const double distance = std::abs(frame - wanted); distance <= nearest) {
            nearest = distance;
            best = frame;
        }
    };
    if (m_scale >= 2 * snapReach) return by; // no snapping if frames are far apart
    for (const auto& one : m_timeline->tracks())
        for (const auto& key : one.keys)
            if (std::ranges::find(m_timeline->selected(), KeyAt{one.track, key.frame}) ==
                m_timeline->selected().end())
                offer(key.frame);
    offer(0);
    offer(m_timeline->timing().length);
    offer(m_timeline->frame());
    return best - m_held.frame;
}

void TrackView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_modifiers = event->modifiers();
    const Drag ended = std::exchange(m_drag, Drag::None);
    if (ended == Drag::Keys) {
        const bool toggles = m_modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
        std::vector<KeyAt> others = m_timeline->selected();
        std::erase(others, m_held);
        if (m_hasMoved)
            m_timeline->keys().move(std::exchange(m_by, 0), moveKind());
        else if (!toggles)
            m_timeline->select({m_held});
        else if (m_wasSelected)
            m_timeline->select(std::move(others));
    }
    viewport()->update();
}

void TrackView::mouseDoubleClickEvent(QMouseEvent* event) {
    const int row = rowAt(event->position().y());
    if (row == m_timeline->row() && !m_timeline->isTrack(row)) activateRow(*m_timeline, this);
}

void TrackView::wheelEvent(QWheelEvent* event) {
    const int turned = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    if (event->modifiers() & Qt::ControlModifier)
        return zoomAt(event->position().x(), std::exp2(turned / 480.0));
    QAbstractScrollArea::wheelEvent(event);
}

void TrackView::contextMenuEvent(QContextMenuEvent* event) {
    QPoint point = event->pos();
    const bool isByKeyboard = event->reason() == QContextMenuEvent::Keyboard;
    if (isByKeyboard) point = keyPosition(m_timeline->row(), m_timeline->frame());
    if (const int row = rowAt(point.y()); row >= 0) m_timeline->setRow(row);
    if (const auto key = keyAt(point)) {
        const auto& selected = m_timeline->selected();
        if (std::ranges::find(selected, *key) == selected.end()) m_timeline->select({*key});
    }
    showTrackMenu(*m_timeline, viewport()->mapToGlobal(point), this);
}

bool TrackView::walk(const QKeyEvent& event) {
    const bool byKeys = event.modifiers() & Qt::ControlModifier;
    const auto step = [&](int way) {
        if (byKeys)
            m_timeline->stepToKey(way);
        else
            m_timeline->setFrame(m_timeline->frame() + way);
        return true;
    };
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Comma:
        return step(-1);
    case Qt::Key_Right:
    case Qt::Key_Period:
        return step(1);
    case Qt::Key_Up:
        m_timeline->setRow(m_timeline->row() - 1);
        break;
    case Qt::Key_Down:
        m_timeline->setRow(m_timeline->row() + 1);
        break;
    case Qt::Key_Home:
        m_timeline->setFrame(0);
        break;
    case Qt::Key_End:
        m_timeline->setFrame(m_timeline->lastFrame());
        break;
    default:
        return false;
    }
    reveal();
    return true;
}

bool TrackView::edit(const QKeyEvent& event) {
    if (event.matches(QKeySequence::Copy)) return m_timeline->keys().copy(), true;
    if (event.matches(QKeySequence::Paste)) return m_timeline->keys().paste(), true;
    if (event.matches(QKeySequence::SelectAll)) return m_timeline->selectAll(), true;
    switch (event.key()) {
    case Qt::Key_Space:
        if (!event.isAutoRepeat()) m_timeline->playback().setPlaying(!m_timeline->playback().isPlaying());
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        activateRow(*m_timeline, this);
        return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        m_timeline->keys().remove();
        return true;
    case Qt::Key_Escape:
        if (m_drag == Drag::None && m_timeline->selected().empty()) return false;
        m_drag = Drag::None;
        m_by = 0;
        m_timeline->select({});
        viewport()->update();
        return true;
    default:
        return false;
    }
}

void TrackView::keyPressEvent(QKeyEvent* event) {
    if (!walk(*event) && !edit(*event)) QAbstractScrollArea::keyPressEvent(event);
}

// The keys above are this widget's, even where the window has commands on them.
bool TrackView::isOurKey(const QKeyEvent& event) const {
    if (event.matches(QKeySequence::Copy) || event.matches(QKeySequence::Paste) ||
        event.matches(QKeySequence::SelectAll))
        return true;
    switch (event.key()) {
    case Qt::Key_Comma:
    case Qt::Key_Period:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Space:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return !(event.modifiers() & (Qt::AltModifier | Qt::MetaModifier));
    default:
        return false;
    }
}

bool TrackView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isOurKey(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) viewport()->update();
    return QAbstractScrollArea::event(event);
}

void TrackView::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    const QRect all = viewport()->rect();
    painter.fillRect(all, palette().base());
    painter.setClipRect(all.adjusted(0, rowHeight(), 0, 0));
    for (int row = 0; row < m_timeline->rowCount(); ++row)
        if (topOf(row) > -rowHeight() && topOf(row) < all.height()) paintRow(painter, row);
    painter.setClipRect(all);
    paintRuler(painter);
    paintPlayhead(painter);
    if (m_drag == Drag::Band && m_hasMoved) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(faded(palette().color(QPalette::Highlight), 0.15));
        painter.drawRect(QRectF(m_pressed, m_pointer).normalized());
    }
    painter.setPen(faded(palette().color(QPalette::Text), 0.2));
    painter.drawLine(namesWidth(), 0, namesWidth(), all.height());
}

RulerUnit TrackView::rulerUnit() const {
    return m_unit->isChecked() ? RulerUnit::Seconds : RulerUnit::Frames;
}

QString TrackView::rulerText(int frame) const {
    return view::rulerText(frame, m_timeline->timing().rate, rulerUnit());
}

RulerPlace TrackView::rulerPlace() const {
    const QRectF area(namesWidth(), 0, viewport()->width() - namesWidth(), rowHeight() - 1);
    return {area, xOf(0), m_scale, m_timeline->timing(), rulerUnit()};
}

void TrackView::setFlawedFrames(std::vector<double> frames) {
    m_flawed = std::move(frames);
    viewport()->update();
}

void TrackView::paintRuler(QPainter& painter) const {
    const QRect ruler(0, 0, viewport()->width(), rowHeight());
    painter.fillRect(ruler, palette().window());
    const QColor ink = palette().color(QPalette::WindowText);
    painter.setPen(faded(ink, 0.25));
    painter.drawLine(ruler.bottomLeft(), ruler.bottomRight());
    painter.setClipRect(ruler.adjusted(namesWidth(), 0, 0, 0));
    paintRulerMarks(painter, rulerPlace(), playheadFlag(), m_timeline->tracks(), palette());
    for (const double frame : m_flawed)
        paintFlaw(painter, QPointF(xOf(frame), 1), rowHeight() - 2, palette());
    painter.setClipping(false);
}

void TrackView::paintRow(QPainter& painter, int row) const {
    const QRectF line(0, topOf(row), viewport()->width(), rowHeight());
    const bool isCurrent = row == m_timeline->row();
    const QColor highlight = palette().color(QPalette::Highlight);
    if (isCurrent) painter.fillRect(line, faded(highlight, hasFocus() ? 0.22 : 0.1));
    painter.setPen(faded(palette().color(QPalette::Text), 0.1));
    painter.drawLine(line.bottomLeft(), line.bottomRight());
    const double end = xOf(m_timeline->timing().length);
    painter.fillRect(QRectF(end, line.top(), std::max(0.0, line.right() - end), line.height()),
                     faded(palette().color(QPalette::Text), 0.06));
    painter.save();
    painter.setClipRect(line.adjusted(namesWidth(), 0, 0, 0), Qt::IntersectClip);
    if (m_timeline->isTrack(row)) {
        paintKeys(painter, row);
    } else {
        const double middle = line.center().y();
        painter.setPen(Qt::NoPen);
        painter.setBrush(faded(highlight, 0.55));
        painter.drawRoundedRect(QRectF(QPointF(xOf(0), middle - 4), QPointF(end, middle + 4)), 4, 4);
    }
    painter.restore();
    paintName(painter, row);
}

void TrackView::paintName(QPainter& painter, int row) const {
    const QColor ink = palette().color(QPalette::Text);
    const QPoint toggle = toggleOf(row);
    double x = rowHeight() + 4;
    if (m_timeline->isTrack(row)) {
        const bool hasKeys = !m_timeline->tracks()[std::size_t(row)].keys.empty();
        const bool isHere = m_timeline->hasKey(row, m_timeline->frame());
        painter.setPen(QPen(faded(ink, hasKeys ? 0.9 : 0.4), 1.5));
        painter.setBrush(isHere ? QBrush(palette().color(QPalette::Highlight)) : QBrush(Qt::NoBrush));
        painter.drawPolygon(diamond(toggle, 5.5));
    }
    if (const auto colour = m_timeline->rowColour(row)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(*colour);
        painter.drawEllipse(QPointF(x + 5, toggle.y()), 4.5, 4.5);
        x += 16;
    }
    const QRectF room(x, topOf(row), namesWidth() - x - 6, rowHeight());
    painter.setPen(ink);
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                     fontMetrics().elidedText(m_timeline->rowName(row), Qt::ElideRight, int(room.width())));
}

void TrackView::paintKeys(QPainter& painter, int row) const {
    const auto& one = m_timeline->tracks()[std::size_t(row)];
    const QColor ink = palette().color(QPalette::Text);
    const double middle = topOf(row) + rowHeight() / 2.0;
    painter.setPen(QPen(faded(ink, 0.3), 2));
    const auto lead = [&](const animation::Ease& ease, int from, int to) {
        if (ease.kind != animation::Ease::Kind::Hold)
            painter.drawLine(QPointF(xOf(from), middle), QPointF(xOf(to), middle));
    };
    for (std::size_t i = 0; i + 1 < one.keys.size(); ++i)
        lead(one.keys[i].ease, one.keys[i].frame, one.keys[i + 1].frame);
    if (one.keys.size() > 1 && m_timeline->timing().loop == animation::Loop::Cycle) { // up to the first key
        lead(one.keys.back().ease, one.keys.back().frame, m_timeline->timing().length);
        lead(one.keys.back().ease, 0, one.keys.front().frame);
    }
    const bool isDragged = m_drag == Drag::Keys && m_by != 0;
    const auto first = std::ranges::min_element(m_timeline->selected(), {}, &KeyAt::frame);
    for (const auto& key : one.keys) {
        const bool isChosen = m_timeline->isSelected(row, key.frame);
        const bool ripples = isDragged && moveKind() == KeyMove::Ripple && key.frame >= first->frame &&
                             std::ranges::find(m_timeline->selected(), one.track, &KeyAt::track) !=
                                 m_timeline->selected().end();
        const bool moves = isDragged && (isChosen || ripples);
        painter.setPen(QPen(palette().color(QPalette::Base), 1));
        painter.setBrush(isChosen && !moves ? palette().color(QPalette::Highlight)
                                            : faded(ink, moves ? 0.25 : 0.85));
        paintKeyMark(painter, QPointF(xOf(key.frame), middle), key.ease);
        if (!moves) continue;
        painter.setBrush(palette().color(QPalette::Highlight));
        paintKeyMark(painter, QPointF(xOf(key.frame + m_by), middle), key.ease);
    }
}

QRectF TrackView::playheadFlag() const {
    const double half = fontMetrics().horizontalAdvance(rulerText(m_timeline->frame())) / 2.0 + 5;
    return {xOf(m_timeline->frame()) - half, 2, 2 * half, double(rowHeight() - 6)};
}

void TrackView::paintPlayhead(QPainter& painter) const {
    const double x = xOf(m_timeline->frame());
    if (x < namesWidth()) return;
    const QColor colour = palette().color(QPalette::Highlight);
    painter.setPen(QPen(colour, 1.5));
    painter.drawLine(QPointF(x, rowHeight() - 6), QPointF(x, viewport()->height()));
    const QRectF flag = playheadFlag();
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(flag, 3, 3);
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(flag, Qt::AlignCenter, rulerText(m_timeline->frame()));
}

void TrackView::resizeEvent(QResizeEvent*) {
    layOut();
}

void TrackView::scrollContentsBy(int, int dy) {
    if (dy != 0) m_down = verticalScrollBar()->value();
    viewport()->update();
}

void TrackView::changeEvent(QEvent* event) {
    QAbstractScrollArea::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) layOut();
}

} // namespace view
