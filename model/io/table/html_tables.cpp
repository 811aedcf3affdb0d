// SPDX-License-Identifier: MIT
#include "io/table/html_tables.h"

#include "io/text/latex_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <utility>

namespace io {

namespace {

struct Entity {
    const char* name;
    char16_t sign;
};
constexpr std::array entities{
    Entity{"minus", u'−'},   Entity{"ndash", u'–'},  Entity{"mdash", u'—'},  Entity{"nbsp", u' '},
    Entity{"thinsp", u' '},  Entity{"ensp", u' '},   Entity{"emsp", u' '},   Entity{"amp", u'&'},
    Entity{"lt", u'<'},      Entity{"gt", u'>'},     Entity{"quot", u'"'},   Entity{"apos", u'\''},
    Entity{"frac12", u'½'},  Entity{"half", u'½'},   Entity{"frac14", u'¼'}, Entity{"frac34", u'¾'},
    Entity{"frac13", u'⅓'},  Entity{"frac23", u'⅔'}, Entity{"frac15", u'⅕'}, Entity{"frac18", u'⅛'},
    Entity{"radic", u'√'},   Entity{"pi", u'π'},     Entity{"theta", u'θ'},  Entity{"phi", u'φ'},
    Entity{"deg", u'°'},     Entity{"times", u'×'},  Entity{"middot", u'·'}, Entity{"sdot", u'·'},
    Entity{"frasl", u'⁄'},   Entity{"percnt", u'%'}, Entity{"hyphen", u'-'}, Entity{"fnof", u'ƒ'},
    Entity{"shy", u'\u00ad'}};

// The sign of "&name;" at the beginning, and how long it is.
std::pair<QString, qsizetype> entityAt(QStringView text) {
    constexpr qsizetype longest = 12;
    const qsizetype end = text.first(std::min(text.size(), longest)).indexOf(u';');
    if (end < 2) return {QStringLiteral("&"), 1};
    const QStringView name = text.sliced(1, end - 1);
    if (name[0] == u'#') {
        const bool isHexadecimal = name.size() > 1 && name[1].toLower() == u'x';
        bool isGood = false;
        const uint code = name.sliced(isHexadecimal ? 2 : 1).toUInt(&isGood, isHexadecimal ? 16 : 10);
        if (isGood && code > 0 && code <= 0x10ffff && !QChar::isSurrogate(code))
            return {QString::fromUcs4(reinterpret_cast<const char32_t*>(&code), 1), end + 1};
        return {QStringLiteral("&"), 1};
    }
    const auto* const known =
        std::ranges::find_if(entities, [&](const Entity& one) { return name == QLatin1String(one.name); });
    return known == entities.end() ? std::pair(QStringLiteral("&"), qsizetype(1))
                                   : std::pair(QString(QChar(known->sign)), end + 1);
}

struct Tag {
    QString name; // lower case; "/td" for an end tag
    QStringView attributes;
    qsizetype end = 0; // end of the tag
};

// The tag at the beginning of the text; an empty name where there is none.
Tag tagAt(QStringView text) {
    constexpr qsizetype longest = 4096;
    qsizetype name = 1;
    while (name < text.size() && (text[name].isLetterOrNumber() || (name == 1 && text[name] == u'/')))
        ++name;
    if (name < 2) return {{}, {}, 1};
    const qsizetype end = text.first(std::min(text.size(), longest)).indexOf(u'>', name);
    if (end < 0) return {{}, {}, 1};
    return {text.sliced(1, name - 1).toString().toLower(), text.sliced(name, end - name), end + 1};
}

int columnsOf(const Tag& tag) {
    constexpr int most = 64;
    const qsizetype at = tag.attributes.indexOf(u"colspan", 0, Qt::CaseInsensitive);
    if (at < 0) return 1;
    QString digits;
    for (const QChar c : tag.attributes.sliced(at + 7))
        if (c.isDigit())
            digits += c;
        else if (!digits.isEmpty())
            break;
    return std::clamp(digits.left(4).toInt(), 1, most);
}

class Reader {
public:
    explicit Reader(QStringView text) : m_text(text) {}

