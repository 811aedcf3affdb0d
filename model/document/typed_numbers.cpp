// SPDX-License-Identifier: MIT
#include "document/typed_numbers.h"

#include <algorithm>

namespace document {

namespace {

constexpr std::size_t maxKept = 100; // values kept for one place

} // namespace

void TypedNumbers::keep(EntryId entry, const QString& place, double value, const QString& text) {
    const Key key(entry, place);
    if (text.isEmpty() && !m_texts.contains(key)) return;
    auto& texts = m_texts[key];
    std::erase_if(texts, [value](const auto& kept) { return kept.first == value; });
    if (!text.isEmpty()) texts.emplace_front(value, text);
    if (texts.size() > maxKept) texts.pop_back();
}

QString TypedNumbers::text(EntryId entry, const QString& place, double value) const {
    const auto texts = m_texts.find({entry, place});
    if (texts == m_texts.end()) return {};
    const auto kept =
        std::ranges::find_if(texts->second, [value](const auto& each) { return each.first == value; });
    return kept == texts->second.end() ? QString() : kept->second;
}

} // namespace document
