// SPDX-License-Identifier: MIT
#include "desktop/reduced_motion.h"

#include "desktop/preferences.h"

#include <QApplication>
#include <QByteArray>
#include <QStyle>

namespace view {

namespace {

constexpr MotionSetting knownSettings[] = {
    {"org.freedesktop.appearance", "reduced-motion", true},
    {"org.gnome.desktop.interface", "enable-animations", false},
};

// The property of the application that holds the answer of the desktop.
QByteArray propertyOf(const MotionSetting& setting) {
    return QByteArray("desktop/") + setting.key;
}

} // namespace

std::span<const MotionSetting> motionSettings() {
    return knownSettings;
}

bool reducesMotion() {
    const Preferences::Motion preferred = Preferences::stored().motion;
    if (preferred != Preferences::Motion::Desktop) return preferred == Preferences::Motion::Reduced;
    bool isAnswered = false;
    for (const MotionSetting& setting : knownSettings) {
        const QVariant reduced = qApp->property(propertyOf(setting).constData());
        if (reduced.toBool()) return true;
        isAnswered = isAnswered || reduced.isValid();
    }
    return !isAnswered && QApplication::style()->styleHint(QStyle::SH_Widget_Animation_Duration) == 0;
}

void takeDesktopSetting(const QString& group, const QString& key, const QVariant& value) {
    for (const MotionSetting& setting : knownSettings)
        if (group == QLatin1String(setting.group) && key == QLatin1String(setting.key) && value.isValid())
            qApp->setProperty(propertyOf(setting).constData(), value.toBool() == setting.isReducedBy);
}

} // namespace view
