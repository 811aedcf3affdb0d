// SPDX-License-Identifier: MIT
#include "attractor/request/pixel_version.h"
#include "web/engine.h"

#include <algorithm>
#include <array>
#include <string_view>

#ifndef BARYCAGE_HASHES
#define BARYCAGE_HASHES "unknown"
#endif

namespace {

// A single text, so that it can be found in the file of a built engine.
constexpr auto versions = [] {
    std::array<char, 96> text{};
    auto at = text.begin();
    const auto append = [&at](std::string_view part) { at = std::ranges::copy(part, at).out; };
    const auto appendNumber = [&](int number) {
        int unit = 1;
        while (number / unit >= 10)
            unit *= 10;
        for (; unit > 0; unit /= 10)
            *at++ = char('0' + number / unit % 10);
    };
    append("barycage web engine: interface ");
    appendNumber(webInterface);
    append(", pixels ");
    appendNumber(attractor::pixelVersion);
    append(", hashes " BARYCAGE_HASHES);
    return text;
}();

} // namespace

const char* barycage_versions() {
    return versions.data();
}
