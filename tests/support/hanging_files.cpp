// SPDX-License-Identifier: MIT
// A library to be loaded before all others (LD_PRELOAD): a drive that does not answer. Calls to the system
// that name something below one of the folders in BARYCAGE_HANGING, separated by colons, or a file there that
// is open, never return, from the moment when there is the file that BARYCAGE_HANGING_SINCE names. A line for
// each is added to the file of that name with “.met” behind it. BARYCAGE_HANGING_CALLS may name the only
// functions that do so, likewise separated.
#undef _FORTIFY_SOURCE // these functions are defined here, not checked

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

bool isBelow(const char* path, const char* folder, std::size_t length) {
    return std::strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

// Whether one of the names, separated by colons, is so.
template <class Condition> bool isAny(const char* names, const Condition& isSo) {
    while (names && *names) {
        const std::size_t length = std::strcspn(names, ":");
        if (length > 0 && isSo(names, length)) return true;
        names += length + (names[length] == ':' ? 1 : 0);
    }
    return false;
}

bool isDead(const char* path) {
    static const char* const folders = std::getenv("BARYCAGE_HANGING");
    return isAny(folders,
                 [path](const char* folder, std::size_t length) { return isBelow(path, folder, length); });
}

bool isMeant(const char* function) {
    static const char* const calls = std::getenv("BARYCAGE_HANGING_CALLS");
    return !calls || isAny(calls, [function](const char* name, std::size_t length) {
        return std::strlen(function) == length && std::strncmp(function, name, length) == 0;
    });
}

// Past the functions below.
bool hasBegun() {
    static const char* const since = std::getenv("BARYCAGE_HANGING_SINCE");
    return since && ::syscall(SYS_faccessat, AT_FDCWD, since, F_OK) == 0;
}

void tell(const char* function, const char* path) {
    const std::string name = std::string(std::getenv("BARYCAGE_HANGING_SINCE")) + ".met";
    const std::string line = std::string(function) + ' ' + path + '\n';
    const auto file = ::syscall(SYS_openat, AT_FDCWD, name.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    if (file < 0 || ::syscall(SYS_write, file, line.data(), line.size()) < 0) std::abort();
    ::syscall(SYS_close, file);
}

void meet(const char* function, const char* path) {
    if (!path || !isMeant(function) || !isDead(path) || !hasBegun()) return;
    tell(function, path);
    for (;;)
        ::pause(); // signals are handled meanwhile
}

void meet(const char* function, int file) {
    if (file < 0 || !isMeant(function) || !hasBegun()) return;
    char link[64], path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const auto length = ::syscall(SYS_readlinkat, AT_FDCWD, link, path, sizeof path - 1);
    if (length <= 0) return;
    path[length] = '\0';
    meet(function, path);
}

void meet(const char* function, int folder, const char* path) {
    if (path && path[0] != '/' && folder != AT_FDCWD)
        meet(function, folder);
    else
        meet(function, path);
}

template <class Function> Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

#define BARYCAGE_SEEN extern "C" __attribute__((visibility("default")))
// A function of the system whose name, type, parameters, exception specification, arguments and path are
// these.
#define BARYCAGE_HANGS(name, type, parameters, specification, arguments, ...)                                \
    BARYCAGE_SEEN type name parameters specification {                                                       \
        static auto* const real = next<type parameters>(#name);                                              \
        meet(#name, __VA_ARGS__);                                                                            \
        return real arguments;                                                                               \
    }

BARYCAGE_HANGS(access, int, (const char* path, int mode), noexcept, (path, mode), path)
BARYCAGE_HANGS(stat, int, (const char* path, struct stat* into), noexcept, (path, into), path)
BARYCAGE_HANGS(stat64, int, (const char* path, struct stat64* into), noexcept, (path, into), path)
BARYCAGE_HANGS(lstat, int, (const char* path, struct stat* into), noexcept, (path, into), path)
BARYCAGE_HANGS(lstat64, int, (const char* path, struct stat64* into), noexcept, (path, into), path)
BARYCAGE_HANGS(statx, int, (int folder, const char* path, int flags, unsigned mask, struct statx* into),
               noexcept, (folder, path, flags, mask, into), folder, path)
BARYCAGE_HANGS(chmod, int, (const char* path, mode_t mode), noexcept, (path, mode), path)
BARYCAGE_HANGS(mkdir, int, (const char* path, mode_t mode), noexcept, (path, mode), path)
BARYCAGE_HANGS(unlink, int, (const char* path), noexcept, (path), path)
BARYCAGE_HANGS(rename, int, (const char* from, const char* to), noexcept, (from, to), from)
BARYCAGE_HANGS(link, int, (const char* from, const char* to), noexcept, (from, to), to)
BARYCAGE_HANGS(linkat, int, (int from, const char* old, int to, const char* name, int flags), noexcept,
               (from, old, to, name, flags), to, name)
BARYCAGE_HANGS(readlink, ssize_t, (const char* path, char* into, size_t size), noexcept, (path, into, size),
               path)
BARYCAGE_HANGS(realpath, char*, (const char* path, char* into), noexcept, (path, into), path)
BARYCAGE_HANGS(opendir, DIR*, (const char* path), , (path), path)
BARYCAGE_HANGS(read, ssize_t, (int file, void* into, size_t size), , (file, into, size), file)
BARYCAGE_HANGS(write, ssize_t, (int file, const void* from, size_t size), , (file, from, size), file)
BARYCAGE_HANGS(pwrite, ssize_t, (int file, const void* from, size_t size, off_t at), , (file, from, size, at),
               file)
BARYCAGE_HANGS(pwrite64, ssize_t, (int file, const void* from, size_t size, off64_t at), ,
               (file, from, size, at), file)
BARYCAGE_HANGS(fsync, int, (int file), , (file), file)
BARYCAGE_HANGS(fdatasync, int, (int file), , (file), file)

// Those with parameters that are there only sometimes.
#define BARYCAGE_HANGS_OPENING(name, type, parameters, arguments, ...)                                       \
    BARYCAGE_SEEN int name parameters {                                                                      \
        static auto* const real = next<type>(#name);                                                         \
        va_list rest;                                                                                        \
        va_start(rest, flags);                                                                               \
        const mode_t mode = va_arg(rest, mode_t);                                                            \
        va_end(rest);                                                                                        \
        meet(#name, __VA_ARGS__);                                                                            \
        return real arguments;                                                                               \
    }

BARYCAGE_HANGS_OPENING(open, int(const char*, int, ...), (const char* path, int flags, ...),
                       (path, flags, mode), path)
BARYCAGE_HANGS_OPENING(open64, int(const char*, int, ...), (const char* path, int flags, ...),
                       (path, flags, mode), path)
BARYCAGE_HANGS_OPENING(openat, int(int, const char*, int, ...),
                       (int folder, const char* path, int flags, ...), (folder, path, flags, mode), folder,
                       path)
BARYCAGE_HANGS_OPENING(openat64, int(int, const char*, int, ...),
                       (int folder, const char* path, int flags, ...), (folder, path, flags, mode), folder,
                       path)
