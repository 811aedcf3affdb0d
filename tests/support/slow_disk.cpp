// SPDX-License-Identifier: MIT
#undef _FORTIFY_SOURCE // these functions are defined here, not checked

#include "support/slow_disk.h"

#include <QByteArray>
#include <QFile>

#include <atomic>
#include <condition_variable>
#include <cstdarg>
#include <cstring>
#include <dirent.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <mutex>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace {

struct Drive {
    std::atomic<bool> isMounted = false;
    bool isLate = false;
    QByteArray folder;
    std::chrono::milliseconds delay{0};
    std::thread::id window;
    std::atomic<int> waited = 0;
    std::mutex mutex;
    std::condition_variable answering;
    QStringList noted;
};

Drive& drive() {
    static auto* const only = new Drive; // threads may come here at the very end
    return *only;
}

// The functions that led there, as far as they have names.
QString trace() {
    void* frames[24];
    const int count = ::backtrace(frames, 24);
    QString names;
    for (int i = 3; i < count; ++i) {
        Dl_info known{};
        if (::dladdr(frames[i], &known) != 0 && known.dli_sname)
            names += QStringLiteral("\n      ") + QString::fromLocal8Bit(known.dli_sname);
    }
    return names;
}

void meet(const char* function, const char* path) {
    Drive& met = drive();
    if (!met.isMounted || !path ||
        std::strncmp(path, met.folder.constData(), std::size_t(met.folder.size())) != 0)
        return;
    if (std::this_thread::get_id() != met.window) {
        ++met.waited;
        std::unique_lock lock(met.mutex);
        met.answering.wait_for(lock, met.delay, [&met] { return !met.isLate; });
        return;
    }
    const QString call = QLatin1String(function) + u' ' + QFile::decodeName(path) + trace();
    const std::scoped_lock lock(met.mutex);
    met.noted << call;
}

template <class Function> Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

#define BARYCAGE_SEEN extern "C" __attribute__((visibility("default")))

BARYCAGE_SEEN int access(const char* path, int mode) noexcept {
    static auto* const real = next<int(const char*, int)>("access");
    meet("access", path);
    return real(path, mode);
}

BARYCAGE_SEEN int stat(const char* path, struct stat* into) noexcept {
    static auto* const real = next<int(const char*, struct stat*)>("stat");
    meet("stat", path);
    return real(path, into);
}

BARYCAGE_SEEN int stat64(const char* path, struct stat64* into) noexcept {
    static auto* const real = next<int(const char*, struct stat64*)>("stat64");
    meet("stat64", path);
    return real(path, into);
}

BARYCAGE_SEEN int lstat(const char* path, struct stat* into) noexcept {
    static auto* const real = next<int(const char*, struct stat*)>("lstat");
    meet("lstat", path);
    return real(path, into);
}

BARYCAGE_SEEN int lstat64(const char* path, struct stat64* into) noexcept {
    static auto* const real = next<int(const char*, struct stat64*)>("lstat64");
    meet("lstat64", path);
    return real(path, into);
}

BARYCAGE_SEEN int statx(int folder, const char* path, int flags, unsigned mask, struct statx* into) noexcept {
    static auto* const real = next<int(int, const char*, int, unsigned, struct statx*)>("statx");
    meet("statx", path);
    return real(folder, path, flags, mask, into);
}

BARYCAGE_SEEN ssize_t readlink(const char* path, char* into, size_t size) noexcept {
    static auto* const real = next<ssize_t(const char*, char*, size_t)>("readlink");
    meet("readlink", path);
    return real(path, into, size);
}

BARYCAGE_SEEN char* realpath(const char* path, char* into) noexcept {
    static auto* const real = next<char*(const char*, char*)>("realpath");
    meet("realpath", path);
    return real(path, into);
}

BARYCAGE_SEEN DIR* opendir(const char* path) {
    static auto* const real = next<DIR*(const char*)>("opendir");
    meet("opendir", path);
    return real(path);
}

BARYCAGE_SEEN int open(const char* path, int flags, ...) {
    static auto* const real = next<int(const char*, int, ...)>("open");
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = va_arg(rest, mode_t);
    va_end(rest);
    meet("open", path);
    return real(path, flags, mode);
}

BARYCAGE_SEEN int open64(const char* path, int flags, ...) {
    static auto* const real = next<int(const char*, int, ...)>("open64");
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = va_arg(rest, mode_t);
    va_end(rest);
    meet("open64", path);
    return real(path, flags, mode);
}

#undef BARYCAGE_SEEN

namespace support {

SlowDisk::SlowDisk(const QString& folder, std::chrono::milliseconds delay) {
    Drive& mounted = drive();
    mounted.folder = QFile::encodeName(folder);
    mounted.delay = delay;
    mounted.window = std::this_thread::get_id();
    mounted.waited = 0;
    mounted.noted.clear();
    mounted.isLate = true;
    mounted.isMounted = true;
}

SlowDisk::~SlowDisk() {
    drive().isMounted = false;
    answer();
}

void SlowDisk::answer() {
    const std::scoped_lock lock(drive().mutex);
    drive().isLate = false;
    drive().answering.notify_all();
}

QStringList SlowDisk::takeNoted() {
    const std::scoped_lock lock(drive().mutex);
    return std::exchange(drive().noted, {});
}

int SlowDisk::waited() const {
    return drive().waited;
}

} // namespace support
