// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/preferences.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QLayout;
class QPushButton;

namespace view {

// The few things that are a matter of taste. Each choice is stored and in force at once; the language waits
// for the next start, which the dialog offers.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    explicit PreferencesDialog(QWidget* parent = nullptr);

    // Files with changes that a restart would ask about.
    void setUnsaved(const QStringList& names);

signals:
    void changed(const view::Preferences& preferences); // they are stored already
    void restartRequested();

private:
    QLayout* restartRow();
    void fill(const Preferences& preferences);
    void take();
    void showRestart(bool shown);

    QString m_spoken; // the choice of language when the dialog was opened
    QComboBox* m_language;
    QLabel* m_restart;
    QPushButton* m_restartNow;
    QComboBox* m_theme;
    QComboBox* m_motion;
    QComboBox* m_quality;
    QComboBox* m_turning;
    QCheckBox* m_reopen;
    QCheckBox* m_keepPrevious;
};

} // namespace view
