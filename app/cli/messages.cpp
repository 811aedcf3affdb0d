// SPDX-License-Identifier: MIT
#include "messages.h"

#include <QCoreApplication>

#include <cstdio>

namespace cli {

QString printable(QString text) {
    for (QChar& c : text)
        if (c.category() == QChar::Other_Control && c != u'\n') c = QChar::ReplacementCharacter;
    return text;
}

namespace {

void line(const QString& text) {
    const QByteArray bytes = printable(text).replace(u'\n', QChar::ReplacementCharacter).toUtf8() + '\n';
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stderr);
}

document::Problem problem(document::Problem::Severity severity, const QString& sentence) {
    document::Problem result;
    result.severity = severity;
    result.message = sentence;
    return result;
}

} // namespace

void report(const document::Problem& found, const QString& fileName) {
    document::Problem placed = found;
    if (found.line == 0) placed.line = placed.column = 1; // the file as a whole
    line(document::toText(placed, fileName));
}

void reportError(const QString& fileName, const QString& sentence) {
    line(document::toText(problem(document::Problem::Severity::Error, sentence), fileName));
}

void reportWarning(const QString& fileName, const QString& sentence) {
    line(document::toText(problem(document::Problem::Severity::Warning, sentence), fileName));
}

void reportUsage(const QString& subcommand, const QString& sentence) {
    const QString program = QStringLiteral("barycage-cli");
    const QString command = subcommand.isEmpty() ? program : program + u' ' + subcommand;
    line(QStringLiteral("%1: error: %2").arg(command, sentence));
    line(QCoreApplication::translate("cli", "Try “%1 --help”.").arg(command));
}

bool print(const QByteArray& text) {
    const auto size = std::size_t(text.size());
    return std::fwrite(text.constData(), 1, size, stdout) == size && std::fflush(stdout) == 0;
}

} // namespace cli
