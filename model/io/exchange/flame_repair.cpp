// SPDX-License-Identifier: MIT
#include "io/exchange/flame_repair.h"
#include "document/text/text.h"

#include <QRegularExpression>
#include <QSet>
#include <QXmlStreamReader>

#include <algorithm>

namespace io {

namespace {

using document::Problem;

constexpr qsizetype maxRemarks = 20;

struct Flaw {
    qint64 line = 0;
    QString reason;
};

std::optional<Flaw> flawOf(const QString& xml) {
    QXmlStreamReader reader(xml);
    reader.setEntityExpansionLimit(0);
    while (!reader.atEnd())
        reader.readNext();
    if (!reader.hasError()) return std::nullopt;
    QString reason = reader.errorString();
    if (reason.endsWith(u'.')) reason.chop(1);
    return Flaw{reader.lineNumber(), reason};
}

// Unwraps a single layer: its content belongs to the flame. Several layers stay.
QString withoutSingleLayers(QString text) {
    if (!text.contains(QStringLiteral("<jwf-flame"))) return text;
    static const QRegularExpression flame(QStringLiteral("<jwf-flame\\b.*?</jwf-flame\\s*>"),
                                          QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression layer(QStringLiteral("</?layer\\b[^<>]*>"));
    QString result;
    qsizetype before = 0;
    for (auto found = flame.globalMatch(text); found.hasNext();) {
        const auto match = found.next();
        QString one = match.captured();
        if (one.count(QStringLiteral("<layer")) == 1)
            for (auto tag = layer.match(one); tag.hasMatch(); tag = layer.match(one))
                one.replace(tag.capturedStart(), tag.capturedLength(),
                            QString(tag.capturedView().count(u'\n'), u'\n'));
        result += text.sliced(before, match.capturedStart() - before) + one;
        before = match.capturedEnd();
    }
    result += text.sliced(before);
    return result.replace(QStringLiteral("<jwf-flame"), QStringLiteral("<flame"))
        .replace(QStringLiteral("</jwf-flame"), QStringLiteral("</flame"));
}

class Mender {
public:
    explicit Mender(const QString& text) : m_text(text) {}

    RepairedFlames mend() && {
        RepairedFlames result;
        result.text = QStringLiteral("<flames>");
        static const QRegularExpression start(QStringLiteral("<flame(?=[\\s>])"));
        auto found = start.globalMatch(m_text);
        qsizetype begin = found.hasNext() ? found.next().capturedStart() : m_text.size();
        keepLines(0, begin, result.text);
        while (begin < m_text.size()) {
            const qsizetype next = found.hasNext() ? found.next().capturedStart() : m_text.size();
            const qsizetype close = m_text.indexOf(QStringLiteral("</flame>"), begin);
            const qsizetype end = close < 0 || close > next ? next : close + 8;
            const int line = m_line;
            const QString flame = mended(m_text.sliced(begin, end - begin));
            if (const auto flaw = flawOf(flame)) {
                result.problems << Problem{
                    Problem::Severity::Error,
                    {},
                    line + int(flaw->line) - 1,
                    1,
                    Text::tr("The XML cannot be read beyond this point: %1.").arg(flaw->reason)};
                result.text += QString(flame.count(u'\n'), u'\n');
            } else {
                result.text += flame;
            }
            m_line += int(flame.count(u'\n'));
            keepLines(end, next, result.text);
            begin = next;
        }
        result.text += QStringLiteral("</flames>");
        result.problems = m_problems + result.problems;
        return result;
    }

private:
    void keepLines(qsizetype begin, qsizetype end, QString& text) {
        const qsizetype lines = QStringView(m_text).sliced(begin, end - begin).count(u'\n');
        text += QString(lines, u'\n');
        m_line += int(lines);
    }

    void remark(const QString& sentence, qsizetype position, const QString& flame) {
        if (m_problems.size() < maxRemarks)
            m_problems << Problem{Problem::Severity::Warning,
                                  {},
                                  m_line + int(QStringView(flame).first(position).count(u'\n')),
                                  1,
                                  sentence};
    }

    // Flame with repaired tags.
    QString mended(const QString& flame) {
        static const QRegularExpression tag(QStringLiteral(
            "<([A-Za-z][\\w:.-]*)((?:\\s*[A-Za-z_][\\w:.-]*\\s*=\\s*(?:\"[^\"]*\"|'[^']*'))*)(\\s*/?>)"));
        QString result;
        qsizetype before = 0;
        for (auto found = tag.globalMatch(flame); found.hasNext();) {
            const auto match = found.next();
            result += flame.sliced(before, match.capturedStart() - before) + u'<' + match.captured(1) +
                      attributes(match.captured(2), match.capturedStart(2), flame) + match.captured(3);
            before = match.capturedEnd();
        }
        return result + flame.sliced(before);
    }

    QString attributes(const QString& text, qsizetype position, const QString& flame) {
        static const QRegularExpression one(
            QStringLiteral("(\\s*)([A-Za-z_][\\w:.-]*)(\\s*=\\s*)(\"[^\"]*\"|'[^']*')"));
        static const QRegularExpression ampersand(
            QStringLiteral("&(?!(?:amp|lt|gt|quot|apos|#\\d+|#x[0-9a-fA-F]+);)"));
        QString result;
        QSet<QString> names;
        for (auto found = one.globalMatch(text); found.hasNext();) {
            const auto match = found.next();
            const qsizetype at = position + match.capturedStart(2);
            const QString name = match.captured(2);
            const QString blank = match.captured(1);
            if (names.contains(name)) {
                remark(Text::tr("The attribute “%1” occurs twice; the first one is read.").arg(name), at,
                       flame);
                result += QString(match.captured().count(u'\n'), u'\n');
                continue;
            }
            names.insert(name);
            if (blank.isEmpty())
                remark(
                    Text::tr("A blank is missing before the attribute “%1”; it is read as if there were one.")
                        .arg(name),
                    at, flame);
            QString value = match.captured(4);
            if (value.contains(ampersand)) {
                remark(Text::tr("The attribute “%1” contains “%2”, which must be “%3” in XML; it is read "
                                "as it stands.")
                           .arg(name, QStringLiteral("&"), QStringLiteral("&amp;")),
                       at, flame);
                value.replace(ampersand, QStringLiteral("&amp;"));
            }
            value.replace(u'<', QStringLiteral("&lt;"));
            result += (blank.isEmpty() ? QStringLiteral(" ") : blank) + name + match.captured(3) + value;
        }
        return result;
    }

    const QString& m_text;
    int m_line = 1;
    document::Problems m_problems;
};

} // namespace

RepairedFlames repairedFlames(const QString& source) {
    // Quotation marks as a word processor or a page sets them.
    static const QRegularExpression quoted(QStringLiteral("=\\s*[“”„″]([^“”„″\"<>]*)[“”″]"));
    QString text = withoutSingleLayers(source);
    if (text.contains(quoted) && flawOf(text)) text.replace(quoted, QStringLiteral("=\"\\1\""));
    if (text.contains(QStringLiteral("<!DOCTYPE"), Qt::CaseInsensitive) || !flawOf(text) ||
        !text.contains(QStringLiteral("<flame")))
        return {text, {}};
    return Mender(text).mend();
}

} // namespace io
