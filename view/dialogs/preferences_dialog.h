// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/preferences.h"
#include "dialogs/command_palette.h"

#include <QDialog>
#include <QList>

#include <functional>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QTabWidget;

namespace view {

// The few things that are a matter of taste, and the keys of commands. Each choice is stored and in force at
// once; the language waits for the next start, which the dialog offers.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    // `usualTools` are the default content of the toolbar. Without commands there are no pages of shortcuts
    // and of the toolbar.
    explicit PreferencesDialog(QWidget* parent = nullptr, const QList<NamedAction>& commands = {},
                               const QStringList& usualTools = {});

    // Files with changes that a restart would ask about.
    void setUnsaved(const QStringList& names);

signals:
    void changed(const view::Preferences& preferences); // sent after they are stored
    void restartRequested();

private:
    void addPages(const QList<NamedAction>& commands, const QStringList& usualTools);
    void addToolbarPage(const QList<NamedAction>& commands, const QStringList& usualTools);
    QWidget* generalPage();
    void addLanguage(QFormLayout* form);
    void restoreDefaults();
    // A row of the page: the widget for one preference, which it shows and takes.
    template <class Value>
    QComboBox* list(Value Preferences::*member, const QString& name, const QString& whatsThis,
                    const QList<std::pair<QString, Value>>& choices);
    QCheckBox* checkBox(bool Preferences::*member, const QString& text, const QString& whatsThis);
    void fill(const Preferences& preferences);
    void take();
    void showRestart(bool shown);

    QTabWidget* m_pages;
    QString m_spoken; // language at the opening of the dialog
    QLabel* m_restart = nullptr;
    QPushButton* m_restartNow = nullptr;
    struct Field {
        std::function<void(const Preferences&)> show;
        std::function<void(Preferences&)> take;
    };
    std::vector<Field> m_fields; // fields of the rows
    bool m_isFilling = false;
};

} // namespace view
