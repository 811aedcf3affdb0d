// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

#include <cstdint>

namespace view {

// The user's preferences for all windows, kept between runs. A value: whoever changes it stores it and tells.
struct Preferences {
    enum class Theme { Desktop, Light, Dark };
    enum class Motion { Desktop, Reduced, Full };

    QString language; // "de", "mk"; empty: language of the desktop. In force from the next start.
    Theme theme = Theme::Desktop;
    std::uint64_t quality = 200'000'000; // samples at which an idle picture stops refining
    bool trackball = false;              // true: solids turn freely; false: as on a turntable
    bool reopen = false;                 // true: the next start reopens the files of the last run
    bool keepPrevious = true;            // true: the first save of a file keeps the version before
    bool labels = true;                  // true: names under the symbols of the tool bar
    QStringList tools;                   // ids of the commands in the tool bar; empty: default
    Motion motion = Motion::Desktop;     // setting for motion that nobody requested

    static Preferences stored();
    void store() const;

    // The language that the program was started in; the stored one unless it was said.
    static QString spokenLanguage();
    static void setSpokenLanguage(const QString& language);

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

// Id of a line between two commands of the tool bar. No command has this id.
inline QString separatorId() {
    return QStringLiteral("-");
}

} // namespace view
