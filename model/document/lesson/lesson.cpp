// SPDX-License-Identifier: MIT
#include "document/lesson/lesson.h"

#include "document/reordered_text.h"

#include <algorithm>

namespace document {

namespace {

bool isKept(QChar c) {
    return c == u'\n' || (c.category() != QChar::Other_Control && !reordersText(c));
}

QString cut(const QString& text, int limit) {
    QString kept = text.left(limit);
    if (!kept.isEmpty() && kept.back().isHighSurrogate()) kept.chop(1);
    return kept;
}

} // namespace

attractor::Camera cameraOf(const LessonArea& area, attractor::RasterSize size) {
    attractor::Camera camera = attractor::cameraOf(area.view, size);
    if (size.width > 0) camera.pixelsPerUnit = std::min(camera.pixelsPerUnit, size.width / area.width);
    return camera;
}

LessonArea areaOf(const attractor::Camera& camera) {
    return {attractor::viewOf(camera), camera.width / camera.pixelsPerUnit};
}

bool isLessonFileName(const QString& name) {
    if (name.isEmpty() || name.size() > 255 || name.startsWith(u'.') || name != lessonLine(name, 255))
        return false;
    if (name.endsWith(QLatin1String(".lesson"), Qt::CaseInsensitive)) return false; // it could name itself
    return std::ranges::none_of(name, [](QChar c) { return QStringLiteral("/\\:*?\"<>|").contains(c); });
}

QString lessonLine(const QString& text, int limit) {
    QString line = text;
    for (QChar& c : line)
        if (c.isSpace()) c = u' ';
    line.removeIf([](QChar c) { return !isKept(c); });
    return cut(line.trimmed(), limit).trimmed();
}

QString lessonText(const QString& text, int limit) {
    QString plain = text;
    plain.replace(QLatin1String("\r\n"), QLatin1String("\n"));
    for (QChar& c : plain) {
        if (c == u'\r' || c == QChar::LineSeparator || c == QChar::ParagraphSeparator) c = u'\n';
        if (c == u'\t') c = u' ';
    }
    plain.removeIf([](QChar c) { return !isKept(c); });
    QStringList lines = cut(plain, limit).split(u'\n');
    for (QString& line : lines)
        while (!line.isEmpty() && line.back().isSpace())
            line.chop(1);
    while (!lines.isEmpty() && lines.front().isEmpty())
        lines.removeFirst();
    while (!lines.isEmpty() && lines.back().isEmpty())
        lines.removeLast();
    return lines.join(u'\n');
}

} // namespace document
