// SPDX-License-Identifier: MIT
#pragma once

#include <QHash>
#include <QSet>
#include <QString>

namespace document {

// Names for one entry after the other, each made legal and given once, ignoring case, in a time that does not
// grow with their number: at most 18 bytes, no blanks, parentheses, braces, ; or :.
class UniqueNames {
public:
    UniqueNames() = default;
    // Number of names, to reserve memory.
    explicit UniqueNames(qsizetype expected) { m_taken.reserve(expected); }

    void take(const QString& name); // reserves the name unchanged
    QString give(const QString& name);

private:
    QSet<QString> m_taken;         // case-folded
    QHash<QString, int> m_numbers; // next number to try after a legal, case-folded name
};

} // namespace document
