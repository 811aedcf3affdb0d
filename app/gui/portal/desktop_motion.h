// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QDBusVariant;

// Asks the settings portal of the desktop whether motion is to be reduced, without waiting for it, and hears
// of changes. Without a session bus nothing is asked.
class DesktopMotion : public QObject {
    Q_OBJECT

public:
    explicit DesktopMotion(QObject* parent);

private slots:
    void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void ask(const QString& group, const QString& key);
};
