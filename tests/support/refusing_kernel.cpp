// SPDX-License-Identifier: MIT
#include "support/refusing_kernel.h"

#include <cerrno>
#include <cstdarg>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace support {

bool readsFail = false;
int failedReads = 0;
bool linksAreProtected = false;
unsigned permissionsOfNewFiles = 0;

} // namespace support

namespace {

namespace fs = std::filesystem;

bool asked(const fs::path& path, int flags, struct stat& found) {
    return ::syscall(SYS_newfstatat, AT_FDCWD, path.c_str(), &found, flags) == 0;
}

// may_follow_link() of the kernel, for the last part of the path and each link that it leads to.
bool isRefused(fs::path path) {
    for (int i = 0; support::linksAreProtected && i < 40; ++i) {
        struct stat link {};
        struct stat folder {};
        const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
        if (!asked(path, AT_SYMLINK_NOFOLLOW, link) || !S_ISLNK(link.st_mode) || !asked(parent, 0, folder))
            return false;
        const bool isShared = (folder.st_mode & S_ISVTX) != 0 && (folder.st_mode & S_IWOTH) != 0;
        if (isShared && link.st_uid != ::geteuid() && link.st_uid != folder.st_uid) return true;
        char end[4096] = {};
        const long size = ::syscall(SYS_readlinkat, AT_FDCWD, path.c_str(), end, sizeof end - 1);
        if (size < 0) return false;
        path = parent / end;
    }
    return false;
}

int opened(const char* path, int flags, std::va_list rest) {
    if ((flags & O_NOFOLLOW) == 0 && isRefused(path)) {
        errno = EACCES;
        return -1;
    }
    const bool makesFile = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
    const mode_t mode = makesFile ? va_arg(rest, mode_t) : 0;
    const int file = int(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
    struct stat made {};
    if (makesFile && file >= 0 && ::fstat(file, &made) == 0)
        support::permissionsOfNewFiles |= made.st_mode & 0777;
    return file;
}

ssize_t readAt(int file, void* data, std::size_t size, off_t position) {
    if (!support::readsFail) return ::syscall(SYS_pread64, file, data, size, position);
    ++support::failedReads;
    errno = EIO;
    return -1;
}

int refusedOr(const char* path, struct stat* found) {
    if (!isRefused(path)) return int(::syscall(SYS_newfstatat, AT_FDCWD, path, found, 0));
    errno = EACCES;
    return -1;
}

} // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const int file = opened(path, flags, rest);
    va_end(rest);
    return file;
}

int open64(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const int file = opened(path, flags, rest);
    va_end(rest);
    return file;
}

int stat(const char* path, struct stat* found) noexcept {
    return refusedOr(path, found);
}

int stat64(const char* path, struct stat64* found) noexcept {
    return refusedOr(path, reinterpret_cast<struct stat*>(found)); // one layout on 64-bit systems
}

ssize_t pread(int file, void* data, size_t size, off_t position) {
    return readAt(file, data, size, position);
}

ssize_t pread64(int file, void* data, size_t size, off64_t position) {
    return readAt(file, data, size, position);
}
}
