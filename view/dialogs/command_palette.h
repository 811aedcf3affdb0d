// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QIcon>
#include <QList>

class QAction;
class QLineEdit;
class QListView;
class QStandardItemModel;

namespace view {

// All actions that a menu bar offers, with their path through the menus ("View › Snap To › Grid").
struct NamedAction {
    QAction* action;
    QString path;
};
QList<NamedAction> actionsOf(const QWidget* menuBar);

// Every command of a window, found by typing a few letters of what it does.
class CommandPalette : public QDialog {
    Q_OBJECT

public:
    explicit CommandPalette(const QList<NamedAction>& actions, QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& text);
    void run();

    QList<NamedAction> m_actions;
    QStandardItemModel* m_model;
    QIcon m_noIcon; // as wide as the others, so that all names begin in one column
    QLineEdit* m_search;
    QListView* m_list;
};

// Whether every word of `text` begins a word of `title`; case does not matter.
bool matchesCommand(const QString& title, const QString& text);

} // namespace view
