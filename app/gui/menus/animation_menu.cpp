// SPDX-License-Identifier: MIT
#include "menus/animation_menu.h"

#include "attractor/request/orbit_navigation.h"
#include "panels/timeline/space_tap.h"
#include "panels/timeline/stretch_dialog.h"
#include "panels/timeline/timeline_panel.h"
#include "panels/timeline/track_view.h"
#include "space/space_view.h"
#include "stage/stage.h"
#include "widgets/icon.h"

#include <QDockWidget>
#include <QEvent>

AnimationMenu::AnimationMenu(const MenuContext& context, view::TimelinePanel* panel)
    : ActionMenu(context, tr("&Animation")), m_panel(panel) {
    m_animate = add({"animate", tr("A&nimate"), {}, tr("Show the timeline under the canvas")}, [this] {
        if (m_animate->isChecked()) {
            showDock();
            m_panel->trackView()->setFocus();
        } else {
            m_dock->close();
        }
    });
    m_animate->setCheckable(true);
    addToolBarGroup({{m_animate, tr("Animate")}});
    addPlaying();
    addSeparator();
    addMenu(panel->motionMenu());
    addKeys();
    panel->timeline().setCameraSource([context]() -> document::SeenCamera {
        if (!context.stage->showsSpace() && context.canvas->camera().height <= 0) return std::nullopt;
        return context.stage->camera();
    });
    panel->timeline().setVerticalSource([context]() -> ifs::Vector<3> {
        const attractor::UpAxis up = context.stage->space()->navigation().upAxis();
        return attractor::standing(up) * ifs::Vector<3>::UnitY();
    });
    connect(panel, &view::TimelinePanel::message, context.messages, &WindowMessages::say);
    connect(panel, &view::TimelinePanel::motionAdded, this, &AnimationMenu::showDock);
}

void AnimationMenu::setDock(QDockWidget* dock) {
    m_dock = dock;
    m_animate->setChecked(!dock->isHidden());
    dock->installEventFilter(this);
    connect(dock->toggleViewAction(), &QAction::toggled, m_animate, &QAction::setChecked);
}

// Nothing plays on whose controls somebody has put away.
bool AnimationMenu::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_dock && event->type() == QEvent::Close) m_panel->timeline().playback().setPlaying(false);
    return ActionMenu::eventFilter(watched, event);
}

void AnimationMenu::showDock() {
    m_dock->show();
    m_dock->raise();
}

void AnimationMenu::addPlaying() {
    view::Timeline& timeline = m_panel->timeline();
    view::Playback& playback = timeline.playback();
    const auto toggle = [&playback] { playback.setPlaying(!playback.isPlaying()); };
    QAction* play =
        add({"play", tr("&Play"), {}, tr("Play or stop the animation (Space on the canvas)")}, toggle);
    connect(&playback, &view::Playback::playingChanged, play, [play](bool playing) {
        play->setIcon(view::icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
        play->setText(playing ? tr("&Pause") : tr("&Play"));
    });
    view::SpaceView* space = context().stage->space();
    connect(new view::SpaceTap(context().stage->plane()), &view::SpaceTap::tapped, this, toggle);
    connect(new view::SpaceTap(space), &view::SpaceTap::tapped, this, [space, toggle] {
        if (!space->ball().focused()) toggle(); // Space looks along an axis on the ball
    });
}

void AnimationMenu::addKeys() {
    auto* menu = new ActionMenu(context(), tr("&Keys and Frames"));
    addMenu(menu);
    view::Timeline& timeline = m_panel->timeline();
    const auto withTracks = [this](void (view::KeyCommands::*set)()) {
        return [this, set] {
            m_panel->showTracks();
            showDock();
            (m_panel->timeline().keys().*set)();
        };
    };
    menu->add({"key", tr("Set &Key"), QKeySequence(tr("K")), tr("Key the current track at the playhead")},
              withTracks(&view::KeyCommands::set));
    menu->add({"set-keys-of-all-tracks", tr("Set Keys of &All Tracks"), QKeySequence(tr("Shift+K")),
               tr("Key all tracks that have keys at the playhead, or all tracks if none has")},
              withTracks(&view::KeyCommands::setInAll));
    menu->add(
        {"delete-keys", tr("&Delete Keys"), {}, tr("Delete the selected keys"), nullptr, false, "remove"},
        [&timeline] { timeline.keys().remove(); });
    menu->add({"stretch-keys",
               tr("Stretch Ke&ys…"),
               {},
               tr("Make a range of frames slower or faster: the keys of all tracks spread")},
              [&timeline, window = context().window] {
                  if (timeline.isEmpty())
                      emit timeline.message(tr("There are no keys to stretch. Choose Set Key first."));
                  else
                      view::askToStretch(timeline, window);
              });
    menu->addSeparator();
    menu->add({"previous-frame", tr("P&revious Frame"), QKeySequence(tr(",")),
               tr("Move the playhead back one frame")},
              [&timeline] { timeline.setFrame(timeline.frame() - 1); });
    menu->add(
        {"next-frame", tr("Ne&xt Frame"), QKeySequence(tr(".")), tr("Move the playhead forward one frame")},
        [&timeline] { timeline.setFrame(timeline.frame() + 1); });
    menu->add({"key-previous", tr("Pre&vious Key"), QKeySequence(tr("Alt+,")),
               tr("Move the playhead to the previous key")},
              [&timeline] { timeline.stepToKey(-1); });
    menu->add(
        {"key-next", tr("Nex&t Key"), QKeySequence(tr("Alt+.")), tr("Move the playhead to the next key")},
        [&timeline] { timeline.stepToKey(1); });
}
