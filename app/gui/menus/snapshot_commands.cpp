// SPDX-License-Identifier: MIT
#include "menus/snapshot_commands.h"

#include "actions/action_menu.h"
#include "bridges/construction.h"
#include "messages/snapshot_banner.h"
#include "panels/snapshots/snapshots_panel.h"
#include "stage/stage.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>

#include <utility>

namespace {

constexpr int stripHeight = 180; // one row, so that the picture stays the largest part of the window

QString obstacle(const MenuContext& context) {
    if (context.stage->transformation()->isPainted())
        return SnapshotCommands::tr("Snapshots cannot be compared while a fractal transformation is shown.");
    const auto* construction = context.window->findChild<view::Construction*>();
    if (construction && construction->mode() != view::Construction::Mode::Density)
        return SnapshotCommands::tr(
            "Snapshots can be compared only while the density is shown. Choose Density "
            "in the bar under the canvas first.");
    return {};
}

} // namespace

SnapshotCommands::SnapshotCommands(const MenuContext& context, view::RenderBridge* render)
    : QObject(context.window),
      m_snapshots(context.document),
      m_look(context.document, &m_snapshots,
             {context.canvas, render, context.stage->views(), [context] { return obstacle(context); }}) {
    // Ends the look, because points and die of a construction are those of the fractal.
    if (auto* construction = context.window->findChild<view::Construction*>())
        connect(construction, &view::Construction::starting, &m_look, &view::SnapshotLook::end);
    connect(&m_snapshots, &view::Snapshots::message, context.messages, &WindowMessages::say);
    connect(&m_look, &view::SnapshotLook::message, context.messages, &WindowMessages::say);
    connect(&m_look, &view::SnapshotLook::changed, this, [this, window = context.window](bool isOn) {
        if (m_compare) m_compare->setChecked(isOn);
        if (isOn) new SnapshotBanner(window, &m_look, &m_snapshots); // deletes itself
    });
}

void SnapshotCommands::addTo(ActionMenu& menu) {
    m_take = menu.add({"snapshot", tr("Ta&ke Snapshot"), QKeySequence(tr("S")),
                       tr("Keep the current state of this fractal in the Snapshots panel")},
                      [this] {
                          m_look.end(); // keeps the fractal, not the look
                          m_snapshots.take();
                      });
    m_compare = menu.add({"compare", tr("C&ompare with Snapshot"), QKeySequence(tr("Q")),
                          tr("Show the snapshot selected in the Snapshots panel, or the newest one, in place "
                             "of the fractal; to return, press the key again, or hold it and release it")},
                         [this] {
                             const QKeySequence keys = m_compare->shortcut();
                             m_look.toggle(keys.isEmpty() ? Qt::Key_unknown : keys[0].key());
                             m_compare->setChecked(m_look.isOn());
                         });
    m_compare->setCheckable(true);
    m_compare->setAutoRepeat(false);
    m_take->setAutoRepeat(false);
}

view::SnapshotsPanel* SnapshotCommands::makePanel() {
    return new view::SnapshotsPanel(&m_snapshots, &m_look, m_take, m_compare);
}

void SnapshotCommands::setDock(QDockWidget* dock) {
    dock->hide();
    connect(&m_snapshots, &view::Snapshots::taken, dock, [this, dock, isFirst = true]() mutable {
        const bool isHidden = dock->isHidden();
        auto* window = qobject_cast<QMainWindow*>(dock->parentWidget());
        const bool presents = window->menuBar()->isHidden(); // no panel appears in a presentation
        if (isHidden && !presents && std::exchange(isFirst, false)) {
            dock->show();
            window->resizeDocks({dock}, {stripHeight}, Qt::Vertical);
        } else if (isHidden) {
            emit m_snapshots.message(tr("Kept as “%1”. To see it, choose View, Panels, Snapshots.")
                                         .arg(m_snapshots.marked()->name));
        }
    });
}
