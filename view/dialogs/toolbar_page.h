// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/command_palette.h"

#include <QStringList>
#include <QWidget>

class QComboBox;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace view {

/// The commands of the toolbar in their order, to be dragged, removed and added to.
class ToolbarPage : public QWidget {
    Q_OBJECT

public:
    /// All commands of the menus; the ids of the usual tools.
    ToolbarPage(const QList<NamedAction>& commands, const QStringList& usual, QWidget* parent = nullptr);

    void setTools(const QStringList& tools); // empty: default
    QStringList tools() const;               // empty: default

signals:
    void changed(); // sent for edits by the user

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QLayout* makeButtons();
    void insert(int row, const QString& id);
    void move(int by);
    void remove();
    void add();
    void listOthers();
    void updateButtons();
    QStringList ids() const;

    QList<NamedAction> m_commands; // commands that have an id
    const QStringList m_usual;
    QListWidget* m_list;
    QPushButton* m_up;
    QPushButton* m_down;
    QPushButton* m_remove;
    QComboBox* m_others; // commands that can be added
};

} // namespace view
