// SPDX-License-Identifier: MIT
#include "menus/help_menu.h"

#include "desktop/shortcuts.h"
#include "dialogs/command_palette.h"
#include "dialogs/guide.h"
#include "dialogs/shortcuts_dialog.h"
#include "messages/tour.h"
#include "widgets/icon.h"

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QWhatsThis>

HelpMenu::HelpMenu(const MenuContext& context) : ActionMenu(context, tr("&Help")) {
    QMainWindow* window = context.window;
    add({"search", tr("&Find a Command…"), QKeySequence(tr("Ctrl+K")),
         tr("Find any command by typing what it does")},
        [this] { openPalette(); });
    add({"help", tr("&Keyboard and Mouse…"), QKeySequence(tr("Ctrl+/")), tr("Every shortcut and gesture")},
        [this] { showShortcuts(); });
    add({"user-guide", tr("&User Guide"), QKeySequence::HelpContents, tr("Read the user guide")},
        [window] { view::showGuide(window); });
    add({"tour",
         tr("&Tour"),
         {},
         tr("Six short steps that you do yourself: drag, squeeze, undo, collection, wind, export")},
        [context] { Tour::start(context.window, context.document, *context.panels); });
    QAction* what = QWhatsThis::createAction(window);
    what->setText(tr("&What’s This?"));
    what->setIcon(view::icon(QStringLiteral("help")));
    what->setStatusTip(tr("Click anything to see what it does"));
    what->setObjectName(QStringLiteral("whats-this"));
    view::adoptShortcuts(*what);
    addAction(what);
    addSeparator();
    add({"info", tr("&About Barycage"), {}, tr("Version and licence")}, [this] { showAbout(); });
}

void HelpMenu::openPalette() {
    QMainWindow* window = context().window;
    auto* palette = new view::CommandPalette(view::actionsOf(*window), window);
    palette->setAttribute(Qt::WA_DeleteOnClose);
    connect(palette, &view::CommandPalette::guideRequested, window,
            [window](const QString& words) { view::searchGuide(window, words); });
    palette->move(
        window->mapToGlobal(QPoint((window->width() - palette->width()) / 2, window->height() / 6)));
    palette->show();
}

void HelpMenu::showShortcuts() {
    auto* dialog = new view::ShortcutsDialog(view::actionsOf(*context().window), context().window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

void HelpMenu::showAbout() {
    QMessageBox box(QMessageBox::NoIcon, tr("About Barycage"),
                    tr("<h3>Barycage %1</h3><p>Grab a fractal by its corners: an editor for iterated "
                       "function systems that describes their attractors in barycentric coordinates of a "
                       "control triangle.</p><p>After E. Hadzieva and M. Shuminoska, <i>Real-time Tool for "
                       "Affine Transformations of Two Dimensional IFS Fractals</i>.</p><p>MIT licence.</p>")
                        .arg(QApplication::applicationVersion()),
                    QMessageBox::Ok, context().window);
    box.setTextFormat(Qt::RichText);
    box.setIconPixmap(context().window->windowIcon().pixmap(64));
    const QPushButton* toolkit = box.addButton(tr("About &Qt"), QMessageBox::HelpRole);
    box.exec();
    if (box.clickedButton() == toolkit) QApplication::aboutQt();
}
