// SPDX-License-Identifier: MIT
#include "notation/page/page_text.h"

#include "notation/text/number.h"
#include "notation/text/words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace notation {

namespace {

// The text without comments of types within it.
std::string withoutTypes(std::string_view text) {
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = text.find("/** @type ", at);
        const std::size_t end = begin == std::string_view::npos ? begin : text.find("*/", begin);
        if (end == std::string_view::npos) return plain.append(text.substr(at));
        plain += text.substr(at, begin - at);
        at = text.find_first_not_of(' ', end + 2);
    }
    return plain;
}

// The script without the parts for modules and people: imports, exports, indents, and comments on lines of
// their own or of types.
std::string plainScript(std::string_view module) {
    std::string script;
    bool inImport = false, inComment = false;
    for (const std::string& line : words(module, '\n')) {
        std::string_view text = trimmed(line);
        inComment = inComment || text.starts_with("/**");
        inImport = inImport || line.starts_with("import ");
        if (inComment) {
            inComment = !text.ends_with("*/");
        } else if (inImport) {
            inImport = !text.ends_with("\";");
        } else if (!text.empty() && !text.starts_with("//")) {
            if (line.starts_with("export ")) text.remove_prefix(7);
            script += withoutTypes(text) + '\n';
        }
    }
    return script;
}

} // namespace

std::vector<std::string> pageModules(std::string_view extra) {
    std::vector<std::string> modules{"numbers.js",      "geometry.js", "dom.js",    "texts.js",
                                     "camera.js",       "drawing.js",  "table.js",  "ifs_text.js",
                                     "entry_reader.js", "link.js",     "player.js", "figure.js"};
    if (!extra.empty()) modules.emplace_back(extra);
    modules.emplace_back("main.js");
    return modules;
}

std::vector<std::string> workerModules() {
    return {"engine.js", "worker.js"};
}

std::string joinedScript(std::span<const std::string> modules, std::string_view end) {
    std::string script = "\"use strict\";\n(() => {\n";
    for (const std::string& module : modules)
        script += plainScript(module);
    return script.append(end) + "})();\n";
}

std::string plainStyle(std::string_view style) {
    std::string plain;
    for (const std::string& line : words(style, '\n'))
        plain += std::string(trimmed(line)) + '\n';
    return plain;
}

std::string embedded(std::string_view json) {
    std::string text;
    for (const char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

std::string inBase85(std::string_view bytes) {
    // Those of ASCII without what means something in HTML, JavaScript or the fields of a template.
    constexpr std::string_view digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                        "!#$%()*+,-./:;=?@[]^_|~";
    static_assert(digits.size() == 85);
    std::string text;
    text.reserve(bytes.size() / 4 * 5 + 5);
    for (std::size_t at = 0; at < bytes.size(); at += 4) {
        std::uint32_t number = 0;
        for (std::size_t i = at; i < at + 4; ++i)
            number = number << 8 | (i < bytes.size() ? std::uint8_t(bytes[i]) : 0U);
        std::array<char, 5> group{};
        for (auto digit = group.rbegin(); digit != group.rend(); ++digit, number /= 85)
            *digit = digits[number % 85];
        text.append(group.data(), std::min<std::size_t>(5, bytes.size() - at + 1));
    }
    return text;
}

std::string filled(std::string_view pattern, const std::map<std::string, std::string, std::less<>>& fields) {
    std::string text;
    for (std::size_t at = 0; at < pattern.size();) {
        const std::size_t begin = pattern.find("{{", at);
        const std::size_t end = begin == std::string_view::npos ? begin : pattern.find("}}", begin);
        if (end == std::string_view::npos) return text.append(pattern.substr(at));
        text.append(pattern.substr(at, begin - at));
        if (const auto field = fields.find(pattern.substr(begin + 2, end - begin - 2)); field != fields.end())
            text += field->second;
        at = end + 2;
    }
    return text;
}

} // namespace notation