    QList<MarkupTable> read() && {
        while (m_at < m_text.size()) {
            const QStringView rest = m_text.sliced(m_at);
            if (rest[0] != u'<') {
                if (rest[0] == u'\n') ++m_line;
                ++m_at;
                continue;
            }
            const Tag tag = rest.startsWith(u"<!--") ? commentAt(rest) : tagAt(rest);
            take(tag);
            m_line += int(rest.first(tag.end).count(u'\n'));
            m_at += tag.end;
        }
        endRow();
        m_tables.removeIf([](const MarkupTable& table) { return table.rows.isEmpty(); });
        return std::move(m_tables);
    }

private:
    static Tag commentAt(QStringView rest) {
        const qsizetype end = rest.indexOf(u"-->");
        return {{}, {}, end < 0 ? rest.size() : end + 3};
    }

    void take(const Tag& tag) {
        if (tag.name == u"table") {
            endRow();
            m_tables << MarkupTable{Markup::Html, {}};
        } else if (tag.name == u"tr") {
            endRow();
            m_row.line = m_line;
        } else if (tag.name == u"td" || tag.name == u"th") {
            endCell();
            m_cell = m_at + tag.end;
            m_columns = columnsOf(tag);
        } else if (tag.name == u"/td" || tag.name == u"/th") {
            endCell();
        } else if (tag.name == u"/tr" || tag.name == u"/table") {
            endRow();
        }
    }

    void endCell() {
        if (m_cell < 0) return;
        m_row.cells << textOfHtml(m_text.sliced(m_cell, m_at - m_cell));
        for (int i = 1; i < m_columns; ++i)
            m_row.cells << QString();
        m_cell = -1;
    }

    void endRow() {
        endCell();
        if (!m_row.cells.isEmpty()) {
            if (m_tables.isEmpty()) m_tables << MarkupTable{Markup::Html, {}};
            m_tables.last().rows << m_row;
        }
        m_row = {{}, m_line};
    }

    QStringView m_text;
    qsizetype m_at = 0;
    int m_line = 1;
    qsizetype m_cell = -1; // beginning of the cell's text; −1: none
    int m_columns = 1;
    MarkupRow m_row;
    QList<MarkupTable> m_tables;
};

} // namespace

QList<MarkupTable> htmlTables(const QString& text) {
    if (!text.contains(QStringLiteral("<td"), Qt::CaseInsensitive)) return {};
    return Reader(text).read();
}

QString textOfHtml(QStringView text) {
    // Source of a formula in an annotation; without it, the letters are read one by one.
    const qsizetype note = text.indexOf(u"<annotation");
    if (const qsizetype begin = note < 0 ? -1 : text.indexOf(u'>', note); begin >= 0) {
        const qsizetype end = text.indexOf(u"</annotation", begin);
        return plainLatex(text.sliced(begin + 1, (end < 0 ? text.size() : end) - begin - 1)).simplified();
    }
    QString result;
    for (qsizetype i = 0; i < text.size();) {
        if (text[i] == u'<') {
            const Tag tag = tagAt(text.sliced(i));
            if (tag.name.isEmpty()) result += u'<';
            const bool isBehindDigit = !result.isEmpty() && result.back().isDigit();
            if (isBehindDigit && (tag.name == u"sup" || tag.name == u"sub")) // 10⁻¹, and no 101
                result += tag.name == u"sup" ? u'^' : u'_';
            if (tag.name == u"br" || tag.name == u"p" || tag.name == u"div") result += u' ';
            i += tag.end;
        } else if (text[i] == u'&') {
            const auto [sign, length] = entityAt(text.sliced(i));
            result += sign;
            i += length;
        } else {
            result += text[i++];
        }
    }
    if (result.contains(QStringLiteral("\\(")) || result.contains(u'$')) result = plainLatex(result);
    return result.simplified();
}

QString preformattedText(const QString& page) {
    static const QRegularExpression block(QStringLiteral("<(pre|code|textarea)\\b[^>]*>(.*?)</\\1\\s*>"),
                                          QRegularExpression::DotMatchesEverythingOption |
                                              QRegularExpression::CaseInsensitiveOption);
    QString text;
    for (auto found = block.globalMatch(page); found.hasNext();) {
        for (const QStringView line : found.next().capturedView(2).split(u'\n')) {
            QString plain;
            for (qsizetype i = 0; i < line.size();) {
                const Tag tag = line[i] == u'<' ? tagAt(line.sliced(i)) : Tag();
                const auto [sign, length] = line[i] == u'&'       ? entityAt(line.sliced(i))
                                            : !tag.name.isEmpty() ? std::pair(QString(), tag.end)
                                                                  : std::pair(QString(line[i]), qsizetype(1));
                plain += sign;
                i += length;
            }
            text += plain + u'\n';
        }
    }
    return text;
}

} // namespace io
