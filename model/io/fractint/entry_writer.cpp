// SPDX-License-Identifier: MIT
#include "io/fractint/entry_writer.h"

#include "io/fractint/fractint_rows.h"
#include "io/fractint/metadata_comments.h"

#include <vector>

namespace io {

namespace {

QByteArrayList commentLines(const document::Fractal& fractal) {
    QByteArrayList lines;
    for (const QString& comment : fractal.comments) {
        const QByteArray text = fractint::storedComment(comment).toUtf8();
        lines << (text.isEmpty() ? QByteArray("  ;") : "  ; " + text);
    }
    return lines;
}

QByteArrayList rowLines(const document::Fractal& fractal) {
    std::vector<std::vector<QByteArray>> cells;
    for (const fractint::Row& row : fractint::rowsOf(fractal)) {
        std::vector<QByteArray> texts;
        for (const double number : row.coefficients)
            texts.push_back(fractint::numberText(number));
        texts.push_back(fractint::numberText(row.written));
        cells.push_back(std::move(texts));
    }
    return fractint::brokenRows(cells);
}

} // namespace

QByteArray writeEntry(const document::Fractal& fractal, const QByteArray& lineEnd) {
    QByteArray header = fractint::storedName(fractal.name).toUtf8();
    header += document::dimension(fractal) == 3 ? " (3D) {" : " {";
    if (const QByteArray comment = fractint::storedComment(fractal.headerComment).toUtf8();
        !comment.isEmpty())
        header += " ; " + comment;
    const QByteArrayList lines = QByteArrayList{header} + commentLines(fractal) + metadataComments(fractal) +
                                 rowLines(fractal) + QByteArrayList{"}"};
    return lines.join(lineEnd) + lineEnd;
}

} // namespace io
