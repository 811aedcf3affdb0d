// SPDX-License-Identifier: MIT
#include "support/named_test.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace {

std::map<std::string, support::NamedTest::Run>& tests() {
    static std::map<std::string, support::NamedTest::Run> all;
    return all;
}

} // namespace

support::NamedTest::NamedTest(const char* file, Run run) {
    tests().emplace(std::filesystem::path(file).stem().string(), run);
}

int main(int argc, char** argv) {
    const auto named = tests().find(argc > 1 ? argv[1] : "");
    if (named != tests().end()) return named->second(argc - 1, argv + 1);
    const bool isList = argc == 2 && std::string(argv[1]) == "--list";
    if (!isList) std::fputs("The first argument is one of these names:\n", stderr);
    for (const auto& [name, run] : tests())
        std::puts(name.c_str());
    return isList ? 0 : 2;
}
