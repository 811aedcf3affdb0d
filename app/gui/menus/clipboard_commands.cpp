// SPDX-License-Identifier: MIT
#include "menus/clipboard_commands.h"

#include "desktop/clipboard.h"
#include "panels/entries/entries_list.h"
#include "panels/entries/entries_panel.h"
#include "panels/maps/maps_panel.h"
#include "stage/stage.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QPointer>
#include <QTableView>

namespace {

bool isWithin(const QWidget* part, const QWidget* whole) {
    return part != nullptr && whole != nullptr && (part == whole || whole->isAncestorOf(part));
}

bool takesText(const QWidget& widget) {
    return widget.inherits("QLineEdit") || widget.inherits("QTextEdit") ||
           widget.inherits("QPlainTextEdit") || widget.inherits("QAbstractSpinBox");
}

view::EntriesPanel& entries(const MenuContext& context) {
    return *context.window->findChild<view::EntriesPanel*>();
}

view::MapsPanel& maps(const MenuContext& context) {
    return *context.window->findChild<view::MapsPanel*>();
}

bool isWanted(const QKeyCombination& key, QWidget* widget) {
    QKeyEvent event(QEvent::ShortcutOverride, key.key(), key.keyboardModifiers());
    event.ignore();
    QApplication::sendEvent(widget, &event);
    return event.isAccepted();
}

// Past the shortcuts, to a widget or to the nearest around it that takes the key.
void deliver(QKeyEvent& event, QWidget* widget) {
    for (QWidget* each = widget; each != nullptr; each = each->isWindow() ? nullptr : each->parentWidget()) {
        event.accept();
        static_cast<QObject*>(each)->event(&event);
        if (event.isAccepted()) return;
    }
}

} // namespace

ClipboardCommands::Target ClipboardCommands::target() const {
    const QWidget* focused = QApplication::focusWidget();
    const auto* list = entries(m_context).findChild<view::EntriesList*>();
    if (focused == list) return Target::Entries;
    if (focused == maps(m_context).table()) return Target::Maps;
    if (focused != nullptr && focused != m_context.window && !isWithin(focused, m_context.stage))
        return Target::Other;
    return m_context.canvas->tool() == view::CanvasView::Tool::Maps ? Target::CanvasOfMaps : Target::Canvas;
}

// Sends the keys as if they had been typed: each widget knows what they mean to it. A key that no widget
// claims would be taken for the shortcut of the command that presses it.
void ClipboardCommands::press(const QKeySequence& keys) const {
    if (keys.isEmpty()) return;
    QWidget* focused = QApplication::focusWidget();
    if (focused == nullptr || focused == m_context.window) {
        m_context.stage->takeFocus();
        focused = QApplication::focusWidget();
    }
    if (focused == nullptr) return;
    const QKeyCombination key = keys[0];
    const bool isClaimed = isWanted(key, focused);
    const QPointer<QWidget> widget = focused; // guards against a key that closes the widget
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
        QKeyEvent event(type, key.key(), key.keyboardModifiers());
        if (!widget) return;
        if (isClaimed)
            QApplication::sendEvent(widget, &event);
        else
            deliver(event, widget);
    }
}

void ClipboardCommands::press(QKeySequence::StandardKey keys) const {
    press(QKeySequence(keys));
}

void ClipboardCommands::cut() const {
    switch (target()) {
    case Target::Entries:
        return entries(m_context).cutSelected();
    case Target::Maps:
    case Target::CanvasOfMaps:
        return maps(m_context).cutMaps();
    case Target::Canvas:
        return m_context.messages->say(
            tr("Select maps or entries first: in their panels, or on the canvas with the Maps tool."));
    case Target::Other:
        return press(QKeySequence::Cut);
    }
}

void ClipboardCommands::copy() const {
    switch (target()) {
    case Target::Entries:
        return entries(m_context).copySelected();
    case Target::Canvas:
        return copyPicture();
    case Target::CanvasOfMaps:
        if (!m_context.stage->showsSpace() && m_context.canvas->selectedMaps().empty()) return copyPicture();
        [[fallthrough]];
    case Target::Maps:
        return maps(m_context).copyMaps();
    case Target::Other:
        return press(QKeySequence::Copy);
    }
}

// Copies the text of an entry without a picture.
void ClipboardCommands::copyPicture() const {
    auto* copying = m_context.window->findChild<QAction*>(QStringLiteral("copy-picture"));
    if (copying && copying->isEnabled())
        copying->trigger();
    else
        entries(m_context).copySelected();
}

void ClipboardCommands::paste() const {
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const Target at = target();
    if (at == Target::Maps || (at == Target::CanvasOfMaps && data && view::holdsOurMaps(*data)))
        return maps(m_context).appendPasted();
    if (at == Target::Other && takesText(*QApplication::focusWidget())) return press(QKeySequence::Paste);
    entries(m_context).paste();
}

void ClipboardCommands::duplicate() const {
    switch (target()) {
    case Target::Entries:
        return entries(m_context).duplicateSelected();
    case Target::Maps:
        return maps(m_context).duplicateMaps();
    default:
        return press(QKeySequence(Qt::Key_Insert));
    }
}

void ClipboardCommands::remove() const {
    switch (target()) {
    case Target::Entries:
        return entries(m_context).removeSelected();
    case Target::Maps:
        return maps(m_context).deleteMaps();
    default:
        return press(QKeySequence(Qt::Key_Delete));
    }
}

void ClipboardCommands::selectAll() const {
    if (target() == Target::Maps) return maps(m_context).selectAllMaps();
    press(QKeySequence(Qt::CTRL | Qt::Key_A));
}
