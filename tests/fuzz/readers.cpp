// SPDX-License-Identifier: MIT
#include "fuzz/readers.h"

#include "fuzz/handled.h"

#include "document/disk/journal.h"
#include "io/collection_reader.h"
#include "io/exchange/entry_link.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "io/fractint/metadata_comments.h"
#include "io/lesson/lesson_reader.h"
#include "io/lesson/lesson_writer.h"
#include "io/palette/palette_reader.h"
#include "io/palette/palette_stops.h"
#include "io/picture/decoding/picture_decoder.h"
#include "io/picture/png/png_system.h"
#include "io/picture/vector/svg_system.h"
#include "io/raster/raster_system.h"
#include "io/sums/picture_request.h"
#include "io/sums/sum_file.h"
#include "io/table/table_reader.h"
#include "io/table/table_writer.h"
#include "io/video/video_system.h"

#include <QBuffer>
#include <QtEndian>

#include <zlib.h>

#include <cmath>
#include <vector>

namespace fuzz {

namespace {

using document::Problem;

template <int Dim> void checkNumbers(const ifs::IteratedFunctionSystem<Dim>& system) {
    for (const auto& map : system.maps)
        promise(map.map.linear.allFinite() && map.map.translation.allFinite() &&
                    std::isfinite(map.weight.value_or(0)),
                "every number is finite");
}

template <int Dim> void checkShape(const document::Shape<Dim>& shape) {
    checkNumbers(shape.system);
    if (shape.cage) promise(ifs::isValid(*shape.cage), "a cage can be used");
}

void check(const document::Problems& problems) {
    for (const Problem& problem : problems)
        promise(!problem.message.isEmpty() && problem.line >= 0 && problem.column >= 0,
                "a problem has a sentence and a place");
}

void check(const document::Fractal& fractal) {
    if (const auto* plane = document::plane(fractal)) checkShape(*plane);
    if (const auto* space = document::space(fractal)) checkShape(*space);
    promise(io::isGradient(fractal.appearance.palette.stops), "a palette is a gradient");
    const attractor::Appearance& look = fractal.appearance;
    promise(look.brightness > 0 && look.gamma > 0 && look.contrast > 0, "a picture can be drawn");
    promise(look.vibrancy >= 0 && look.vibrancy <= 1, "a vibrancy is a share");
}

void check(const document::FractalFile& file) {
    check(file.problems);
    for (const document::Entry& entry : file.entries) {
        promise(entry.fractal != nullptr, "an entry has a fractal");
        check(*entry.fractal);
        check(entry.problems);
    }
}

// What an entry says when it has been written afresh. Weights that were never given are written out.
template <int Dim> void checkRewritten(const document::Fractal& fractal, const document::Shape<Dim>& shape) {
    if (shape.system.maps.empty()) return;
    const document::FractalFile back = io::readFractint(io::writeEntry(fractal));
    promise(back.entries.size() == 1, "an entry that is written is one entry");
    const document::Fractal before = io::asStored(fractal);
    const document::Fractal after = io::asStored(*back.entries.first().fractal);
    const auto* stored = std::get_if<document::Shape<Dim>>(&before.shape);
    const auto* reread = std::get_if<document::Shape<Dim>>(&after.shape);
    const auto& maps = shape.system.maps;
    promise(reread != nullptr && reread->system.maps.size() == maps.size(),
            "an entry that is written keeps its maps");
    for (std::size_t i = 0; i < maps.size(); ++i)
        promise(reread->system.maps[i].map == maps[i].map &&
                    reread->system.maps[i].enabled == maps[i].enabled,
                "an entry that is written keeps its numbers");
    promise(stored->cage == reread->cage && stored->moved == reread->moved &&
                before.appearance == after.appearance,
            "an entry that is written keeps its cage, its branches and its appearance");
}

void checkRewritten(const document::Fractal& fractal) {
    if (const auto* plane = document::plane(fractal)) checkRewritten(fractal, *plane);
    if (const auto* space = document::space(fractal)) checkRewritten(fractal, *space);
}

// The same file with its first system changed contains the change and everything else.
void checkEdited(document::FractalFile file) {
    for (document::Entry& entry : file.entries) {
        if (document::dimension(*entry.fractal) != 2) continue;
        document::Fractal changed = *entry.fractal;
        auto& maps = document::system2(changed)->maps;
        maps.front().map.linear(0, 1) = -0.0625;
        if (maps.size() > 1) maps.pop_back();
        document::plane(changed)->cage.reset();
        entry.fractal = std::make_shared<const document::Fractal>(std::move(changed));
        break;
    }
    const QByteArray text = io::writeFractint(file);
    const document::FractalFile back = io::readFractint(text, QStringLiteral("bare"));
    promise(back.entries.size() == file.entries.size(), "an edit of one entry changes no other");
    for (qsizetype i = 0; i < file.entries.size(); ++i) {
        const auto* wanted = document::system2(*file.entries[i].fractal);
        const auto* found = document::system2(*back.entries[i].fractal);
        promise((wanted == nullptr) == (found == nullptr), "an edit leaves systems systems");
        if (wanted == nullptr) continue;
        promise(wanted->maps.size() == found->maps.size(), "an edit is written");
        for (std::size_t k = 0; k < wanted->maps.size(); ++k)
            promise(wanted->maps[k].map == found->maps[k].map, "an edit is written exactly");
    }
}

void readFractint(const QByteArray& bytes) {
    const document::FractalFile file = io::readFractint(bytes, QStringLiteral("bare"));
    check(file);
    promise(!file.entries.isEmpty() || !file.problems.isEmpty(), "nothing to show is a problem");
    promise(io::writeFractint(file) == bytes, "a file nobody touched is written byte for byte");
    if (!file.entries.isEmpty()) checkRewritten(*file.entries.first().fractal);
    checkEdited(file);
    checkHandled(file);
}

// What the program opens, whatever it is.
void readCollection(const QByteArray& bytes) {
    const io::Collection collection = io::readCollection(bytes, QStringLiteral("some.csv"));
    check(collection.file);
    promise(!collection.file.entries.isEmpty() || !collection.file.problems.isEmpty(),
            "nothing to show is a problem");
    checkHandled(collection.file);
}

void readFlame(const QByteArray& bytes) {
    const document::FractalFile file = io::readFlame(bytes);
    check(file);
    QList<std::shared_ptr<const document::Fractal>> fractals;
    for (const document::Entry& entry : file.entries)
        fractals << entry.fractal;
    const document::FractalFile back = io::readFlame(io::writeFlame(fractals));
    promise(back.entries.size() == file.entries.size(), "flames that are written read back");
    for (qsizetype i = 0; i < file.entries.size(); ++i) {
        const auto &a = document::system2(*file.entries[i].fractal)->maps,
                   &b = document::system2(*back.entries[i].fractal)->maps;
        promise(a.size() == b.size(), "a flame that is written keeps its maps");
        for (std::size_t k = 0; k < a.size(); ++k)
            promise(a[k].map == b[k].map, "a flame that is written keeps its numbers");
    }
    checkHandled(file);
}

void readTable(const QByteArray& bytes) {
    const QString text = QString::fromUtf8(bytes);
    for (const auto& columns : {std::optional<io::TableColumns>(),
                                io::tableColumns(QStringLiteral("r s theta phi e f cumulative"))}) {
        const io::Table table = io::readTable(text, columns);
        check(table.problems);
        checkNumbers(ifs::IteratedFunctionSystem<2>{table.rows});
        promise(!table.rows.empty() || !table.problems.isEmpty(), "no rows is a problem");
        if (columns || !table.problems.isEmpty()) continue;
        const io::Table back = io::readTable(io::writeTable(table.rows));
        promise(back.rows.size() == table.rows.size(), "a table that is copied can be pasted");
        for (std::size_t i = 0; i < table.rows.size(); ++i)
            promise(back.rows[i].map == table.rows[i].map, "a table that is copied keeps its numbers");
    }
    checkHandled(io::readCollection(bytes, QStringLiteral("some.csv")).file);
}

void readPalettes(const QByteArray& bytes) {
    const io::PaletteFile file = io::readPalettes(bytes, QStringLiteral("palette"));
    check(file.problems);
    promise(!file.palettes.empty() || !file.problems.isEmpty(), "no palette is a problem");
    for (const attractor::Palette& palette : file.palettes) {
        promise(io::isGradient(palette.stops), "a palette is a gradient");
        const io::PaletteFile back = io::readPalettes(io::writeGimpPalette(palette), {});
        promise(back.palettes.size() == 1 && back.palettes.front().stops == palette.stops,
                "a palette that is written reads back");
    }
}

// Bytes as what a link holds, and as the link.
void readLinks(const QByteArray& bytes) {
    for (const QByteArray& link : {"barycage:" + bytes.toBase64(QByteArray::Base64UrlEncoding), bytes}) {
        const io::EmbeddedSystem system = io::readLink(link);
        promise(!system.failure || system.text.isEmpty(), "a failure gives no text");
        promise(system.text.size() <= io::maxLinkedText, "a link has a limit");
        checkHandled(io::readFractint(system.text));
    }
}

// With checksums that fit, or what is inside would hardly ever be looked at.
QByteArray withChecksums(QByteArray png) {
    constexpr qsizetype head = 8; // the signature, and the length and type of a chunk
    for (qsizetype at = head; at + 12 <= png.size();) {
        const auto length = qFromBigEndian<quint32>(png.constData() + at);
        if (qint64(length) > png.size() - at - 12) break;
        const auto sum =
            quint32(crc32(0, reinterpret_cast<const Bytef*>(png.constData() + at + 4), uInt(length + 4)));
        qToBigEndian(sum, png.data() + at + 8 + length);
        at += 12 + qsizetype(length);
    }
    return png;
}

void readPng(const QByteArray& bytes) {
    for (const QByteArray& png : {bytes, withChecksums(bytes)}) {
        const io::EmbeddedSystem system = io::readPngSystem(png);
        promise(!system.failure || system.text.isEmpty(), "a failure gives no text");
        promise(system.failure || png.startsWith("\x89PNG"), "only pictures carry systems");
        checkHandled(io::readFractint(system.text));
    }
}

void readRaster(const QByteArray& bytes) {
    if (io::rasterFormat(bytes).isEmpty()) return;
    const io::EmbeddedSystem system = io::readRasterSystem(bytes);
    promise(bool(system.failure) == system.text.isEmpty(), "a text or a failure");
    checkHandled(io::readFractint(system.text));
    const io::DecodedPicture picture = io::decodedPicture(bytes);
    promise(picture.flaw.has_value() == picture.image.isNull(), "a picture or a sentence");
}

// With checksums: from the header on, each block and the number of its tile.
QByteArray withChecksumsOfSums(QByteArray sums) {
    quint32 tile = 0;
    for (qsizetype at = 8; at + 8 <= sums.size();) {
        const auto length = qFromLittleEndian<quint32>(sums.constData() + at);
        if (qint64(length) > sums.size() - at - 8) break;
        const auto number = qToLittleEndian(tile);
        const auto sum = crc32(crc32(0, reinterpret_cast<const Bytef*>(&number), sizeof number),
                               reinterpret_cast<const Bytef*>(sums.constData() + at + 4), uInt(length));
        qToLittleEndian(quint32(sum), sums.data() + at + 4 + length);
        at += 8 + qsizetype(length);
        if (at + 4 > sums.size()) break;
        tile = qFromLittleEndian<quint32>(sums.constData() + at);
        at += 4;
    }
    return sums;
}

void readSums(const QByteArray& bytes) {
    for (const QByteArray& sums : {bytes, withChecksumsOfSums(bytes)}) {
        QBuffer device;
        device.setData(sums);
        device.open(QIODevice::ReadOnly);
        io::SumReader reader(device);
        if (reader.failure()) continue;
        const io::TileGrid grid(reader.header());
        for (const auto& [number, position] : reader.tiles())
            if (const auto tile = reader.read(number))
                promise(tile->values.size() == grid.valuesIn(number), "a tile has all of its cells");
        if (const auto picture = io::pictureOf(reader.header().request))
            promise(io::pictureOf(io::pictureRequest(*picture)).has_value(),
                    "the request of a picture that was read can be read");
        if (const auto picture = io::spacePictureOf(reader.header().request))
            promise(io::spacePictureOf(io::pictureRequest(*picture)).has_value(),
                    "the request of a picture in space that was read can be read");
    }
}

void readSvg(const QByteArray& bytes) {
    const io::EmbeddedSystem system = io::readSvgSystem(bytes);
    promise(!system.failure || system.text.isEmpty(), "a failure gives no text");
    promise(system.text.size() <= bytes.size() * 3, "no entity is expanded");
    checkHandled(io::readFractint(system.text));
}

void readVideo(const QByteArray& bytes) {
    const io::EmbeddedSystem system = io::readVideoSystem(bytes);
    promise(!system.failure || system.text.isEmpty(), "a failure gives no text");
    promise(system.failure || !io::looksLikeVideo(bytes).isEmpty(), "only videos carry systems");
    promise(system.text.size() <= bytes.size() * 3, "no text is longer than the file");
    checkHandled(io::readFractint(system.text));
}

void readJournal(const QByteArray& bytes) {
    if (const auto snapshot = document::snapshotIn(bytes))
        promise(document::snapshotIn(document::recoveryFile(*snapshot)) == snapshot,
                "a recovery file is what it says");
    // The digest in front keeps changed bytes out; these are what a window might have kept.
    const document::Snapshot kept{QString::fromLatin1(bytes.left(20)),
                                  QString::fromUtf8(bytes.left(40)),
                                  1,
                                  QDateTime::fromMSecsSinceEpoch(1'700'000'000'123, Qt::UTC),
                                  bytes,
                                  {}};
    const auto back = document::snapshotIn(document::recoveryFile(kept));
    promise(back && back->bytes == bytes && back->path == kept.path, "what is kept can be recovered");
}

void readLesson(const QByteArray& bytes) {
    const io::LessonFile file = io::readLesson(bytes);
    check(file.problems);
    const document::Lesson& lesson = file.lesson;
    promise(!lesson.steps.isEmpty() || !file.problems.isEmpty(), "a lesson without steps is a problem");
    promise(lesson.steps.size() <= document::maxLessonSteps, "a lesson has an end");
    promise(lesson.file.isEmpty() || document::isLessonFile(lesson.file),
            "a lesson names a file of fractals");
    for (const document::LessonStep& step : lesson.steps) {
        promise(step.text.size() <= document::maxLessonText && step.title.size() <= document::maxLessonTitle,
                "a text is short");
        if (const auto* area = std::get_if<document::LessonArea>(&step.state.view)) {
            const attractor::Camera camera = document::cameraOf(*area, {640, 480});
            promise(camera.pixelsPerUnit > 0 && area->view.centre.allFinite(), "a view can be shown");
        }
        if (const auto* orbit = std::get_if<document::LessonOrbit>(&step.state.view)) {
            attractor::OrbitCamera camera = orbit->camera;
            camera.size = {640, 480};
            promise(attractor::isUsable(camera), "a view of a solid can be shown");
        }
    }
    if (lesson.steps.isEmpty()) return;
    const io::LessonFile back = io::readLesson(io::writeLesson(lesson));
    promise(back.lesson == lesson, "a lesson that is written reads back");
}

// Our own comment lines, one a line, on a system of three maps in the plane and on one in space.
void readMetadataComments(const QByteArray& bytes) {
    io::MetadataComments comments;
    for (const QByteArray& line : bytes.split('\n'))
        comments.read(line.contains("barycage:") ? line.sliced(line.indexOf("barycage:"))
                                                 : "barycage: " + line);
    document::Fractal space = document::sierpinskiTriangle();
    document::Shape<3> tetrahedron;
    for (const auto& map : document::system2(space)->maps)
        ifs::append(tetrahedron.system,
                    ifs::AffineMap<3>{ifs::Matrix<3>::Identity() * 0.5, {map.map.translation.x(), 0, 0.5}});
    space.shape = tetrahedron;
    for (document::Fractal fractal : {document::sierpinskiTriangle(), space}) {
        for (const QString& sentence : comments.applyTo(fractal).sentences)
            promise(!sentence.isEmpty(), "what does not fit is said");
        check(fractal);
        for (const QByteArray& line : io::metadataComments(fractal))
            promise(line.size() < 70 || line.contains("palette"), "a line of ours is short");
        checkRewritten(fractal);
    }
}

} // namespace

std::span<const Reader> readers() {
    static const std::vector<Reader> all{
        {"fractint", readFractint, {"ifs", "par"}},
        {"collection",
         readCollection,
         {"ifs", "par", "flame", "flam3", "xml", "aifs", "json", "csv", "tsv", "txt", "svg", "png", "jpg",
          "webp", "tiff", "exr"}},
        {"flame", readFlame, {"flame", "flam3", "xml"}},
        {"table", readTable, {"csv", "tsv", "txt"}},
        {"lesson", readLesson, {"lesson"}},
        {"links", readLinks, {"link"}},
        {"palettes", readPalettes, {"gpl", "ggr", "ugr", "map"}},
        {"sums", readSums, {"sum"}},
        {"png", readPng, {"png"}},
        {"raster", readRaster, {"jpg", "webp", "tiff", "exr"}},
        {"svg", readSvg, {"svg"}},
        {"video", readVideo, {"mp4", "webm", "mkv", "gif", "webp"}},
        {"journal", readJournal, {"journal"}},
        {"metadata_comments", readMetadataComments, {"comments"}},
    };
    return all;
}

} // namespace fuzz
