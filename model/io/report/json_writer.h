// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace io {

// JSON text in the order in which it is written, numbers with all their digits (QJsonDocument sorts the keys
// and cuts numbers). A number that is not finite and an absent value become null.
class JsonWriter {
public:
    enum class Layout { Lines, Inline }; // layout of the members of an object or array

    void beginObject(Layout layout = Layout::Lines) { begin('{', layout); }
    void endObject() { end('}'); }
    void beginArray(Layout layout = Layout::Lines) { begin('[', layout); }
    void endArray() { end(']'); }
    void key(const char* name);

    void value(double number);
    void value(std::optional<double> number);
    void value(int number);
    void value(bool truth);
    void value(const QString& text);
    void null();
    void token(const QByteArray& text) { raw(text); } // text of a JSON value

    template <typename Value> void member(const char* name, const Value& v) {
        key(name);
        value(v);
    }

    const QByteArray& text() const { return m_text; }

private:
    struct Level {
        Layout layout;
        bool empty = true;
    };
    void begin(char bracket, Layout layout);
    void end(char bracket);
    void separate(); // writes the comma or line end before the next value
    void newLine();
    void raw(const QByteArray& token);

    QByteArray m_text;
    std::vector<Level> m_levels;
    bool m_afterKey = false;
};

} // namespace io
