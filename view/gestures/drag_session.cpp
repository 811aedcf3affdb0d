// SPDX-License-Identifier: MIT
#include "gestures/drag_session.h"

#include "widgets/arrow_keys.h"

#include <QHash>
#include <QKeyEvent>

#include <utility>

namespace view {

namespace {

constexpr double slack = 2;        // pixels a click may shake without becoming a drag
constexpr int repeatPatience = 40; // milliseconds

} // namespace

DragSession::DragSession(document::Document& document) : m_document(document) {
    m_released.setSingleShot(true);
    m_released.setInterval(repeatPatience);
    connect(&m_released, &QTimer::timeout, this, &DragSession::endRun);
}

void DragSession::press(const QPointF& position) {
    m_press = position;
    m_hasMoved = false;
}

bool DragSession::isDrag(const QPointF& position) {
    m_hasMoved = m_hasMoved || (position - m_press).manhattanLength() > slack;
    return m_hasMoved;
}

void DragSession::open(const QString& text) {
    cancel();
    m_text = text;
    m_gesture.emplace(m_document.beginGesture(text));
}

void DragSession::describe(const QString& text, std::size_t handle) {
    const int kind = m_isRunning ? int(qHashMulti(0, m_text, handle) & 0x7fffffff) : -1;
    m_gesture->describe(text, kind);
}

DragSession::Outcome DragSession::finish() {
    if (!m_gesture) return Outcome::None;
    const bool isCommitted = m_gesture->isOpen();
    if (isCommitted) m_gesture->commit();
    m_gesture.reset();
    return isCommitted ? Outcome::Committed : Outcome::Abandoned;
}

void DragSession::cancel() {
    m_released.stop();
    m_isRunning = false;
    if (m_gesture) m_gesture->cancel();
    m_gesture.reset();
}

std::optional<DragMode> DragSession::turnedInto(DragMode asked, DragMode mode) const {
    const bool turns = asked != DragMode::Move && asked != mode && isOpen();
    return turns ? std::optional(asked) : std::nullopt;
}

void DragSession::endRun() {
    m_released.stop();
    if (std::exchange(m_isRunning, false)) emit runEnded();
}

void DragSession::keepRun(const QKeyEvent& press) {
    if (!m_released.isActive()) return;
    m_released.stop();
    if (press.timestamp() != m_releaseStamp) endRun();
}

bool DragSession::releaseRun(const QKeyEvent& release) {
    if (arrowDirection(release.key()).isNull() || !m_isRunning) return false;
    if (release.isAutoRepeat()) return true;
    m_releaseStamp = release.timestamp();
    if (m_releaseStamp == 0)
        endRun();
    else
        m_released.start();
    return true;
}

} // namespace view
