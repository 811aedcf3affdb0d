// SPDX-License-Identifier: MIT
#include "menus/edit_menu.h"

#include "actions/tool_bar.h"
#include "desktop/theme.h"
#include "dialogs/command_palette.h"
#include "dialogs/preferences_dialog.h"
#include "dialogs/transform_dialog.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/dimension_edits.h"
#include "document/edits/shadow_edits.h"
#include "menus/clipboard_commands.h"
#include "menus/snapshot_commands.h"
#include "session/session.h"
#include "stage/stage.h"
#include "widgets/icon.h"
#include "widgets/menus/menu_text.h"
#include "widgets/text/tooltip_text.h"

#include <QGuiApplication>

namespace {

// The axis along which the projection of a solid is a system: z, else y, else x.
std::optional<ifs::Vector<3>> flatAxis(const document::Fractal& fractal) {
    for (const int axis : {2, 1, 0}) {
        const ifs::Vector<3> direction = ifs::Vector<3>::Unit(axis);
        if (document::flattenObstacle(fractal, direction).isEmpty()) return direction;
    }
    return std::nullopt;
}

QString projectionObstacle(const document::Fractal& fractal) {
    return flatAxis(fractal) ? QString() : document::flattenObstacle(fractal, ifs::Vector<3>::UnitZ());
}

} // namespace

EditMenu::EditMenu(const MenuContext& context, SnapshotCommands& snapshots)
    : ActionMenu(context, tr("&Edit")) {
    addHistory();
    addSeparator();
    addClipboard();
    addSeparator();
    addFractal();
    auto* kept = new ActionMenu(context, tr("S&napshots"));
    addMenu(kept);
    snapshots.addTo(*kept);
    addSeparator();
    add({"settings", tr("&Preferences…"), QKeySequence(tr("Ctrl+,")),
         tr("Language, theme, picture quality, shortcuts, and what opens at startup")},
        [this] { showPreferences(); });
}

void EditMenu::addFractal() {
    auto* menu = new ActionMenu(context(), tr("&Fractal"));
    addMenu(menu);
    QAction* transform =
        menu->add({"transform", tr("&Transform…"), QKeySequence(tr("Ctrl+T")),
                   tr("Rotate, scale, shear, reflect or move the whole fractal by exact amounts")},
                  [this] { openTransform(); });
    disableWhen(transform, &document::cageObstacle);
    addShadow(*menu);
    addDimensions(*menu);
    menu->addSeparator();
    menu->addToggle({"allow-systems-without-an-attractor",
                     tr("Allow Systems &without an Attractor"),
                     {},
                     tr("Let a drag of maps continue where an attractor is no longer guaranteed"),
                     "edit/allowNoAttractor"},
                    [canvas = context().canvas, stage = context().stage](bool on) {
                        canvas->tools().setAllowsNoAttractor(on);
                        stage->views()->setAllowsNoAttractor(on);
                        stage->compare()->setAllowsNoAttractor(on);
                    });
}

void EditMenu::addHistory() {
    QUndoStack* stack = context().document->undoStack();
    QAction* undo = stack->createUndoAction(context().window, tr("&Undo"));
    undo->setObjectName(QStringLiteral("undo"));
    undo->setProperty(view::commandName, tr("&Undo")); // constant name, whatever step it undoes
    undo->setShortcut(QKeySequence(tr("Ctrl+Z")));
    undo->setIcon(view::icon(QStringLiteral("undo")));
    undo->setStatusTip(tr("Undo the last edit"));
    // Undo during a drag undoes only the drag.
    disconnect(undo, nullptr, stack, nullptr);
    connect(undo, &QAction::triggered, stack, [stack, stage = context().stage] {
        if (QGuiApplication::mouseButtons() == Qt::NoButton || !stage->cancelGesture()) stack->undo();
    });
    QAction* redo = stack->createRedoAction(context().window, tr("&Redo"));
    redo->setObjectName(QStringLiteral("redo"));
    redo->setProperty(view::commandName, tr("&Redo"));
    redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
    redo->setIcon(view::icon(QStringLiteral("redo")));
    redo->setStatusTip(tr("Redo the last edit that was undone"));
    addShared(undo);
    addShared(redo);
    // Plain text, because steps may be named after entries, whose names may contain markup and be long.
    const auto showStep = [this](QAction* action, const QString& name, const QString& step) {
        action->setText((name + u' ' + view::menuText(step, fontMetrics())).trimmed());
        action->setToolTip(view::tooltipText((action->iconText() + u' ' + step).trimmed()));
    };
    connect(stack, &QUndoStack::undoTextChanged, undo,
            [undo, showStep](const QString& step) { showStep(undo, tr("&Undo"), step); });
    connect(stack, &QUndoStack::redoTextChanged, redo,
            [redo, showStep](const QString& step) { showStep(redo, tr("&Redo"), step); });
    addToolBarGroup({{undo, tr("&Undo").remove(u'&')}, {redo, tr("&Redo").remove(u'&')}});
}

