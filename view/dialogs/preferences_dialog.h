// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/preferences.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;

namespace view {

// The few things that are a matter of taste. Each choice is stored and in force at once; the language waits
// for the next start, and the dialog says so.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    explicit PreferencesDialog(QWidget* parent = nullptr);

    // Files with changes that a restart would ask about.
    void setUnsaved(const QStringList& names);

signals:
    void changed(const view::Preferences& preferences); // they are stored already

private:
    void fill(const Preferences& preferences);
    void take();

    QString m_spoken; // the choice of language when the dialog was opened
    QComboBox* m_language;
    QLabel* m_restart;
    QComboBox* m_theme;
    QComboBox* m_quality;
    QComboBox* m_turning;
    QCheckBox* m_reopen;
};

} // namespace view
