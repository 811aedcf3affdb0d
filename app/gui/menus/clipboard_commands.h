// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

// Cut, Copy, Paste, Duplicate, Delete and Select All, of whatever has the focus: maps, entries, text, or what
// a panel or a tool makes of these keys.
class ClipboardCommands {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit ClipboardCommands(const MenuContext& context) : m_context(context) {}

    void cut() const;
    // The picture of the canvas; selected maps as rows; selected entries as text.
    void copy() const;
    void paste() const;
    void duplicate() const;
    void remove() const;
    void selectAll() const;

private:
    enum class Target { Entries, Maps, CanvasOfMaps, Canvas, Other };
    Target target() const;
    void copyPicture() const;
    void press(QKeySequence::StandardKey keys) const; // goes to the widget that has the focus
    void press(const QKeySequence& keys) const;

    MenuContext m_context;
};
