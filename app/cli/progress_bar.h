// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace cli {

enum class ProgressMode { Always, Never, Auto }; // Auto: when standard error is a terminal

ProgressMode progressMode(const std::string& text); // throws UsageError

// One line on standard error that is drawn over, and gone at the end.
class ProgressBar {
public:
    explicit ProgressBar(ProgressMode mode);
    ~ProgressBar();

    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(double fraction);
    void clear();

private:
    bool m_visible;
    int m_percent = -1;
};

} // namespace cli
