// SPDX-License-Identifier: MIT
#include "process/messages.h"

#include "options/tr.h"

#include "document/text/reordered_text.h"
#include "io/file/standard_output.h"

#include <cstdio>
#include <utility>

namespace cli {

QString printable(QString text) {
    for (qsizetype i = text.size(); i-- > 0;) { // from bytes that are not UTF-8; see io::pathOf()
        const bool isLow = text[i].isLowSurrogate() && (i == 0 || !text[i - 1].isHighSurrogate());
        if (isLow)
            text.replace(i, 1,
                         QStringLiteral("\\x%1").arg(text[i].unicode() & 0xff, 2, 16, QLatin1Char('0')));
    }
    for (QChar& c : text)
        if ((c.category() == QChar::Other_Control && c != u'\n') || document::turnsText(c))
            c = QChar::ReplacementCharacter;
    return text;
}

QString printableLine(QString text) {
    return printable(std::move(text)).replace(u'\n', QChar::ReplacementCharacter);
}

namespace {

bool areWarningsHidden = false; // state of the process, like standard error itself

void line(const QString& text) {
    const QByteArray bytes = printableLine(text).toUtf8() + '\n';
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stderr);
}

document::Problem problem(document::Problem::Severity severity, const QString& sentence) {
    document::Problem result;
    result.severity = severity;
    result.message = sentence;
    return result;
}

} // namespace

void hideWarnings(bool areHidden) {
    areWarningsHidden = areHidden;
}

void report(const document::Problem& found, const QString& fileName) {
    if (areWarningsHidden && found.severity != document::Problem::Severity::Error) return;
    document::Problem placed = found;
    if (found.line == 0) placed.line = placed.column = 1; // problem of the file as a whole
    line(document::toText(placed, fileName));
}

void reportError(const QString& fileName, const QString& sentence) {
    line(document::toText(problem(document::Problem::Severity::Error, sentence), fileName));
}

void reportWarning(const QString& fileName, const QString& sentence) {
    if (areWarningsHidden) return;
    line(document::toText(problem(document::Problem::Severity::Warning, sentence), fileName));
}

void reportUsage(const QString& subcommand, const QString& sentence) {
    const QString program = QStringLiteral("barycage-cli");
    const QString command = subcommand.isEmpty() ? program : program + u' ' + subcommand;
    line(QStringLiteral("%1: error: %2").arg(command, sentence));
    line(tr("Try “%1 --help”.").arg(command));
}

bool print(const QByteArray& text) {
    return io::printBytes(text.constData(), std::size_t(text.size()));
}

} // namespace cli
