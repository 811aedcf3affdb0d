// SPDX-License-Identifier: MIT
#include "preferences.h"

#include <QSettings>

#include <algorithm>

namespace view {

namespace {

const QString languageKey = QStringLiteral("preferences/language");
const QString themeKey = QStringLiteral("preferences/theme");
const QString qualityKey = QStringLiteral("preferences/quality");
const QString reopenKey = QStringLiteral("preferences/reopen");

} // namespace

Preferences Preferences::stored() {
    const QSettings settings;
    Preferences found;
    found.language = settings.value(languageKey).toString();
    const QString theme = settings.value(themeKey).toString();
    if (theme == QLatin1String("light")) found.theme = Theme::Light;
    if (theme == QLatin1String("dark")) found.theme = Theme::Dark;
    found.quality = std::clamp<std::uint64_t>(
        settings.value(qualityKey, quint64(found.quality)).toULongLong(), 1'000'000, 100'000'000'000);
    found.reopen = settings.value(reopenKey, found.reopen).toBool();
    return found;
}

void Preferences::store() const {
    QSettings settings;
    settings.setValue(languageKey, language);
    settings.setValue(themeKey, theme == Theme::Light  ? QStringLiteral("light")
                                : theme == Theme::Dark ? QStringLiteral("dark")
                                                       : QStringLiteral("desktop"));
    settings.setValue(qualityKey, quint64(quality));
    settings.setValue(reopenKey, reopen);
}

} // namespace view
