// SPDX-License-Identifier: MIT
#include "progress_bar.h"

#include "usage_error.h"

#include <QCoreApplication>

#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace cli {

ProgressMode progressMode(const std::string& text) {
    if (text == "always") return ProgressMode::Always;
    if (text == "never") return ProgressMode::Never;
    if (text == "auto") return ProgressMode::Auto;
    throw UsageError{
        QCoreApplication::translate("cli", "--progress takes always, never or auto, and not “%1”.")
            .arg(QString::fromStdString(text))};
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

void ProgressBar::show(double fraction) {
    constexpr int width = 40;
    const int percent = int(std::lround(100 * fraction));
    if (!m_visible || percent == m_percent) return;
    m_percent = percent;
    std::string bar(std::size_t(width * percent / 100), '#');
    bar.resize(width, '.');
    std::fprintf(stderr, "\r[%s] %3d %%", bar.c_str(), percent);
    std::fflush(stderr);
}

} // namespace cli
