// SPDX-License-Identifier: MIT
// arc4random() for systems with glibc 2.35, where it is missing: two bundled libraries were built with 2.36.
#include <sys/random.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" void arc4random_buf(void* buffer, std::size_t size) {
    auto* at = static_cast<unsigned char*>(buffer);
    while (size > 0) {
        const ssize_t some = getrandom(at, size, 0);
        if (some < 0) std::abort(); // as in glibc
        at += some;
        size -= std::size_t(some);
    }
}

extern "C" std::uint32_t arc4random() {
    std::uint32_t number = 0;
    arc4random_buf(&number, sizeof number);
    return number;
}
