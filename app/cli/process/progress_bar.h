// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/names.h"

#include <array>
#include <chrono>
#include <string>

namespace cli {

struct Command;

enum class ProgressMode { Always, Never, Auto }; // Auto: when standard error is a terminal

// Amount of messages from a command while it works.
struct Verbosity {
    ProgressMode progress = ProgressMode::Auto;
    bool isQuiet = false; // neither progress nor warnings
};
void addVerbosityOptions(Command& command, Verbosity& verbosity);
ProgressMode applied(const Verbosity& verbosity); // also hides warnings, if they are not wanted

// A line on standard error that is drawn over, and gone at the end. For work that takes longer than a few
// seconds it includes the time left.
class ProgressBar {
public:
    explicit ProgressBar(ProgressMode mode);
    ~ProgressBar();

    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(double fraction);
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    std::string timeLeft(double fraction) const;

    bool m_visible;
    int m_percent = -1;
    Clock::time_point m_begin = Clock::now();
};

} // namespace cli

template <>
inline constexpr auto ifs::names<cli::ProgressMode> =
    std::to_array<ifs::Named<cli::ProgressMode>>({{cli::ProgressMode::Always, "always"},
                                                  {cli::ProgressMode::Never, "never"},
                                                  {cli::ProgressMode::Auto, "auto"}});
