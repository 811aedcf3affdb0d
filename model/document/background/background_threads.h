// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <stop_token>

// Threads for work that may take long, or never end, such as reading from a drive that does not answer. They
// are not those of QThreadPool::globalInstance(): Qt paints large pictures with those and waits for them, and
// a program does not end before they do. If the system starts no more threads, the existing ones do the work.
namespace document {

// Kinds of work that never wait for each other.
enum class Lane {
    Computing, // no files
    Asking,    // existence and place of files
    Reading,
    Saving,   // includes questions about a file before it is saved
    Exporting // drawing into files; can be stopped
};
// Work of one kind waits as soon as so much of it is under way, far more than there are cores. A thread is
// made when it is needed.
inline constexpr int threadsOfLane = 256;

// A thread for each kind, with which all work is done sooner or later. The program does this when it starts;
// otherwise the first work does. Throws std::system_error when the system starts no thread.
void startLanes();

void startInLane(Lane lane, std::function<void()> work);

// Waits, at most for `patience`, until no work is under way or waiting in any lane; returns true if so. The
// end of the application waits like this for a moment, longer for saving. After that, a program with work
// still under way has to end without destroying what the work uses: quickExit().
bool backgroundFinishes(std::chrono::milliseconds patience);

// The same for one kind.
bool laneFinishes(Lane lane, std::chrono::milliseconds patience);

// The end of the program, which may come suddenly: whatever can stop does so as soon as it is announced.
std::stop_token endOfProgram();
void announceEnd();

// Ends the process at once, with all that is written to the standard streams.
[[noreturn]] void quickExit(int status);

} // namespace document
