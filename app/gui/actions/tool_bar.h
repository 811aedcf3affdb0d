// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/preferences.h"

#include <QMainWindow>
#include <QStringList>
#include <QToolBar>

/// The toolbar of a window: commands in the order that the user has chosen.
class ToolBar : public QToolBar {
    Q_OBJECT

public:
    /// The usual tools, in groups. The window has them, and every other command, among its actions.
    ToolBar(const QString& title, const QList<QList<QAction*>>& groups, QMainWindow* window);

    /// The ids of the usual tools, view::separatorId between groups.
    const QStringList& usualTools() const { return m_usual; }
    void adopt(const view::Preferences& preferences);

private:
    void arrange(const QStringList& ids);

    QStringList m_usual;
    QStringList m_shown;
};
