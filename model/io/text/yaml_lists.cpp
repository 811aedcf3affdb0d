// SPDX-License-Identifier: MIT
#include "io/text/yaml_lists.h"

#include <QStringView>

#include <algorithm>

namespace io {

namespace {

constexpr int maxYamlDepth = 64;
constexpr qsizetype maxLines = 1'000'000;

struct Line {
    qsizetype indent = 0;
    QString text; // text without comment
};

// Lines with something on them. An item on the line of its list, "- - 1", is a line of its own, further in.
QList<Line> linesOf(const QString& text) {
    QList<Line> lines;
    for (const QStringView raw : QStringView(text).split(u'\n')) {
        const qsizetype comment = raw.startsWith(u'#') ? 0 : raw.indexOf(u" #");
        const QStringView content = comment < 0 ? raw : raw.first(comment);
        qsizetype indent = 0;
        while (indent < content.size() && content[indent].isSpace())
            ++indent;
        QString rest = content.sliced(indent).trimmed().toString();
        if (rest.isEmpty() || rest == u"---" || lines.size() >= maxLines) continue;
        lines << Line{indent, rest};
    }
    return lines;
}

bool isItem(const QString& text) {
    return text == u"-" || text.startsWith(u"- ");
}

// End of the key of "key: value"; -1 without one.
qsizetype endOfKey(const QString& text) {
    if (text.startsWith(u'[') || text.startsWith(u'{')) return -1;
    for (qsizetype i = 1; i < text.size(); ++i)
        if (text[i] == u':' && (i + 1 == text.size() || text[i + 1].isSpace())) return i;
    return -1;
}

class Reader {
public:
    explicit Reader(QList<Line> lines) : m_lines(std::move(lines)) {}

    Literals read() && {
        Literals literals;
        while (m_at < m_lines.size() && !m_isCut) {
            const qsizetype before = m_at;
            literals.root.items += block(m_lines[m_at].indent, 0).items;
            if (m_at == before) ++m_at;
        }
        literals.isCut = m_isCut;
        return literals;
    }

private:
    // Reads items or keys of equal indentation.
    Literal block(qsizetype indent, int depth) {
        Literal list;
        if (depth > maxYamlDepth) m_isCut = true;
        while (!m_isCut && m_at < m_lines.size() && m_lines[m_at].indent == indent) {
            Line& line = m_lines[m_at];
            if (isItem(line.text)) {
                list.items << item(line, depth);
            } else if (const qsizetype colon = endOfKey(line.text); colon > 0) {
                QString key = line.text.first(colon).trimmed();
                key.remove(u'"').remove(u'\'');
                const QString rest = line.text.sliced(colon + 1).trimmed();
                ++m_at;
                Literal value = rest.isEmpty() ? below(indent, depth) : scalar(rest);
                value.key = key;
                list.items << value;
            } else {
                ++m_at;
                list.items << scalar(line.text);
            }
        }
        return list;
    }

    // Reads the item behind "- ", which is indented like its text.
    Literal item(Line& line, int depth) {
        QString rest = line.text.sliced(1);
        qsizetype blanks = 0;
        while (blanks < rest.size() && rest[blanks].isSpace())
            ++blanks;
        rest = rest.sliced(blanks);
        if (rest.isEmpty()) {
            const qsizetype indent = line.indent;
            ++m_at;
            return below(indent, depth);
        }
        if (!isItem(rest) && endOfKey(rest) < 0) {
            ++m_at;
            return scalar(rest);
        }
        line.indent += 1 + blanks;
        line.text = rest;
        return block(line.indent, depth + 1);
    }

    // Reads the list of a key, which may be indented like the key itself.
    Literal below(qsizetype indent, int depth) {
        if (m_at >= m_lines.size()) return {};
        const Line& next = m_lines[m_at];
        if (next.indent > indent || (next.indent == indent && isItem(next.text)))
            return next.indent > indent ? block(next.indent, depth + 1) : items(indent, depth + 1);
        return {};
    }

    Literal items(qsizetype indent, int depth) {
        Literal list;
        while (!m_isCut && m_at < m_lines.size() && m_lines[m_at].indent == indent &&
               isItem(m_lines[m_at].text))
            list.items << item(m_lines[m_at], depth);
        return list;
    }

    // Reads a scalar, whose brackets may continue over further lines.
    Literal scalar(QString text) {
        const auto depthOf = [](const QString& s) {
            return s.count(u'[') + s.count(u'{') - s.count(u']') - s.count(u'}');
        };
        for (auto open = depthOf(text); open > 0 && m_at < m_lines.size(); ++m_at) {
            text += u' ' + m_lines[m_at].text;
            open += depthOf(m_lines[m_at].text);
        }
        const Literals inner = literalsIn(u'[' + text + u']');
        m_isCut = m_isCut || inner.isCut;
        if (inner.root.items.isEmpty() || inner.root.items[0].items.isEmpty())
            return {Literal::Kind::Other, 0, {}, {}, {}};
        const Literal& list = inner.root.items[0];
        return list.items.size() == 1 ? list.items[0] : Literal{Literal::Kind::Text, 0, {}, text, {}};
    }

    QList<Line> m_lines;
    qsizetype m_at = 0;
    bool m_isCut = false;
};

} // namespace

Literals yamlLiterals(const QString& text) {
    QList<Line> lines = linesOf(text);
    const bool isYaml = std::any_of(lines.begin(), lines.end(), [](const Line& line) {
        return isItem(line.text) || endOfKey(line.text) > 0;
    });
    return isYaml ? Reader(std::move(lines)).read() : Literals();
}

} // namespace io
