// SPDX-License-Identifier: MIT
// A library to be loaded before all others (LD_PRELOAD): a limit on processes. The program gets no more
// threads than BARYCAGE_THREADS, if that is set, and none from the moment when there is the file that
// BARYCAGE_NO_THREADS_SINCE names.
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

bool isRefused() {
    static std::atomic<int> started = 0;
    static const char* const most = std::getenv("BARYCAGE_THREADS");
    static const char* const since = std::getenv("BARYCAGE_NO_THREADS_SINCE");
    if (since && ::syscall(SYS_faccessat, AT_FDCWD, since, F_OK) == 0) return true;
    return most && started++ >= std::atoi(most);
}

} // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                              void* argument) noexcept {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto create = reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"));
    return isRefused() ? EAGAIN : create(thread, attributes, work, argument);
}
