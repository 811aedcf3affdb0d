// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>

#include <chrono>
#include <functional>
#include <optional>

// Questions about files to which a window needs an answer at once. They may lie on a drive that answers in
// seconds, or never, as of another computer that is switched off. So they are asked in another thread, and
// what has not answered within a moment counts as unknown.
namespace io {

inline constexpr std::chrono::milliseconds soon{50};

// What `question` returns, if it does so in time. It goes on unheard otherwise, perhaps beyond the end of the
// program: it holds nothing but values.
std::optional<bool> answerSoon(std::function<bool()> question, std::chrono::milliseconds patience = soon);

// The paths without those where there is no file any more, in their order. A path that does not answer is as
// it was known to be the last time, and there when it was never known. To be called in one thread.
QStringList withoutGone(const QStringList& paths, std::chrono::milliseconds patience = soon);

} // namespace io
