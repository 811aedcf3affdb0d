// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QTextDocument>
#include <QTextDocumentFragment>

// Names and paths come from files and may look like anything. Status tips, accessible texts and the cells of
// lists show a text as it is written; the functions here are for what would do otherwise. Labels are plain
// text by Application::notify().
namespace view {

// A tool tip or a What's This that shows a text as it is written: Qt would interpret text that looks like
// markup, and read the pictures that it names.
inline QString tooltipText(const QString& text) {
    return Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal) : text;
}

// The text of such a tool tip, for a place where markup is not understood, such as a status tip.
inline QString plainText(const QString& tip) {
    return Qt::mightBeRichText(tip) ? QTextDocumentFragment::fromHtml(tip).toPlainText() : tip;
}

// A tip that ends as a sentence does.
inline QString asSentence(const QString& tip) {
    const bool ends = tip.isEmpty() || QStringLiteral(".!?…:)").contains(tip.back());
    return ends ? tip : tip + u'.';
}

// A name as part of the title of a window, where “[*]” would stand for unsaved changes.
inline QString titleText(QString name) {
    return name.replace(QLatin1String("[*]"), QLatin1String("[*][*]"));
}

} // namespace view
