// SPDX-License-Identifier: MIT
#include "fuzz/readers.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

// Under libFuzzer, which sees what every input reaches: the reader called $BARYCAGE_READER.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::Reader* const reader = [] {
        const char* name = std::getenv("BARYCAGE_READER");
        const auto all = fuzz::readers();
        const auto found = std::find_if(all.begin(), all.end(), [name](const fuzz::Reader& one) {
            return name != nullptr && std::strcmp(name, one.name) == 0;
        });
        if (found == all.end()) {
            std::fputs("BARYCAGE_READER names no reader\n", stderr);
            std::_Exit(2);
        }
        return &*found;
    }();
    reader->read(QByteArray(reinterpret_cast<const char*>(data), qsizetype(size)));
    return 0;
}
