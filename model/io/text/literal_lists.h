// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>

namespace io {

// Content of brackets in a text, whether it is JSON, a program in Python, C or JavaScript, or close to one.
struct Literal {
    enum class Kind {
        Number,
        Other, // name or expression, not a single number
        Text,  // text in quotation marks
        List,  // (…), […] or {…}
    };
    Kind kind = Kind::List;
    double number = 0;
    QString key;  // text before ":", "=" or "=>"; empty without one
    QString text; // contents of a Text; name before a List, as in array([…])
    QList<Literal> items;
    int line = 0; // of the beginning of a List, 1-based; 0: unknown
};

// The lists of a text as the items of one; text between them is left out. Comments (#, //, /*) are skipped.
// 1/3 is a number. Limits: 64 levels, 2 000 000 items. `isCut` says that there was more.
struct Literals {
    Literal root;
    bool isCut = false;
};
Literals literalsIn(const QString& text);

} // namespace io
