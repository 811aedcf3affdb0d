// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/shortcuts.h"
#include "dialogs/command_palette.h"

#include <QWidget>

#include <optional>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace view {

// The commands of the menus with their keys, which can be changed. A choice is stored and in force in all
// windows at once; keys that another command has are offered in exchange for those of this one.
class ShortcutsPage : public QWidget {
    Q_OBJECT

public:
    explicit ShortcutsPage(const QList<NamedAction>& commands, QWidget* parent = nullptr);

    void restoreDefaults();

private:
    struct Clash {
        QAction* other;
        Shortcuts keys; // shortcuts of `other`
    };

    QLayout* editorRow();
    QLayout* noteRow();
    void addCommands(const QList<NamedAction>& commands);
    void filter(const QString& text);
    void showCurrent();
    void showKeys(QTreeWidgetItem* item);
    void take(const Shortcuts& keys);
    void give(const QAction& command, const Shortcuts& keys);
    void swap();
    void say(const QString& sentence, const std::optional<Clash>& clash = std::nullopt);
    QAction* current() const; // null if no command is selected
    QAction* ownerOf(const Shortcuts& keys) const;

    QList<QTreeWidgetItem*> m_items;
    std::optional<Clash> m_clash;
    QLineEdit* m_search;
    QTreeWidget* m_tree;
    QKeySequenceEdit* m_edit;
    QPushButton* m_clear;
    QPushButton* m_default;
    QLabel* m_note;
    QPushButton* m_swap;
};

} // namespace view
