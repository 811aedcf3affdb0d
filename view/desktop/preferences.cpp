// SPDX-License-Identifier: MIT
#include "desktop/preferences.h"

#include "desktop/settings.h"

#include <QCoreApplication>
#include <QVariant>

#include <algorithm>

namespace view {

namespace {

const QString languageKey = QStringLiteral("preferences/language");
const QString themeKey = QStringLiteral("preferences/theme");
const QString motionKey = QStringLiteral("preferences/motion");
const QString qualityKey = QStringLiteral("preferences/quality");
const QString trackballKey = QStringLiteral("preferences/trackball");
const QString keepPreviousKey = QStringLiteral("preferences/keepPrevious");
const QString labelsKey = QStringLiteral("preferences/labels");
const QString reopenKey = QStringLiteral("preferences/reopen");

constexpr char spoken[] = "spokenLanguage"; // a property of the application

} // namespace

QString Preferences::spokenLanguage() {
    const QVariant language = qApp->property(spoken);
    return language.isValid() ? language.toString() : stored().language;
}

void Preferences::setSpokenLanguage(const QString& language) {
    qApp->setProperty(spoken, language);
}

Preferences Preferences::stored() {
    Preferences found;
    found.language = view::stored(languageKey).toString();
    const QString theme = view::stored(themeKey).toString();
    if (theme == QLatin1String("light")) found.theme = Theme::Light;
    if (theme == QLatin1String("dark")) found.theme = Theme::Dark;
    const QString motion = view::stored(motionKey).toString();
    if (motion == QLatin1String("reduced")) found.motion = Motion::Reduced;
    if (motion == QLatin1String("full")) found.motion = Motion::Full;
    found.quality = std::clamp<std::uint64_t>(view::stored(qualityKey, quint64(found.quality)).toULongLong(),
                                              1'000'000, 100'000'000'000);
    found.trackball = view::stored(trackballKey, found.trackball).toBool();
    found.reopen = view::stored(reopenKey, found.reopen).toBool();
    found.labels = view::stored(labelsKey, found.labels).toBool();
    found.keepPrevious = view::stored(keepPreviousKey, found.keepPrevious).toBool();
    return found;
}

void Preferences::store() const {
    view::store(languageKey, language);
    view::store(themeKey, theme == Theme::Light  ? QStringLiteral("light")
                          : theme == Theme::Dark ? QStringLiteral("dark")
                                                 : QStringLiteral("desktop"));
    view::store(motionKey, motion == Motion::Reduced ? QStringLiteral("reduced")
                           : motion == Motion::Full  ? QStringLiteral("full")
                                                     : QStringLiteral("desktop"));
    view::store(qualityKey, quint64(quality));
    view::store(trackballKey, trackball);
    view::store(reopenKey, reopen);
    view::store(labelsKey, labels);
    view::store(keepPreviousKey, keepPrevious);
}

} // namespace view
