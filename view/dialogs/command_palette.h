// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QIcon>
#include <QList>

class QAction;
class QLineEdit;
class QListView;
class QMainWindow;
class QStandardItemModel;

namespace view {

// An action and where it is found: through the menus ("View › Canvas › Snap To › Grid"), in a panel
// ("Maps › Add") or in a bar ("How It Is Built › Chaos Game"). A button that has no action has one here,
// which clicks it, and so has a field with a label, which is gone to ("Appearance › Brightness").
struct NamedAction {
    QAction* action;
    QString path;
    QWidget* panel = nullptr; // panel or bar that has it; null: menu bar
};
// A property of actions whose text is not the name of the command.
inline constexpr char commandName[] = "commandName";

QList<NamedAction> actionsOf(const QWidget* menuBar);
// Commands of the menu bar, then those of the panels and bars that no menu has.
QList<NamedAction> actionsOf(const QMainWindow& window);

// Finds any command of a window by a few letters of its text.
class CommandPalette : public QDialog {
    Q_OBJECT

public:
    explicit CommandPalette(const QList<NamedAction>& actions, QWidget* parent = nullptr);

signals:
    void guideRequested(const QString& words); // sent to search the typed words in the guide

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    // Fields to search, each in addition to those before.
    enum class SearchIn { Whole, Words, Names, Synonyms, Descriptions };

    void filter(const QString& text);
    void add(const QString& text, SearchIn in, bool enabled);
    void addGuide(const QString& text);
    void run();

    QList<NamedAction> m_actions;
    QStandardItemModel* m_model;
    QIcon m_noIcon; // as wide as the others, so that all names are aligned
    QLineEdit* m_search;
    QListView* m_list;
};

// The same beside what a command is also called: its synonyms.
bool meansCommand(const QString& title, const QString& text);

// Returns true if every word of `text` begins a word of `title`; case does not matter.
bool matchesCommand(const QString& title, const QString& text);

// Returns true if every word of `text` is a word of `title`.
bool namesCommand(const QString& title, const QString& text);

} // namespace view
