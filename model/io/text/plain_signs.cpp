// SPDX-License-Identifier: MIT
#include "io/text/plain_signs.h"

#include <QRegularExpression>

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

QString withPowersOfTen(QString text) {
    static const QRegularExpression power(QStringLiteral(
        "^([-+]?(?:\\d+[.,]?\\d*|[.,]\\d+))\\s*[×·⋅*]\\s*10\\s*(?:\\^\\s*\\(?\\s*([-+]?\\d{1,3})\\s*\\)?|"
        "([⁻⁺-]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3}))$"));
    static const QRegularExpression middleDot(QStringLiteral("^([-+]?0)·(\\d+)$"));
    static const QString raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    if (std::ranges::all_of(text, [](QChar c) { return c.unicode() < 0x80 && c != u'^'; })) return text;
    if (const auto match = middleDot.match(text); match.hasMatch())
        return match.captured(1) + u'.' + match.captured(2);
    static const QRegularExpression lowered(
        QStringLiteral("^[-+]?[\\d.,]+\\s*[×·⋅]\\s*10\\s*[-+]\\s*\\d{1,3}$"));
    if (text.contains(lowered)) return text + u'?'; // 5×10−1 is a power whose exponent was lowered, or 49
    const auto match = power.match(text);
    if (!match.hasMatch()) return text;
    QString exponent = match.captured(2) + match.captured(3);
    for (QChar& c : exponent)
        if (const qsizetype digit = raised.indexOf(c); digit >= 0)
            c = QChar(u'0' + int(digit));
        else if (isDash(c))
            c = u'-';
    return match.captured(1) + u'e' + exponent.remove(u'⁺');
}

} // namespace io
