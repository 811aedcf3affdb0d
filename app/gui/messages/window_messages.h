// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QObject>

class QMainWindow;
class QMessageBox;

// Messages of a window to its user.
class WindowMessages : public QObject {
    Q_OBJECT

public:
    explicit WindowMessages(QMainWindow* window);

    void say(const QString& sentence);                        // message in the status bar, for a few seconds
    void fail(const QString& title, const QString& sentence); // message box; returns at once

private:
    QMainWindow* m_window;
    QList<QMessageBox*> m_failures; // only the first one is open
};
