// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <cstdint>

namespace view {

// The user's preferences for all windows, kept between runs. A value: whoever changes it stores it and tells.
struct Preferences {
    enum class Theme { Desktop, Light, Dark };
    enum class Motion { Desktop, Reduced, Full };

    QString language; // "de", "mk"; empty: that of the desktop. In force from the next start.
    Theme theme = Theme::Desktop;
    std::uint64_t quality = 200'000'000; // samples to which a picture at rest is refined
    bool trackball = false;              // solids turn freely, not as on a turntable
    bool reopen = false;                 // the files of the last time, at the start
    bool keepPrevious = true;            // versions of files, when they are saved for the first time
    bool labels = true;                  // names under the symbols of the tool bar
    QStringList tools;                   // ids of the commands in the tool bar; empty: the usual ones
    Motion motion = Motion::Desktop;     // of what moves without having been asked to

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
