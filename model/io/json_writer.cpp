// SPDX-License-Identifier: MIT
#include "io/json_writer.h"

#include "io/number.h"

#include <cmath>

namespace io {

namespace {

QByteArray quoted(const QString& text) {
    QByteArray result = "\"";
    for (const char c : text.toUtf8()) {
        if (c == '"' || c == '\\')
            result += {'\\', c};
        else if (c == '\n')
            result += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            result += "\\u00" + QByteArray(1, c).toHex();
        else
            result += c;
    }
    return result + '"';
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
