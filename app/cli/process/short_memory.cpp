// SPDX-License-Identifier: MIT
// The end of the program where even a little memory is missing. Libraries do not survive that: Qt copies its
// lists to nowhere, GLib and others abort. So a small request that fails ends the program with a sentence and
// a status, wherever it comes from: docs/decisions/0052-small-requests-for-memory.md. Large ones fail as
// usual, with std::bad_alloc or a null pointer.
#include "process/short_memory.h"

#include "io/file/replacement_file.h"
#include "options/exit_status.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>
#include <unistd.h>

#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define BARYCAGE_OTHER_ALLOCATOR
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BARYCAGE_OTHER_ALLOCATOR
#endif
#if defined(__GLIBC__) && !defined(BARYCAGE_OTHER_ALLOCATOR)
#define BARYCAGE_ENDS_WITHOUT_MEMORY
#endif

#ifdef BARYCAGE_ENDS_WITHOUT_MEMORY
#include <dlfcn.h>

// The allocator of the C library under names that nothing replaces.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_calloc(std::size_t count, std::size_t size);
extern "C" void* __libc_realloc(void* old, std::size_t size);
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t size);
#endif

namespace cli {

int memoryIsShort() noexcept {
    io::removeUnfinished();
    constexpr char sentence[] = "barycage-cli: error: There is not enough memory for this.\n";
    if (::write(STDERR_FILENO, sentence, sizeof sentence - 1) < 0) {
        // No memory even for the message.
    }
    return int(ExitStatus::CannotReadOrWrite);
}

namespace {

// Whatever cannot be caught: before main(), in the destructor of a library, or in a thread.
[[noreturn]] void endOfUncaught() {
    if (const auto thrown = std::current_exception()) {
        try {
            std::rethrow_exception(thrown);
        } catch (const std::bad_alloc&) {
            std::_Exit(memoryIsShort());
        } catch (const std::system_error&) { // no thread available
            std::_Exit(memoryIsShort());
        } catch (...) {
            std::abort();
        }
    }
    std::abort();
}

[[gnu::constructor(101)]] void prepareForLittleMemory() { // priority before other constructors
    std::set_terminate(endOfUncaught);
}

#ifdef BARYCAGE_ENDS_WITHOUT_MEMORY

constexpr std::size_t small = std::size_t(1) << 20; // bytes

void* orEnd(void* made, std::size_t size) noexcept {
    if (!made && size > 0 && size < small) std::_Exit(memoryIsShort());
    return made;
}

// The allocator of the next library that has one of this name, which may count or check requests; without
// any, and where dlsym() itself needs memory, that of the C library.
template <class Function> class NextAllocator {
public:
    constexpr NextAllocator(const char* name, Function* own) : m_name(name), m_own(own) {}

    Function* get() noexcept {
        static thread_local bool isAsking = false;
        Function* found = m_found.load(std::memory_order_relaxed);
        if (found || isAsking) return found ? found : m_own;
        isAsking = true;
        found = reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, m_name));
        isAsking = false;
        m_found.store(found ? found : m_own, std::memory_order_relaxed);
        return found ? found : m_own;
    }

private:
    const char* m_name;
    Function* m_own;
    std::atomic<Function*> m_found = nullptr;
};

constinit NextAllocator<void*(std::size_t)> nextMalloc("malloc", &__libc_malloc);
constinit NextAllocator<void*(std::size_t, std::size_t)> nextCalloc("calloc", &__libc_calloc);
constinit NextAllocator<void*(void*, std::size_t)> nextRealloc("realloc", &__libc_realloc);
constinit NextAllocator<void*(std::size_t, std::size_t)> nextAligned("aligned_alloc", &__libc_memalign);

#endif

} // namespace

} // namespace cli

#ifdef BARYCAGE_ENDS_WITHOUT_MEMORY

#define BARYCAGE_SEEN extern "C" __attribute__((visibility("default")))

BARYCAGE_SEEN void* malloc(std::size_t size) noexcept {
    return cli::orEnd(cli::nextMalloc.get()(size), size);
}

BARYCAGE_SEEN void* calloc(std::size_t count, std::size_t size) noexcept {
    std::size_t bytes = 0;
    const bool isPossible = !__builtin_mul_overflow(count, size, &bytes);
    return cli::orEnd(cli::nextCalloc.get()(count, size), isPossible ? bytes : cli::small);
}

BARYCAGE_SEEN void* realloc(void* old, std::size_t size) noexcept {
    return cli::orEnd(cli::nextRealloc.get()(old, size), size);
}

BARYCAGE_SEEN void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return cli::orEnd(cli::nextAligned.get()(alignment, size), size);
}

BARYCAGE_SEEN void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return aligned_alloc(alignment, size);
}

BARYCAGE_SEEN int posix_memalign(void** into, std::size_t alignment, std::size_t size) noexcept {
    void* const made = aligned_alloc(alignment, size);
    if (!made) return ENOMEM;
    *into = made;
    return 0;
}

#endif
