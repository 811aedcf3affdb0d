// SPDX-License-Identifier: MIT
#include "convert/convert_format.h"

#include "options/parser.h"
#include "options/tr.h"
#include "options/usage_error.h"

namespace cli {

using io::TextFormat;

bool isFractint(const ConvertFormat& format) {
    return format == ConvertFormat(TextFormat::Fractint);
}

bool isTable(const ConvertFormat& format) {
    const auto* text = std::get_if<TextFormat>(&format);
    return text && io::holdsOneSystem(*text);
}

bool holdsOneEntry(const ConvertFormat& format) {
    return isTable(format) ||
           !(std::holds_alternative<TextFormat>(format) || std::holds_alternative<PdfFormat>(format));
}

std::vector<std::string> convertFormats() {
    std::vector<std::string> words;
    for (const TextFormat format : io::textFormats)
        words.emplace_back(io::wordOf(format));
    words.insert(words.end(), {"ply", "pdf"}); // formats of points as well
    for (const auto& [mesh, word] : ifs::names<io::MeshFormat>)
        if (mesh != io::MeshFormat::Ply) words.emplace_back(word);
    words.emplace_back("scad");
    return words;
}

QString suffixOf(const ConvertFormat& format) {
    if (const auto* text = std::get_if<TextFormat>(&format)) return io::suffixOf(*text);
    if (std::holds_alternative<PdfFormat>(format)) return QStringLiteral("pdf");
    if (std::holds_alternative<ScadFormat>(format)) return QStringLiteral("scad");
    if (const auto* mesh = std::get_if<io::MeshFormat>(&format)) return io::suffixOf(*mesh);
    return std::get<io::PointFormat>(format) == io::PointFormat::Ply ? QStringLiteral("ply")
                                                                     : QStringLiteral("csv");
}

ConvertFormat formatOf(const QString& name, bool hasPoints, bool hasVoxels) {
    if (hasPoints && name.compare(u"csv", Qt::CaseInsensitive) == 0) return io::PointFormat::Csv;
    if (name.compare(u"ply", Qt::CaseInsensitive) == 0) {
        if (hasPoints) return io::PointFormat::Ply;
        if (hasVoxels) return io::MeshFormat::Ply;
        throw UsageError{
            tr("A .ply file contains points or the surface of a solid: give the number of points "
               "with --points, or the size of the voxels with --voxel or --resolution.")};
    }
    if (name.compare(u"pdf", Qt::CaseInsensitive) == 0) return PdfFormat{};
    if (name.compare(u"scad", Qt::CaseInsensitive) == 0) return ScadFormat{};
    if (const auto format = io::meshFormat(name)) return *format;
    if (const auto format = io::textFormat(name)) return *format;
    std::vector<std::string> names = convertFormats();
    names.front() += " (.ifs)";
    throw UsageError{tr("The formats are %2, not “%1”.").arg(name, listed(names, tr("and")))};
}

QString dimensionObstacle(const ConvertFormat& format, const document::Fractal& fractal) {
    if (std::holds_alternative<io::MeshFormat>(format) || std::holds_alternative<ScadFormat>(format))
        return document::system3(fractal)
                   ? QString()
                   : tr("“%1” was omitted: only systems in space have a solid; --lift makes one of it.")
                         .arg(fractal.name);
    const auto* text = std::get_if<TextFormat>(&format);
    return !text || io::holds(*text, fractal)
               ? QString()
               : tr("“%1” was omitted: the format can store only systems in the plane.").arg(fractal.name);
}

} // namespace cli
