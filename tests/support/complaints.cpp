// SPDX-License-Identifier: MIT
#include "support/complaints.h"

#include "document/document.h"
#include "ifs/system/barycentric.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_rows.h"
#include "io/fractint/fractint_writer.h"
#include "io/fractint/metadata_comments.h"

#include <QStringList>

#include <cmath>

namespace support {

namespace {

bool isFinite(const ifs::AffineMap<2>& map) {
    return map.linear.allFinite() && map.translation.allFinite();
}

// What of a system is not the same.
template <int Dim> QStringList differences(const document::Shape<Dim>& a, const document::Shape<Dim>& b) {
    QStringList parts;
    const auto& mapsOfA = a.system.maps;
    const auto& mapsOfB = b.system.maps;
    if (mapsOfA.size() != mapsOfB.size()) return {QStringLiteral("number of maps")};
    for (std::size_t i = 0; i < mapsOfA.size(); ++i)
        if (!(mapsOfA[i] == mapsOfB[i]))
            parts << QStringLiteral("map %1%2%3%4")
                         .arg(i + 1)
                         .arg(mapsOfA[i].map == mapsOfB[i].map ? QString() : QStringLiteral(" code"),
                              mapsOfA[i].weight == mapsOfB[i].weight ? QString() : QStringLiteral(" weight"),
                              mapsOfA[i].id == mapsOfB[i].id ? QString() : QStringLiteral(" id"));
    if (!(a.system.links == b.system.links)) parts << QStringLiteral("links");
    if (!(a.system.symmetry == b.system.symmetry)) parts << QStringLiteral("symmetry");
    if (!(a.moved == b.moved)) parts << QStringLiteral("branches");
    if (!(a.animation == b.animation)) parts << QStringLiteral("animation");
    return parts;
}

Complaint complaintAboutReading(const document::Fractal& fractal, const document::Fractal& reread) {
    // An entry whose maps have all been deleted holds no system to a reader.
    if (const auto* maps = document::system2(fractal); maps && maps->maps.empty()) return {};
    if (const auto* maps = document::system3(fractal); maps && maps->maps.empty()) return {};
    document::Fractal kept = io::asStored(fractal);
    document::Fractal read = io::asStored(reread);
    // In an entry that is written anew, as one that is lifted into space, a name is one word.
    if (read.name == io::fractint::storedName(kept.name)) kept.name = read.name;
    if (auto* maps = document::system2(kept))
        if (auto* other = document::system2(read); other && other->maps.size() == maps->maps.size())
            for (std::size_t i = 0; i < maps->maps.size();
                 ++i) // a weight that was never given is written out
                if (!maps->maps[i].weight) other->maps[i].weight.reset();
    if (kept == read) return {};
    QStringList parts;
    const document::Change::Parts changed = document::difference(kept, read);
    if (changed.testFlag(document::Change::System)) {
        parts << QStringLiteral("system:");
        if (kept.shape.index() != read.shape.index())
            parts << QStringLiteral("other dimension");
        else if (const auto* plane = std::get_if<document::Shape<2>>(&kept.shape))
            parts << differences(*plane, std::get<document::Shape<2>>(read.shape));
        else if (const auto* space = std::get_if<document::Shape<3>>(&kept.shape))
            parts << differences(*space, std::get<document::Shape<3>>(read.shape));
    }
    if (changed.testFlag(document::Change::Cage)) parts << QStringLiteral("cage");
    if (changed.testFlag(document::Change::Appearance)) parts << QStringLiteral("appearance");
    if (kept.name != read.name) parts << QStringLiteral("name");
    if (kept.comments != read.comments || kept.headerComment != read.headerComment)
        parts << QStringLiteral("comments");
    return QStringLiteral("%1: other %2 when read again").arg(kept.name, parts.join(u' '));
}

} // namespace

Complaint complaintAbout(const document::Fractal& fractal) {
    if (const auto* system = document::system2(fractal))
        for (const auto& map : system->maps)
            if (!isFinite(map.map) || !std::isfinite(map.weight.value_or(0)))
                return QStringLiteral("a map has a number that is not finite");
    if (const auto* cage = document::cage2(fractal)) {
        if (cage->rest.size() < 3 || cage->rest.size() != cage->current.size())
            return QStringLiteral("the cage has %1 and %2 vertices")
                .arg(cage->rest.size())
                .arg(cage->current.size());
        for (const auto* vertices : {&cage->rest, &cage->current})
            for (const ifs::Vector<2>& vertex : *vertices)
                if (!vertex.allFinite()) return QStringLiteral("a vertex is not finite");
        if (cage->rest.size() == 3 &&
            !ifs::isAffineBasis<2>(ifs::Simplex<2>{cage->rest[0], cage->rest[1], cage->rest[2]}))
            return QStringLiteral("the rest triangle is flat");
    }
    const attractor::Appearance& look = fractal.appearance;
    if (!(look.brightness > 0) || !(look.gamma > 0) || !std::isfinite(look.brightness * look.gamma))
        return QStringLiteral("brightness %1, gamma %2").arg(look.brightness).arg(look.gamma);
    if (!(look.contrast > 0) || !std::isfinite(look.contrast) || !(look.vibrancy >= 0 && look.vibrancy <= 1))
        return QStringLiteral("contrast %1, vibrancy %2").arg(look.contrast).arg(look.vibrancy);
    if (!(look.shadow >= 0 && look.shadow <= 1) || !std::isfinite(look.shadowLean * look.shadowLength))
        return QStringLiteral("shadow %1 %2 %3").arg(look.shadow).arg(look.shadowLean).arg(look.shadowLength);
    return {};
}

Complaint complaintAbout(const document::FractalFile& file, const QString& bareName) {
    const QByteArray bytes = io::writeFractint(file);
    const document::FractalFile reread = io::readFractint(bytes, bareName);
    if (reread.entries.size() != file.entries.size())
        return QStringLiteral("%1 entries were written, %2 read")
            .arg(file.entries.size())
            .arg(reread.entries.size());
    for (qsizetype i = 0; i < file.entries.size(); ++i) {
        const Complaint complaint =
            complaintAboutReading(*file.entries[i].fractal, *reread.entries[i].fractal);
        if (!complaint.isEmpty())
            return complaint + QStringLiteral("\n") + QString::fromUtf8(bytes.left(14000));
    }
    return {};
}

} // namespace support
