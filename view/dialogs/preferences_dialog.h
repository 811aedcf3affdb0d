// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/preferences.h"
#include "dialogs/command_palette.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QLayout;
class QPushButton;
class QTabWidget;

namespace view {

// The few things that are a matter of taste, and the keys of commands. Each choice is stored and in force at
// once; the language waits for the next start, which the dialog offers.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    // Without commands there is no page of shortcuts.
    explicit PreferencesDialog(QWidget* parent = nullptr, const QList<NamedAction>& commands = {});

    // Files with changes that a restart would ask about.
    void setUnsaved(const QStringList& names);

signals:
    void changed(const view::Preferences& preferences); // they are stored already
    void restartRequested();

private:
    void addPages(const QList<NamedAction>& commands);
    QWidget* generalPage();
    QLayout* restartRow();
    void restoreDefaults();
    void fill(const Preferences& preferences);
    void take();
    void showRestart(bool shown);

    QTabWidget* m_pages;
    QString m_spoken; // the choice of language when the dialog was opened
    QComboBox* m_language;
    QLabel* m_restart;
    QPushButton* m_restartNow;
    QComboBox* m_theme;
    QComboBox* m_motion;
    QComboBox* m_quality;
    QComboBox* m_turning;
    QCheckBox* m_labels;
    QCheckBox* m_reopen;
    QCheckBox* m_keepPrevious;
};

} // namespace view
