// SPDX-License-Identifier: MIT
#include "panels/snapshots/snapshot_look.h"

#include "bridges/render_bridge.h"
#include "canvas/canvas_view.h"
#include "document/moments/animated_fractal.h"
#include "space/four_views.h"

#include <QApplication>
#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr int held = 400; // milliseconds; longer presses are holds
// A keyboard repeats a key as a release and a press, which Qt only recognizes where it has read both. On a
// busy machine it reads the press this much later at most; nobody presses a key again so soon.
constexpr int repetition = 200;

} // namespace

SnapshotLook::SnapshotLook(document::Document* document, Snapshots* snapshots, Canvases canvases,
                           QObject* parent)
    : QObject(parent), m_document(document), m_snapshots(snapshots), m_canvases(std::move(canvases)) {
    connect(document, &document::Document::changed, this, &SnapshotLook::follow);
    connect(snapshots, &Snapshots::changed, this, [this] {
        const Snapshot* marked = m_snapshots->marked();
        if (isOn() && (!marked || marked->key != m_shown)) end();
    });
}

SnapshotLook::~SnapshotLook() = default;

const Snapshot* SnapshotLook::shown() const {
    return isOn() ? m_snapshots->marked() : nullptr;
}

void SnapshotLook::toggle(Qt::Key key) {
    if (QGuiApplication::mouseButtons() != Qt::NoButton) return; // within a drag
    if (isOn()) return end();
    if (const QString why = obstacle(); !why.isEmpty()) return emit message(why);
    m_key = key;
    const bool isRepeated = m_released.isValid() && m_released.elapsed() < repetition;
    if (!isRepeated) m_held.start();
    begin();
}

QString SnapshotLook::obstacle() const {
    const Snapshot* marked = m_snapshots->marked();
    if (!marked) return tr("There is no snapshot to compare with yet. Take one first: Edit, Take Snapshot.");
    if (m_snapshots->isAsNow(*marked)) return tr("Nothing has changed since “%1”.").arg(marked->name);
    if (document::dimension(*marked->fractal) != document::dimension(m_document->fractal()))
        return tr("“%1” cannot be compared: one is in the plane, the other in space. Click the snapshot to "
                  "restore it.")
            .arg(marked->name);
    return m_canvases.obstacle();
}

void SnapshotLook::begin() {
    m_shown = m_snapshots->marked()->key;
    CanvasOptions& options = m_canvases.plane->options();
    m_hadOverlays = options.overlaysVisible();
    options.setOverlaysVisible(false); // handles would not match the picture
    show();
    qApp->installEventFilter(this);
    emit changed(true);
    emit message(tr("This is “%1”. Esc returns to the fractal.").arg(shown()->name));
}

void SnapshotLook::show() {
    const Snapshot* snapshot = shown();
    if (!snapshot) return;
    const auto seen = std::make_shared<const document::Fractal>(
        document::frameAt(*snapshot->fractal, m_document->moment()).fractal);
    if (document::space(*seen))
        m_canvases.space->showInstead(seen);
    else
        m_canvases.render->showInstead(seen);
}

void SnapshotLook::end() {
    if (!isOn()) return;
    m_shown = 0;
    qApp->removeEventFilter(this);
    m_canvases.space->showInstead(nullptr);
    m_canvases.render->showInstead(nullptr);
    if (m_hadOverlays) m_canvases.plane->options().setOverlaysVisible(true);
    emit changed(false);
}

void SnapshotLook::follow(const document::Change& change) {
    using document::Change;
    if (!isOn()) return;
    const bool isAnother = change.parts & (Change::Current | Change::File);
    if (!isAnother && change.parts & Change::Time) return show();
    if (isAnother || change.parts & (Change::System | Change::Cage | Change::Appearance | Change::Animation))
        end();
}

// Esc comes back, and so does the key that was held down. Nothing else is ours.
bool SnapshotLook::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease)
        return QObject::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isHere = QApplication::activeWindow() == m_canvases.plane->window() &&
                        QApplication::activePopupWidget() == nullptr;
    if (isHere && event->type() == QEvent::KeyPress && key->key() == Qt::Key_Escape) {
        end();
        return true;
    }
    if (event->type() == QEvent::KeyRelease && key->key() == m_key && !key->isAutoRepeat() &&
        std::exchange(m_key, Qt::Key_unknown) != Qt::Key_unknown) {
        m_released.start();
        if (m_held.elapsed() >= held) end();
    }
    return QObject::eventFilter(watched, event);
}

} // namespace view
