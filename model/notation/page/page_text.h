// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The text of a web page, put together from the files of app/web/page, which the caller has.
namespace notation {

// The modules of the page, and those of its worker, in their order. The extra one, if it is given, is for a
// gallery or a lesson.
std::vector<std::string> pageModules(std::string_view extra = {});
std::vector<std::string> workerModules();

// One script in one scope, so that no two modules may declare the same name, without what belongs to modules
// and to people. At the end stands what else is to be run.
std::string joinedScript(std::span<const std::string> modules, std::string_view end = {});

std::string plainStyle(std::string_view style); // without indents

// JSON within a page, which nothing in it can end: no “<” stands in it.
std::string embedded(std::string_view json);

// Bytes as text that ends nothing in a page, a string or an attribute: five digits of base 85 for every four
// bytes, and one more than its bytes for the rest. Shorter by 6 % than Base64, which counts in an engine.
std::string inBase85(std::string_view bytes);

// The template with its {{fields}} filled in; the inserted texts are not searched again.
std::string filled(std::string_view pattern, const std::map<std::string, std::string, std::less<>>& fields);

} // namespace notation
