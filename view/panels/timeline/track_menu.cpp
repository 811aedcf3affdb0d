// SPDX-License-Identifier: MIT
#include "panels/timeline/track_menu.h"

#include "panels/timeline/ease_dialog.h"
#include "panels/timeline/motion_dialog.h"
#include "panels/timeline/stretch_dialog.h"
#include "panels/timeline/timeline.h"

#include <QMenu>

#include <algorithm>

namespace view {

namespace {

using Kind = animation::Ease::Kind;

struct EaseName {
    Kind kind;
    const char* name;
};

constexpr EaseName eases[] = {
    {Kind::Linear, QT_TRANSLATE_NOOP("view::Timeline", "Linear")},
    {Kind::Smooth, QT_TRANSLATE_NOOP("view::Timeline", "Smooth")},
    {Kind::Both, QT_TRANSLATE_NOOP("view::Timeline", "Slow Start and End")},
    {Kind::In, QT_TRANSLATE_NOOP("view::Timeline", "Slow Start")},
    {Kind::Out, QT_TRANSLATE_NOOP("view::Timeline", "Slow End")},
    {Kind::Hold, QT_TRANSLATE_NOOP("view::Timeline", "Hold")},
};

// Returns true if all selected keys have this ease.
bool isEaseOfAll(const Timeline& timeline, Kind kind) {
    for (const auto& one : timeline.tracks())
        for (const auto& key : one.keys)
            if (std::ranges::find(timeline.selected(), document::KeyAt{one.track, key.frame}) !=
                    timeline.selected().end() &&
                key.ease.kind != kind)
                return false;
    return true;
}

void askForEase(Timeline& timeline, QWidget* parent) {
    auto* dialog = new EaseDialog(timeline.keys().ease(), parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QDialog::accepted, &timeline,
                     [&timeline, dialog] { timeline.keys().setEase(dialog->ease()); });
    dialog->open();
}

bool isMotion(const Timeline& timeline) {
    return !timeline.isTrack(timeline.row()) && timeline.row() < timeline.rowCount();
}

void askForMotion(Timeline& timeline, QWidget* parent) {
    const auto motion = std::size_t(timeline.row()) - timeline.tracks().size();
    auto* dialog =
        new MotionDialog(timeline.document(), motion, timeline.rowName(timeline.row()), parent->window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace

void activateRow(Timeline& timeline, QWidget* parent) {
    if (isMotion(timeline))
        askForMotion(timeline, parent);
    else
        timeline.keys().toggle(timeline.row());
}

void showTrackMenu(Timeline& timeline, const QPoint& global, QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool any = !timeline.selected().empty();
    if (any) {
        menu->addSection(Timeline::tr("Ease to the Next Key"));
        for (const EaseName& ease : eases) {
            QAction* action =
                menu->addAction(Timeline::tr(ease.name), &timeline,
                                [&timeline, kind = ease.kind] { timeline.keys().setEase({kind}); });
            action->setObjectName(QLatin1String(ifs::nameOf(ease.kind)));
            action->setCheckable(true);
            action->setChecked(isEaseOfAll(timeline, ease.kind));
        }
        QAction* custom = menu->addAction(Timeline::tr("Custom…"), &timeline,
                                          [&timeline, parent] { askForEase(timeline, parent); });
        custom->setCheckable(true);
        custom->setChecked(isEaseOfAll(timeline, Kind::Cubic));
        menu->addSeparator();
        menu->addAction(Timeline::tr("Stretch Keys…"), &timeline,
                        [&timeline, parent] { askToStretch(timeline, parent->window()); });
        menu->addAction(Timeline::tr("Copy Keys"), &timeline, [&timeline] { timeline.keys().copy(); });
    }
    QAction* paste = menu->addAction(Timeline::tr("Paste Keys at the Playhead"), &timeline,
                                     [&timeline] { timeline.keys().paste(); });
    paste->setEnabled(timeline.keys().canPaste());
    if (any)
        menu->addAction(Timeline::tr("Delete Keys"), &timeline, [&timeline] { timeline.keys().remove(); });
    if (timeline.isTrack(timeline.row())) {
        menu->addAction(Timeline::tr("Key at the Playhead"), &timeline,
                        [&timeline] { timeline.keys().set(); });
    } else if (!any && isMotion(timeline)) {
        menu->addAction(Timeline::tr("Edit the Motion…"), &timeline,
                        [&timeline, parent] { askForMotion(timeline, parent); });
        menu->addAction(Timeline::tr("Delete the Motion"), &timeline,
                        [&timeline] { timeline.keys().remove(); });
    }
    menu->popup(global);
}

} // namespace view