// Commands for the maps or the entries, whichever have the focus. The keys that many widgets take for
// themselves are shown here and left to them.
void EditMenu::addClipboard() {
    const ClipboardCommands commands(context());
    add({"cut", tr("&Cut"), QKeySequence::Cut, tr("Move the selected maps or entries to the clipboard")},
        [commands] { commands.cut(); });
    add({"copy", tr("Cop&y"), QKeySequence::Copy,
         tr("Copy the picture, the selected maps or the selected entries")},
        [commands] { commands.copy(); });
    add({"paste", tr("P&aste"), QKeySequence::Paste,
         tr("Add fractals from the clipboard to the file: entries of an .ifs file, flames or a table of "
            "numbers; or maps to the fractal")},
        [commands] { commands.paste(); });
    QAction* duplicate = add({"duplicate", tr("Dupl&icate"), QKeySequence(Qt::Key_Insert),
                              tr("Duplicate the selected maps or entries")},
                             [commands] { commands.duplicate(); });
    QAction* remove =
        add({"remove", tr("&Delete"), QKeySequence::Delete, tr("Delete the selected maps or entries")},
            [commands] { commands.remove(); });
    QAction* all =
        add({"select-all", tr("&Select All"), QKeySequence::SelectAll, tr("Select all maps or all entries")},
            [commands] { commands.selectAll(); });
    for (QAction* action : {duplicate, remove, all})
        action->setShortcutContext(Qt::WidgetShortcut);
}

// Checked while the entry has one.
void EditMenu::addShadow(ActionMenu& menu) {
    document::Document* document = context().document;
    QAction* shadow = menu.addToggle(
        {"shadow", tr("S&hadow"), {}, tr("Lay a flat, dark copy of the picture on the ground behind it")},
        [this, document](bool on) {
            if (on == document::hasShadow(document->fractal())) return;
            document->edit(on ? tr("Add a shadow") : tr("Remove the shadow"),
                           document::withShadow(document->fractal(), on));
            if (on && context().canvas->navigation().isFitted())
                context().stage->fit(); // the fractal may extend beyond the view
        });
    connect(document, &document::Document::changed, shadow,
            [document, shadow] { shadow->setChecked(document::hasShadow(document->fractal())); });
    shadow->setChecked(document::hasShadow(document->fractal()));
    disableWhen(shadow, &document::shadowObstacle);
}

// Adds the commands to space and back. The window follows the dimension of the entry.
void EditMenu::addDimensions(ActionMenu& menu) {
    document::Document* document = context().document;
    QAction* lift =
        menu.add({"lift-to-space",
                  tr("&Lift to Space"),
                  {},
                  tr("Add a third dimension to every map; the picture stays flat until you move a map")},
                 [this, document] {
                     const QString loss = document::dimensionLoss(document->entryFractal());
                     auto lifted = document::lifted(document->fractal());
                     if (!lifted) return;
                     document->edit(tr("Lift to Space"), *std::move(lifted));
                     if (!loss.isEmpty()) context().messages->say(loss);
                 });
    QAction* flatten =
        menu.add({"flatten-to-the-plane",
                  tr("&Flatten to the Plane"),
                  {},
                  tr("Replace the solid by its projection along the first axis that every map keeps")},
                 [this, document] {
                     const QString loss = document::dimensionLoss(document->entryFractal());
                     const auto axis = flatAxis(document->fractal());
                     auto projection = axis ? document::flattened(document->fractal(), *axis) : std::nullopt;
                     if (!projection) return;
                     document->edit(tr("Flatten to the Plane"), *std::move(projection));
                     if (!loss.isEmpty()) context().messages->say(loss);
                 });
    disableWhen(lift, &document::liftObstacle);
    disableWhen(flatten, &projectionObstacle);
    const auto warn = [document, lift, flatten] { // extends the tips set by disableWhen()
        const QString loss = document::dimensionLoss(document->entryFractal());
        for (QAction* action : {lift, flatten}) {
            if (loss.isEmpty() || !action->isEnabled()) continue;
            action->setStatusTip(loss);
            action->setToolTip(view::tooltipText(loss));
        }
    };
    warn();
    connect(document, &document::Document::changed, lift, warn);
}

void EditMenu::openTransform() {
    auto* dialog = new view::TransformDialog(context().document, context().window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open(); // modal, since another edit would end the preview
}

void EditMenu::showPreferences() {
    const auto* bar = context().window->findChild<ToolBar*>();
    auto* dialog =
        new view::PreferencesDialog(context().window, view::actionsOf(*context().window), bar->usualTools());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QStringList unsaved;
    for (const SessionWindow* window : session::windows())
        if (window->isWindowModified())
            unsaved << QString(window->windowTitle()).remove(QStringLiteral("[*]"));
    dialog->setUnsaved(unsaved);
    connect(dialog, &view::PreferencesDialog::changed, dialog, [](const view::Preferences& preferences) {
        view::applyTheme(preferences.theme);
        for (SessionWindow* window : session::windows())
            window->adopt(preferences);
    });
    // Queued, because the dialog closes with its window.
    connect(dialog, &view::PreferencesDialog::restartRequested, qApp, &session::restart,
            Qt::QueuedConnection);
    dialog->show();
}
