// SPDX-License-Identifier: MIT
#include "process/progress_bar.h"

#include "options/options.h"
#include "process/arguments.h"
#include "process/messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace cli {

void addVerbosityOptions(Command& command, Verbosity& verbosity) {
    const OptionGroup general = command.group(generalOptions);
    general
        .add("--progress", "WHEN", choice(&verbosity.progress),
             "Progress bar: always, never, or auto for a terminal", "auto")
        .is(Work);
    general.flag("-q,--quiet", &verbosity.isQuiet, "No progress bar and no warnings").is(Work);
}

ProgressMode applied(const Verbosity& verbosity) {
    if (!verbosity.isQuiet) return verbosity.progress;
    hideWarnings();
    return ProgressMode::Never;
}

ProgressBar::ProgressBar(ProgressMode mode)
    : m_visible(mode == ProgressMode::Always || (mode == ProgressMode::Auto && isatty(STDERR_FILENO))) {}

ProgressBar::~ProgressBar() {
    clear();
}

void ProgressBar::clear() {
    if (m_percent >= 0) std::fputs("\r\033[K", stderr);
    m_percent = -1;
}

// ", 1:05 left", once it can be told.
std::string ProgressBar::timeLeft(double fraction) const {
    constexpr double patience = 3; // seconds
    const double passed = std::chrono::duration<double>(Clock::now() - m_begin).count();
    if (passed < patience || !(fraction > 0.01)) return {};
    const auto left = std::llround(std::min(passed * (1 - fraction) / fraction, 3.6e8));
    std::array<char, 48> text{};
    if (left >= 3600)
        std::snprintf(text.data(), text.size(), ", %lld:%02lld:%02lld left", left / 3600, left / 60 % 60,
                      left % 60);
    else
        std::snprintf(text.data(), text.size(), ", %lld:%02lld left", left / 60, left % 60);
    return text.data();
}

void ProgressBar::show(double fraction) {
    constexpr int width = 40;
    const int percent = int(std::lround(100 * fraction));
    if (!m_visible || percent == m_percent) return;
    m_percent = percent;
    std::string bar(std::size_t(width * percent / 100), '#');
    bar.resize(width, '.');
    std::fprintf(stderr, "\r[%s] %3d %%%s\033[K", bar.c_str(), percent, timeLeft(fraction).c_str());
    std::fflush(stderr);
}

} // namespace cli
