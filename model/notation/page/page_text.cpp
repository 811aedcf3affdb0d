// SPDX-License-Identifier: MIT
#include "notation/page/page_text.h"

#include "notation/text/number.h"
#include "notation/text/words.h"

#include <cstddef>

namespace notation {

namespace {

// The script without the parts for modules and people: imports, exports, indents, and comments on lines of
// their own.
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
            script += std::string(text) + '\n';
        }
    }
    return script;
}

} // namespace

std::vector<std::string> pageModules(std::string_view extra) {
    std::vector<std::string> modules{"numbers.js",      "geometry.js", "dom.js",   "texts.js",
                                     "camera.js",       "drawing.js",  "table.js", "ifs_text.js",
                                     "entry_reader.js", "link.js",     "figure.js"};
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
