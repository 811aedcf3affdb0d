// SPDX-License-Identifier: MIT
#include "io/report/json_writer.h"

#include "io/text/number.h"

#include <cmath>

namespace io {

namespace {

// Quotes a text. No control character is left as it is: JSON forbids some of them, and a terminal obeys the
// others. A lone surrogate stands for a byte of a file name that is not UTF-8.
QByteArray quoted(const QString& text) {
    QString result;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        const bool isPair = c.isHighSurrogate()
                                ? i + 1 < text.size() && text[i + 1].isLowSurrogate()
                                : c.isLowSurrogate() && i > 0 && text[i - 1].isHighSurrogate();
        if (c == u'"' || c == u'\\')
            (result += u'\\') += c;
        else if (c == u'\n')
            result += QLatin1String("\\n");
        else if (c.category() == QChar::Other_Control || (c.isSurrogate() && !isPair))
            result += QStringLiteral("\\u%1").arg(c.unicode(), 4, 16, QLatin1Char('0'));
        else
            result += c;
    }
    return '"' + result.toUtf8() + '"';
}

} // namespace

void JsonWriter::newLine() {
    m_text += '\n';
    m_text += QByteArray(qsizetype(2 * m_levels.size()), ' ');
}

void JsonWriter::separate() {
    if (m_afterKey) {
        m_afterKey = false;
        return;
    }
    if (m_levels.empty()) return;
    Level& level = m_levels.back();
    if (!level.empty) m_text += ',';
    if (level.layout == Layout::Lines)
        newLine();
    else if (!level.empty)
        m_text += ' ';
    level.empty = false;
}

void JsonWriter::begin(char bracket, Layout layout) {
    separate();
    m_text += bracket;
    m_levels.push_back({layout});
}

void JsonWriter::end(char bracket) {
    const Level level = m_levels.back();
    m_levels.pop_back();
    if (level.layout == Layout::Lines && !level.empty) newLine();
    m_text += bracket;
    if (m_levels.empty()) m_text += '\n';
}

void JsonWriter::raw(const QByteArray& token) {
    separate();
    m_text += token;
}

void JsonWriter::key(const char* name) {
    raw(quoted(QString::fromUtf8(name)) + ": ");
    m_afterKey = true;
}

void JsonWriter::value(double number) {
    raw(std::isfinite(number) ? formatNumber(number) : QByteArray("null"));
}

void JsonWriter::value(std::optional<double> number) {
    number ? value(*number) : null();
}

void JsonWriter::value(int number) {
    raw(QByteArray::number(number));
}

void JsonWriter::value(bool truth) {
    raw(truth ? "true" : "false");
}

void JsonWriter::value(const QString& text) {
    raw(quoted(text));
}

void JsonWriter::null() {
    raw("null");
}

} // namespace io
