// SPDX-License-Identifier: MIT
#include "notation/text/words.h"

#include "notation/text/number.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <utility>

namespace notation {

std::string simplified(std::string_view text) {
    std::string result;
    for (const char c : trimmed(text)) {
        const bool isSpace = c == ' ' || (c >= '\t' && c <= '\r');
        if (!isSpace)
            result += c;
        else if (result.back() != ' ')
            result += ' ';
    }
    return result;
}

std::vector<std::string> words(std::string_view text, char separator) {
    std::vector<std::string> result;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        result.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return result;
}

std::string joined(const std::vector<std::string>& words, std::size_t first) {
    std::string result;
    for (std::size_t i = first; i < words.size(); ++i)
        result += (i > first ? " " : "") + words[i];
    return result;
}

int wholeNumber(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

std::string ownLine(std::string_view key, std::string_view values) {
    return "; " + std::string(linePrefix) + ' ' + std::string(key) + ' ' + std::string(values);
}

std::vector<std::string> ownLines(std::string_view key, const std::vector<std::string>& values) {
    std::vector<std::string> lines{ownLine(key, {})};
    for (const std::string& value : values) {
        if (!lines.back().ends_with(' ')) {
            if (lines.back().size() + 1 + value.size() > maxOwnLine)
                lines.push_back(ownLine(key, {}));
            else
                lines.back() += ' ';
        }
        lines.back() += value;
    }
    return lines;
}

bool isOwnComment(std::string_view comment) {
    const std::string_view text = trimmed(comment);
    if (!text.starts_with(linePrefix)) return false;
    const std::string_view key = trimmed(text.substr(linePrefix.size()));
    return !key.starts_with("partner") && !key.starts_with("view");
}

std::pair<std::string, std::vector<std::string>> ownWords(std::string_view comment) {
    std::vector<std::string> values = words(simplified(trimmed(comment).substr(linePrefix.size())));
    std::string key = std::move(values.front());
    values.erase(values.begin());
    return {std::move(key), std::move(values)};
}

void append(std::vector<std::string>& lines, std::vector<std::string> more) {
    lines.insert(lines.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

} // namespace notation
