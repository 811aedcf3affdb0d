// SPDX-License-Identifier: MIT
#include "portal/desktop_motion.h"

#include "desktop/reduced_motion.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QFileInfo>
#include <QVariant>

namespace {

// Connecting without one would start a bus of our own.
bool hasSessionBus() {
    return qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
           QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus"));
}

const QString portalName = QStringLiteral("org.freedesktop.portal.Desktop");
const QString portalPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString settingsInterface = QStringLiteral("org.freedesktop.portal.Settings");

// An answer to Read is wrapped twice.
QVariant unwrapped(QVariant value) {
    while (value.canConvert<QDBusVariant>())
        value = value.value<QDBusVariant>().variant();
    return value;
}

} // namespace

DesktopMotion::DesktopMotion(QObject* parent) : QObject(parent) {
    if (!hasSessionBus()) return;
    for (const view::MotionSetting& setting : view::motionSettings())
        ask(QString::fromLatin1(setting.group), QString::fromLatin1(setting.key));
    QDBusConnection::sessionBus().connect(portalName, portalPath, settingsInterface,
                                          QStringLiteral("SettingChanged"), this,
                                          SLOT(settingChanged(QString, QString, QDBusVariant)));
}

void DesktopMotion::ask(const QString& group, const QString& key) {
    QDBusMessage question =
        QDBusMessage::createMethodCall(portalName, portalPath, settingsInterface, QStringLiteral("Read"));
    question.setArguments({group, key});
    auto* answer = new QDBusPendingCallWatcher(QDBusConnection::sessionBus().asyncCall(question), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [answer, group, key] {
        const QDBusPendingReply<QDBusVariant> reply = *answer;
        if (!reply.isError())
            view::takeDesktopSetting(group, key, unwrapped(QVariant::fromValue(reply.value())));
        answer->deleteLater();
    });
}

void DesktopMotion::settingChanged(const QString& group, const QString& key, const QDBusVariant& value) {
    view::takeDesktopSetting(group, key, unwrapped(QVariant::fromValue(value)));
}
