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

// The result of `question`, if it comes in time. Otherwise the call goes on unnoticed, perhaps beyond the end
// of the program: `question` must hold nothing but values.
std::optional<bool> answerSoon(std::function<bool()> question, std::chrono::milliseconds patience = soon);

// The paths without those where there is no file any more, in their order. A path that does not answer is as
// it was known to be the last time, and there when it was never known. To be called in one thread.
QStringList withoutGone(const QStringList& paths, std::chrono::milliseconds patience = soon);

} // namespace io
