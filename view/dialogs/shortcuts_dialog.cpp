// SPDX-License-Identifier: MIT
#include "dialogs/shortcuts_dialog.h"

#include "widgets/text/tooltip_text.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QScreen>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

// The one of this title, made when there is none.
QTreeWidgetItem* group(QTreeWidget* tree, const QString& title) {
    for (int i = 0; i < tree->topLevelItemCount(); ++i)
        if (tree->topLevelItem(i)->text(0) == title) return tree->topLevelItem(i);
    auto* item = new QTreeWidgetItem(tree, {title});
    item->setFirstColumnSpanned(true);
    QFont bold = tree->font();
    bold.setBold(true);
    item->setFont(0, bold);
    return item;
}

void addLine(QTreeWidget* tree, const QString& title, const QStringList& line) {
    auto* item = new QTreeWidgetItem(group(tree, title), line);
    item->setToolTip(0, tooltipText(line.front())); // full text on narrow screens
}

QList<QStringList> onCanvas() {
    return {
        {ShortcutsDialog::tr("Move a vertex, an edge, the whole cage"), ShortcutsDialog::tr("drag it")},
        {ShortcutsDialog::tr("Rotate about the pivot"),
         ShortcutsDialog::tr("Ctrl + drag, or the round handle")},
        {ShortcutsDialog::tr("Scale about the pivot"),
         ShortcutsDialog::tr("Alt + drag, or the square handle")},
        {ShortcutsDialog::tr("Move or scale along one axis, rotate in steps of 15°"),
         ShortcutsDialog::tr("Shift while dragging")},
        {ShortcutsDialog::tr("Cancel the drag"), ShortcutsDialog::tr("Esc while dragging")},
        {ShortcutsDialog::tr("Select the maps, or the vertices, in a rectangle"),
         ShortcutsDialog::tr("drag from the empty canvas; Shift adds")},
        {ShortcutsDialog::tr("Add a map or vertex to the selection, or remove it"),
         ShortcutsDialog::tr("Shift or Ctrl + click")},
        {ShortcutsDialog::tr("Select map 1 … 9, all maps"), ShortcutsDialog::tr("Alt + digit, Ctrl+A")},
        {ShortcutsDialog::tr("Delete the selected vertices or maps"),
         QKeySequence(Qt::Key_Delete).toString(QKeySequence::NativeText)},
        {ShortcutsDialog::tr("Insert a vertex on an edge, duplicate the selected maps"),
         QKeySequence(Qt::Key_Insert).toString(QKeySequence::NativeText)},
        {ShortcutsDialog::tr("Remove the last vertex while defining a triangle"),
         ShortcutsDialog::tr("Backspace")},
        {ShortcutsDialog::tr("Select a deeper or a larger branch"),
         ShortcutsDialog::tr("Shift + wheel, Page Down, Page Up")},
        {ShortcutsDialog::tr("Next or previous handle"), ShortcutsDialog::tr("Tab, Shift+Tab")},
        {ShortcutsDialog::tr("Nudge the handle"), ShortcutsDialog::tr("arrow keys; Shift ×10, Alt ×0.1")},
        {ShortcutsDialog::tr("Ball of axes, after the last handle: choose an end"),
         ShortcutsDialog::tr("arrow keys")},
        {ShortcutsDialog::tr("Ball of axes: look along the axis, then from behind"),
         ShortcutsDialog::tr("Enter or Space")},
        {ShortcutsDialog::tr("Ball of axes: turn the view, return to the canvas"),
         ShortcutsDialog::tr("Shift + arrow keys, Esc")},
        {ShortcutsDialog::tr("Next or previous part of the window"), ShortcutsDialog::tr("F6, Shift+F6")},
        {ShortcutsDialog::tr("Zoom at the pointer"), ShortcutsDialog::tr("wheel")},
        {ShortcutsDialog::tr("Rotate the view"), ShortcutsDialog::tr("Ctrl + Shift + wheel")},
        {ShortcutsDialog::tr("Pan"), ShortcutsDialog::tr("middle drag, or Space + drag")},
        {ShortcutsDialog::tr("Play or stop the animation"), ShortcutsDialog::tr("Space")},
    };
}

QList<QStringList> onGradient() {
    return {
        {ShortcutsDialog::tr("Select another stop"),
         ShortcutsDialog::tr("Page Up, Page Down, Home, End, or Ctrl + Left, Right")},
        {ShortcutsDialog::tr("Move the stop"), ShortcutsDialog::tr("Left, Right; Shift ×10")},
        {ShortcutsDialog::tr("Add a stop"), ShortcutsDialog::tr("Ins or +, or double-click")},
        {ShortcutsDialog::tr("Delete the stop"), ShortcutsDialog::tr("Del or Backspace")},
        {ShortcutsDialog::tr("Change the stop colour"),
         ShortcutsDialog::tr("Enter or Space, or double-click it")},
        {ShortcutsDialog::tr("Cancel the change"), ShortcutsDialog::tr("Esc")},
    };
}

