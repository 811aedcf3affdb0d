// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"

#include "io/flame.h"
#include "io/fractint_reader.h"
#include "io/png_system.h"
#include "io/svg_system.h"

#include <QFileInfo>

namespace io {

namespace {

document::FractalFile fileOf(const EmbeddedSystem& embedded) {
    if (!embedded.failure) return readFractint(embedded.text);
    document::FractalFile file;
    document::Problem problem;
    problem.severity = document::Problem::Severity::Error;
    problem.message = *embedded.failure;
    file.problems << problem;
    return file;
}

} // namespace

Collection readCollection(const QByteArray& bytes, const QString& path) {
    if (looksLikePng(bytes)) return {QStringLiteral("png"), fileOf(readPngSystem(bytes))};
    if (looksLikeSvg(bytes)) return {QStringLiteral("svg"), fileOf(readSvgSystem(bytes))};
    if (looksLikeFlame(bytes)) return {QStringLiteral("flame"), readFlame(bytes)};
    return {QStringLiteral("fractint"), readFractint(bytes, QFileInfo(path).completeBaseName())};
}

} // namespace io
