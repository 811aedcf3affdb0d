// SPDX-License-Identifier: MIT
#pragma once

#include <system_error>

// Behaviour when the system refuses a thread or memory: the program says so, and never waits for a thread
// that was not started.
namespace shortage {

// Starts the threads of the background work. From now on, the program ends with a sentence and exitStatus
// when a thread of its own or of Qt is not started, which Qt itself would wait for without end; after
// everythingHasStarted(), a message box says so.
void watchThreads();

// Starts the threads of Qt's global pool, which then needs no others. Needs the application.
void startThreads();
void everythingHasStarted();

// Returns true if the system refused a thread.
bool isOfThread(const std::system_error& error);

// Reports in a message box, without waiting for it, and on standard error.
void sayNoThread();
void sayNoMemory();

// Says in a message box and on standard error that no thread could be started, and ends the program, in which
// nothing is unsaved.
[[noreturn]] void endAtStart();

constexpr int exitStatus = 3; // same as in barycage-cli

} // namespace shortage
