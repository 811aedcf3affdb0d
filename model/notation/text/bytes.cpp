// SPDX-License-Identifier: MIT
#include "notation/text/bytes.h"

#include <algorithm>
#include <cstdint>

namespace notation {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

std::string lowered(Bytes text) {
    std::string result(text.view());
    std::ranges::transform(result, result.begin(), lower);
    return result;
}

bool isUtf8(Bytes text) {
    for (Offset i = 0; i < text.size();) {
        const auto first = std::uint8_t(text[i]);
        const int more = first < 0x80   ? 0
                         : first < 0xc2 ? -1
                         : first < 0xe0 ? 1
                         : first < 0xf0 ? 2
                         : first < 0xf5 ? 3
                                        : -1;
        if (more < 0 || i + more >= text.size()) return false;
        for (int k = 1; k <= more; ++k)
            if ((std::uint8_t(text[i + k]) & 0xc0) != 0x80) return false;
        const auto second = more > 0 ? std::uint8_t(text[i + 1]) : std::uint8_t(0);
        if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
            (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
            return false;
        i += more + 1;
    }
    return true;
}

std::string decoded(Bytes text) {
    if (isUtf8(text)) return std::string(text.view());
    std::string result;
    for (const char c : text) {
        const auto code = std::uint8_t(c);
        if (code < 0x80) {
            result += c;
        } else {
            result += char(0xc0 | (code >> 6));
            result += char(0x80 | (code & 0x3f));
        }
    }
    return result;
}

} // namespace notation
