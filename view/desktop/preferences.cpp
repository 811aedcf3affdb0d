// SPDX-License-Identifier: MIT
#include "desktop/preferences.h"

#include "desktop/settings.h"
#include "ifs/names.h"

#include <QCoreApplication>
#include <QVariant>

#include <algorithm>
#include <tuple>
#include <type_traits>

// Names in the settings.
template <>
inline constexpr auto ifs::names<view::Preferences::Theme> =
    std::to_array<ifs::Named<view::Preferences::Theme>>({{view::Preferences::Theme::Desktop, "desktop"},
                                                         {view::Preferences::Theme::Light, "light"},
                                                         {view::Preferences::Theme::Dark, "dark"}});
template <>
inline constexpr auto ifs::names<view::Preferences::Motion> =
    std::to_array<ifs::Named<view::Preferences::Motion>>({{view::Preferences::Motion::Desktop, "desktop"},
                                                          {view::Preferences::Motion::Reduced, "reduced"},
                                                          {view::Preferences::Motion::Full, "full"}});

namespace view {

namespace {

template <class Value> struct PreferenceRow {
    const char* key; // permanent
    Value Preferences::*member;
};
template <class Value>
PreferenceRow(const char*, Value Preferences::*) -> PreferenceRow<Value>; // for clang 14

constexpr std::tuple preferenceRows{
    PreferenceRow{"preferences/language", &Preferences::language},
    PreferenceRow{"preferences/theme", &Preferences::theme},
    PreferenceRow{"preferences/motion", &Preferences::motion},
    PreferenceRow{"preferences/quality", &Preferences::quality},
    PreferenceRow{"preferences/trackball", &Preferences::trackball},
    PreferenceRow{"preferences/labels", &Preferences::labels},
    PreferenceRow{"preferences/tools", &Preferences::tools},
    PreferenceRow{"preferences/reopen", &Preferences::reopen},
    PreferenceRow{"preferences/keepPrevious", &Preferences::keepPrevious},
};

template <class Value> QVariant inSettings(const Value& value) {
    if constexpr (std::is_enum_v<Value>)
        return QString::fromLatin1(ifs::nameOf(value));
    else if constexpr (std::is_same_v<Value, std::uint64_t>)
        return quint64(value);
    else
        return value;
}

template <class Value> Value fromSettings(const QVariant& found, const Value& otherwise) {
    if (!found.isValid()) return otherwise;
    if constexpr (std::is_enum_v<Value>)
        return ifs::named<Value>(found.toString().toStdString()).value_or(otherwise);
    else if constexpr (std::is_same_v<Value, std::uint64_t>)
        return std::clamp<std::uint64_t>(found.toULongLong(), 1'000'000, 100'000'000'000);
    else
        return found.value<Value>();
}

constexpr char spoken[] = "spokenLanguage"; // property of the application

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
    const auto read = [&found](const auto& row) {
        found.*row.member = fromSettings(view::stored(QLatin1String(row.key)), found.*row.member);
    };
    std::apply([&read](const auto&... row) { (read(row), ...); }, preferenceRows);
    return found;
}

void Preferences::store() const {
    const auto write = [this](const auto& row) {
        view::store(QLatin1String(row.key), inSettings(this->*row.member));
    };
    std::apply([&write](const auto&... row) { (write(row), ...); }, preferenceRows);
}

} // namespace view
