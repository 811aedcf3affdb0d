// SPDX-License-Identifier: MIT
#include "first_minute.h"

#include "animation/motions/motion_presets.h"
#include "bridges/render_bridge.h"
#include "canvas/canvas_view.h"
#include "desktop/reduced_motion.h"
#include "desktop/settings.h"
#include "dialogs/export/export_dialog.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/moments/animated_fractal.h"
#include "messages/first_chips.h"
#include "messages/tour.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QMainWindow>

#include <cmath>
#include <numbers>
#include <utility>

namespace {

constexpr int breeze = 2000; // milliseconds
constexpr int breezeTick = 16;
constexpr int steps = 1000; // number of steps of the breeze

QString seenKey() {
    return QStringLiteral("hints/firstDrag");
}

// The strength of the wind grows from none and fades to none.
document::Fractal blown(const document::Fractal& windy, double share) {
    document::Fractal at = windy;
    auto& animation = *document::plane(at)->animation;
    for (auto& motion : animation.motions)
        if (auto* sway = std::get_if<animation::Sway<2>>(&motion))
            sway->strength *= std::sin(std::numbers::pi * share) * std::sin(std::numbers::pi * share);
    const auto moment = animation::moment(std::int64_t(share * steps) * animation.length, steps);
    return document::frameAt(at, moment).fractal;
}

} // namespace

FirstMinute::FirstMinute(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    m_tick.setInterval(breezeTick);
    connect(&m_tick, &QTimer::timeout, this, &FirstMinute::blow);
    connect(m_parts.document, &document::Document::changed, this, &FirstMinute::follow);
    connect(m_parts.canvas, &view::CanvasView::hintDismissed, this, [] { view::store(seenKey(), true); });
}

bool FirstMinute::isOver() {
    return view::stored(seenKey(), false).toBool();
}

void FirstMinute::invite() {
    if (!isOver()) m_parts.canvas->setHint(tr("Take a corner."));
}

void FirstMinute::sway() {
    const auto windy = document::withWind(m_parts.document->entryFractal(), animation::swayPresets().front());
    if (view::reducesMotion() || !windy || !document::plane(*windy)) return invite();
    m_windy = std::make_shared<const document::Fractal>(*windy);
    m_parts.canvas->setHint({});
    qApp->installEventFilter(this); // any action by the user ends the breeze
    m_clock.start();
    m_tick.start();
}

void FirstMinute::blow() {
    const double share = double(m_clock.elapsed()) / breeze;
    if (share >= 1) return rest();
    m_parts.render->showMoving(std::make_shared<const document::Fractal>(blown(*m_windy, share)));
}

void FirstMinute::rest() {
    if (!isSwaying()) return;
    m_tick.stop();
    qApp->removeEventFilter(this);
    m_parts.render->showInstead(nullptr);
    invite();
}

bool FirstMinute::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::KeyPress:
    case QEvent::TouchBegin:
    case QEvent::Wheel:
        rest();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

// A drag is live until it is let go.
void FirstMinute::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::File | Change::Current)) {
        rest();
        m_isDragging = false;
        return;
    }
    if (change.parts & Change::Time || !(change.parts & (Change::Cage | Change::System))) return;
    rest();
    if (change.live) {
        m_isDragging = true;
        if (m_chips) m_chips->close();
    } else if (std::exchange(m_isDragging, false)) {
        // Queued until the drag is a step of the history.
        QMetaObject::invokeMethod(this, &FirstMinute::showChips, Qt::QueuedConnection);
    }
}

// Shown once in the life of the settings.
void FirstMinute::showChips() {
    const QString shown = QStringLiteral("hints/firstChips");
    const bool isCancelled = !m_parts.document->isModified();
    const bool isLed = m_parts.window->findChild<Tour*>() != nullptr; // who says what to try next
    if (isCancelled || isLed || view::stored(shown, false).toBool()) return;
    view::store(shown, true);
    view::store(seenKey(), true);
    m_parts.canvas->dismissHint();
    m_chips =
        new FirstChips(m_parts.window, {{m_parts.sway, tr("Make it sway")},
                                        {m_parts.variations, tr("Grow variations")},
                                        {m_parts.poster, tr("Save a poster"), [window = m_parts.window] {
                                             for (auto* dialog : window->findChildren<view::ExportDialog*>())
                                                 if (!dialog->isBusy()) dialog->beginAsPoster();
                                         }}});
}
