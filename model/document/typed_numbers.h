// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QString>

#include <deque>
#include <map>
#include <utility>

namespace document {

// Numbers as the user wrote them, such as 1/2 or sqrt(3)/6, beside the doubles that the entries hold. A text
// belongs to one place of an entry and to one value there: undoing shows it again, and another value does not
// show it.
class TypedNumbers {
public:
    // An empty text: it was a plain number.
    void keep(EntryId entry, const QString& place, double value, const QString& text);
    QString text(EntryId entry, const QString& place, double value) const; // empty: none was kept
    void clear() { m_texts.clear(); }

private:
    using Key = std::pair<EntryId, QString>;
    std::map<Key, std::deque<std::pair<double, QString>>> m_texts; // newest first
};

} // namespace document