QList<QStringList> onTimeline() {
    return {
        {ShortcutsDialog::tr("Move the playhead"), ShortcutsDialog::tr("drag in the ruler, or Left, Right")},
        {ShortcutsDialog::tr("Previous or next key"), ShortcutsDialog::tr("Ctrl + Left, Right")},
        {ShortcutsDialog::tr("First or last frame"), ShortcutsDialog::tr("Home, End")},
        {ShortcutsDialog::tr("Select another row"), ShortcutsDialog::tr("Up, Down")},
        {ShortcutsDialog::tr("Make or delete the key of the row"), ShortcutsDialog::tr("Enter")},
        {ShortcutsDialog::tr("Move the selected keys"), ShortcutsDialog::tr("drag them")},
        {ShortcutsDialog::tr("Move all later keys of the row, too"),
         ShortcutsDialog::tr("Alt while dragging")},
        {ShortcutsDialog::tr("Copy the keys"), ShortcutsDialog::tr("Ctrl while dragging")},
        {ShortcutsDialog::tr("Copy, paste, select all keys"), ShortcutsDialog::tr("Ctrl+C, Ctrl+V, Ctrl+A")},
        {ShortcutsDialog::tr("Delete the selected keys, or the motion"),
         QKeySequence(Qt::Key_Delete).toString(QKeySequence::NativeText)},
        {ShortcutsDialog::tr("Choose how a key leads to the next"), ShortcutsDialog::tr("right-click it")},
        {ShortcutsDialog::tr("Zoom the ruler"), ShortcutsDialog::tr("Ctrl + wheel")},
    };
}

void addGestures(QTreeWidget* tree) {
    for (const QStringList& line : onCanvas())
        addLine(tree, ShortcutsDialog::tr("On the canvas"), line);
    for (const QStringList& line : onTimeline())
        addLine(tree, ShortcutsDialog::tr("In the timeline"), line);
    for (const QStringList& line : onGradient())
        addLine(tree, ShortcutsDialog::tr("On the strip of the gradient"), line);
}

void addTableGestures(QTreeWidget* tree) {
    addLine(tree, ShortcutsDialog::tr("In the table of maps"),
            {ShortcutsDialog::tr("Show one map alone, or all of them again"),
             ShortcutsDialog::tr("Alt + click on its eye")});
}

void addActions(QTreeWidget* tree, const QList<NamedAction>& actions) {
    for (const auto& [action, path, panel] : actions) {
        QStringList keys;
        for (const QKeySequence& key : action->shortcuts())
            keys << key.toString(QKeySequence::NativeText);
        if (keys.isEmpty()) continue;
        addLine(tree, path.section(QStringLiteral(" › "), 0, 0),
                {path.section(QStringLiteral(" › "), 1), keys.join(QStringLiteral(", "))});
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
    search->setWhatsThis(tr("Shows only the lines that contain these words."));
    search->setClearButtonEnabled(true);
    auto* tree = new QTreeWidget;
    tree->setAccessibleName(tr("Shortcuts"));
    tree->setWhatsThis(tr("All keys and mouse gestures, and what they do."));
    tree->setColumnCount(2);
    tree->setHeaderLabels({tr("What it does"), tr("How")});
    tree->setRootIsDecorated(false);
    tree->setSelectionMode(QAbstractItemView::NoSelection);
    addGestures(tree);
    addTableGestures(tree);
    view::addActions(tree, actions);
    tree->expandAll();
    tree->header()->setStretchLastSection(false);
    tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents); // keys always completely visible
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);

    auto* column = new QVBoxLayout(this);
    column->addWidget(search);
    column->addWidget(tree);
    column->addWidget(buttons);
    const QAbstractItemView* view = tree; // base class, in which the hint is public
    const int wanted = view->sizeHintForColumn(0) + view->sizeHintForColumn(1) + 3 * tree->indentation() +
                       style()->pixelMetric(QStyle::PM_ScrollBarExtent) +
                       style()->pixelMetric(QStyle::PM_LayoutLeftMargin) +
                       style()->pixelMetric(QStyle::PM_LayoutRightMargin);
    const QSize available = screen()->availableSize();
    // Leaves room for the frame.
    resize(std::min(wanted, available.width()), std::min(640, available.height() * 9 / 10));
    connect(search, &QLineEdit::textChanged, tree, [tree](const QString& text) { filter(tree, text); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace view
