// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace notation {

using Offset = long long; // same width as in Qt's views

// A text as bytes that others own, with signed offsets. What has data() and size(), such as Qt's views,
// becomes one by itself.
class Bytes {
public:
    Bytes() = default;
    template <class Text>
    requires requires(const Text& text) { std::string_view(text.data(), std::size_t(text.size())); }
    Bytes(const Text& text) : m_view(text.data(), std::size_t(text.size())) {}
    Bytes(const char* text) : m_view(text) {}

    std::string_view view() const { return m_view; }
    const char* data() const { return m_view.data(); }
    Offset size() const { return Offset(m_view.size()); }
    bool isEmpty() const { return m_view.empty(); }
    char operator[](Offset i) const { return m_view[std::size_t(i)]; }
    auto begin() const { return m_view.begin(); }
    auto end() const { return m_view.end(); }

    Bytes sliced(Offset begin) const { return m_view.substr(std::size_t(begin)); }
    Bytes sliced(Offset begin, Offset size) const {
        return m_view.substr(std::size_t(begin), std::size_t(size));
    }
    Bytes first(Offset size) const { return sliced(0, size); }

    // Of the first at or after `begin`, or the last; −1 where there is none.
    Offset indexOf(char c, Offset begin = 0) const { return Offset(m_view.find(c, std::size_t(begin))); }
    Offset lastIndexOf(char c) const { return Offset(m_view.rfind(c)); }
    bool contains(char c) const { return m_view.find(c) != std::string_view::npos; }
    bool startsWith(std::string_view text) const { return m_view.starts_with(text); }
    friend bool operator==(Bytes a, Bytes b) { return a.m_view == b.m_view; }

private:
    std::string_view m_view;
};

// ASCII letters made small.
char lower(char c);
std::string lowered(Bytes text);

// Whether all of it is UTF-8, without surrogates and overlong sequences.
bool isUtf8(Bytes text);
// UTF-8 where it is valid, else from Latin-1: always valid UTF-8.
std::string decoded(Bytes text);

} // namespace notation
