// SPDX-License-Identifier: MIT
#include "document/lesson/lesson.h"

#include "document/text/reordered_text.h"

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

constexpr int maxPath = 4096;

bool isPortable(const QString& name) {
    return !name.isEmpty() &&
           std::ranges::none_of(name, [](QChar c) { return QStringLiteral("\\:*?\"<>|").contains(c); });
}

bool hasSuffix(const QString& name, const char* suffix) {
    return name.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
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

bool isLessonFile(const QString& path) {
    if (path.size() > maxPath || path != lessonLine(path, maxPath)) return false;
    QStringList folders = path.split(u'/');
    const QString name = folders.takeLast();
    if (!isPortable(name) || name.size() > 255 || name.startsWith(u'.') || hasSuffix(name, ".lesson"))
        return false;
    if (folders.isEmpty()) return true;
    const QString& root = folders.front();
    const bool isDrive = root.size() == 2 && root[0].isLetter() && root[1] == u':';
    if (root.isEmpty() || isDrive) folders.removeFirst();
    return (hasSuffix(name, ".ifs") || hasSuffix(name, ".par")) && std::ranges::all_of(folders, isPortable);
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
