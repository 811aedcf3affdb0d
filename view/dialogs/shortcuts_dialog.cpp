// SPDX-License-Identifier: MIT
#include "dialogs/shortcuts_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace view {

namespace {

QTreeWidgetItem* group(QTreeWidget* tree, const QString& title) {
    auto* item = new QTreeWidgetItem(tree, {title});
    item->setFirstColumnSpanned(true);
    QFont bold = tree->font();
    bold.setBold(true);
    item->setFont(0, bold);
    item->setExpanded(true);
    return item;
}

void addGestures(QTreeWidget* tree) {
    auto* canvas = group(tree, ShortcutsDialog::tr("On the canvas"));
    const QList<QStringList> gestures{
        {ShortcutsDialog::tr("Move a vertex, an edge, the whole cage"), ShortcutsDialog::tr("drag it")},
        {ShortcutsDialog::tr("Rotate about the pivot"),
         ShortcutsDialog::tr("Ctrl + drag, or the round handle")},
        {ShortcutsDialog::tr("Scale about the pivot"),
         ShortcutsDialog::tr("Alt + drag, or the square handle")},
        {ShortcutsDialog::tr("Move or scale along one axis, turn in steps of 15°"),
         ShortcutsDialog::tr("Shift while dragging")},
        {ShortcutsDialog::tr("Take the drag back"), ShortcutsDialog::tr("Esc while dragging")},
        {ShortcutsDialog::tr("Select the maps, or the vertices, in a rectangle"),
         ShortcutsDialog::tr("drag from the empty canvas; Shift adds")},
        {ShortcutsDialog::tr("Select one more map or vertex, or one less"),
         ShortcutsDialog::tr("Shift or Ctrl + click")},
        {ShortcutsDialog::tr("Select map 1 … 9, all maps"), ShortcutsDialog::tr("Alt + digit, Ctrl+A")},
        {ShortcutsDialog::tr("Delete the selected vertices or maps"),
         QKeySequence(Qt::Key_Delete).toString(QKeySequence::NativeText)},
        {ShortcutsDialog::tr("Insert a vertex on an edge, duplicate the selected maps"),
         QKeySequence(Qt::Key_Insert).toString(QKeySequence::NativeText)},
        {ShortcutsDialog::tr("A deeper or a larger branch"),
         ShortcutsDialog::tr("Shift + wheel, Page Down, Page Up")},
        {ShortcutsDialog::tr("Next or previous handle"), ShortcutsDialog::tr("Tab, Shift+Tab")},
        {ShortcutsDialog::tr("Nudge the handle"), ShortcutsDialog::tr("arrow keys; Shift ×10, Alt ×0.1")},
        {ShortcutsDialog::tr("Leave the canvas"), ShortcutsDialog::tr("F6")},
        {ShortcutsDialog::tr("Zoom at the pointer"), ShortcutsDialog::tr("wheel")},
        {ShortcutsDialog::tr("Pan"), ShortcutsDialog::tr("middle drag, or Space + drag")},
    };
    for (const QStringList& gesture : gestures)
        new QTreeWidgetItem(canvas, gesture);
}

void addActions(QTreeWidget* tree, const QList<NamedAction>& actions) {
    QTreeWidgetItem* menu = nullptr;
    for (const auto& [action, path] : actions) {
        QStringList keys;
        for (const QKeySequence& key : action->shortcuts())
            keys << key.toString(QKeySequence::NativeText);
        if (keys.isEmpty()) continue;
        const QString title = path.section(QStringLiteral(" › "), 0, 0);
        if (!menu || menu->text(0) != title) menu = group(tree, title);
        new QTreeWidgetItem(menu, {path.section(QStringLiteral(" › "), 1), keys.join(QStringLiteral(", "))});
    }
}

void filter(QTreeWidget* tree, const QString& text) {
    for (int i = 0; i < tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* top = tree->topLevelItem(i);
        bool any = false;
        for (int k = 0; k < top->childCount(); ++k) {
            const bool shown = matchesCommand(top->child(k)->text(0) + u' ' + top->child(k)->text(1), text);
            top->child(k)->setHidden(!shown);
            any = any || shown;
        }
        top->setHidden(!any);
    }
}

} // namespace

ShortcutsDialog::ShortcutsDialog(const QList<NamedAction>& actions, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Keyboard and Mouse"));
    auto* search = new QLineEdit;
    search->setPlaceholderText(tr("Search"));
    search->setAccessibleName(tr("Search the shortcuts"));
    search->setWhatsThis(tr("Shows only the lines that have these words."));
    search->setClearButtonEnabled(true);
    auto* tree = new QTreeWidget;
    tree->setAccessibleName(tr("Shortcuts"));
    tree->setWhatsThis(tr("What every key and every movement of the mouse does."));
    tree->setColumnCount(2);
    tree->setHeaderLabels({tr("What it does"), tr("How")});
    tree->setRootIsDecorated(false);
    tree->setSelectionMode(QAbstractItemView::NoSelection);
    addGestures(tree);
    view::addActions(tree, actions);
    tree->expandAll();
    tree->resizeColumnToContents(0);
    tree->setColumnWidth(0, tree->columnWidth(0) + 2 * tree->indentation());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);

    auto* column = new QVBoxLayout(this);
    column->addWidget(search);
    column->addWidget(tree);
    column->addWidget(buttons);
    resize(620, 640);
    connect(search, &QLineEdit::textChanged, tree, [tree](const QString& text) { filter(tree, text); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace view
