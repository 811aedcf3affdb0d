// SPDX-License-Identifier: MIT
#include "io/text/plain_signs.h"

#include <algorithm>

namespace io {

namespace {

bool isWithoutWidth(QChar c) {
    const char16_t code = c.unicode();
    return (code >= 0x200b && code <= 0x200f) || (code >= 0x202a && code <= 0x202e) ||
           (code >= 0x2060 && code <= 0x2069) || code == 0xfeff;
}

QChar plain(QChar c) {
    const char16_t code = c.unicode();
    if (isDash(c)) return u'-';
    if (code >= 0xff01 && code <= 0xff5e) return QChar(code - 0xfee0); // full-width forms
    if (code == 0x2044 || code == 0x2215) return u'/';
    if (code == 0xfe62) return u'+';
    return c;
}

} // namespace

bool isDash(QChar c) {
    const char16_t code = c.unicode();
    return code == u'-' || (code >= 0x2010 && code <= 0x2015) || code == 0x2212 || code == 0x207b ||
           code == 0xfe58 || code == 0xfe63 || code == 0xff0d || code == 0x00ad || code == 0x2796;
}

bool isSettingBlank(QChar c) {
    const char16_t code = c.unicode();
    return (code >= 0x2004 && code <= 0x200a) || code == 0x202f || code == 0x205f;
}

QString plainSigns(QString text) {
    if (std::ranges::all_of(text, [](QChar c) { return c.unicode() < 0x80; })) return text;
    QString result;
    result.reserve(text.size());
    for (const QChar c : text) {
        if (isWithoutWidth(c)) continue;
        const bool isAfterSign = !result.isEmpty() && (result.back() == u'-' || result.back() == u'+');
        if (!isAfterSign || !isSettingBlank(c)) result += plain(c);
    }
    return result;
}

} // namespace io
