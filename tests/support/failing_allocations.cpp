// SPDX-License-Identifier: MIT
// A library to be loaded before all others (LD_PRELOAD): allocation number BARYCAGE_FAILING of the program,
// counted from 1, gets no memory, with `+` behind the number all from that one on. With `@` before it they
// are counted from the moment when the program calls barycageBeginToFail(). At the end, the number of
// allocations is written to the file that BARYCAGE_ALLOCATIONS names.
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <unistd.h>

// The allocator of the C library, under names that nothing replaces.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_calloc(std::size_t count, std::size_t size);
extern "C" void* __libc_realloc(void* old, std::size_t size);
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t size);

namespace {

std::atomic<long> made = 0;
long which = 0; // until the environment is there, none
bool isLasting = false;

bool isRefused() {
    const long number = made.fetch_add(1, std::memory_order_relaxed) + 1;
    const bool refused = which > 0 && (number == which || (isLasting && number > which));
    if (refused) errno = ENOMEM;
    return refused;
}

void begin(const char* failing) {
    char* end = nullptr;
    which = std::strtol(failing, &end, 10);
    isLasting = *end == '+';
    made = 0;
}

[[gnu::constructor(101)]] void prepare() { // before other constructors
    const char* const failing = std::getenv("BARYCAGE_FAILING");
    if (failing && *failing != '@') begin(failing);
}

[[gnu::destructor]] void tell() {
    const char* const name = std::getenv("BARYCAGE_ALLOCATIONS");
    std::FILE* const file = name ? std::fopen(name, "we") : nullptr;
    if (!file) return;
    std::fprintf(file, "%ld\n", made.load());
    std::fclose(file);
}

} // namespace

#define BARYCAGE_SEEN extern "C" __attribute__((visibility("default")))

BARYCAGE_SEEN void barycageBeginToFail() {
    const char* const failing = std::getenv("BARYCAGE_FAILING");
    if (failing && *failing == '@') begin(failing + 1);
}

BARYCAGE_SEEN void* malloc(std::size_t size) noexcept {
    return isRefused() ? nullptr : __libc_malloc(size);
}

BARYCAGE_SEEN void* calloc(std::size_t count, std::size_t size) noexcept {
    return isRefused() ? nullptr : __libc_calloc(count, size);
}

BARYCAGE_SEEN void* realloc(void* old, std::size_t size) noexcept {
    return isRefused() ? nullptr : __libc_realloc(old, size);
}

BARYCAGE_SEEN void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return isRefused() ? nullptr : __libc_memalign(alignment, size);
}

BARYCAGE_SEEN void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return isRefused() ? nullptr : __libc_memalign(alignment, size);
}

BARYCAGE_SEEN int posix_memalign(void** into, std::size_t alignment, std::size_t size) noexcept {
    if (isRefused()) return ENOMEM;
    void* const room = __libc_memalign(alignment, size);
    if (!room) return ENOMEM;
    *into = room;
    return 0;
}
