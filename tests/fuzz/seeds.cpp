// SPDX-License-Identifier: MIT
#include "document/disk/journal.h"
#include "fuzz/readers.h"
#include "io/exchange/entry_link.h"
#include "io/exchange/text_formats.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/palette/palette_reader.h"
#include "io/picture/picture_writers.h"
#include "io/picture/png/png_writer.h"
#include "io/picture/vector/svg_writer.h"
#include "io/sums/picture_request.h"
#include "io/sums/sum_file.h"
#include "io/video/video_writer.h"
#include "support/paths.h"

#include <QBuffer>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <array>

namespace fuzz {

namespace {

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArrayList filesIn(const QString& folder, const Reader& reader) {
    QStringList paths;
    for (QDirIterator it(folder, QDir::Files, QDirIterator::Subdirectories); it.hasNext();) {
        const QFileInfo file(it.next());
        if (reader.suffixes.contains(file.suffix().toLower().toUtf8())) paths << file.filePath();
    }
    paths.sort(); // the same order on every machine
    QByteArrayList files;
    for (const QString& path : std::as_const(paths))
        files << contents(path);
    return files;
}

QByteArray png(const QByteArray& system) {
    QBuffer device;
    device.open(QIODevice::WriteOnly);
    io::PictureFormat format;
    format.width = format.height = 2;
    format.dotsPerInch = 300;
    format.systemText = system;
    io::PngWriter writer(device, format);
    const std::array<std::uint32_t, 4> pixels{0xff000000, 0xffffffff, 0xff123456, 0xff808080};
    writer.writeRows(pixels);
    writer.finish();
    return device.data();
}

// Empty where videos cannot be written.
QByteArray video(io::VideoFormat format, const QByteArray& system) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("video"));
    io::VideoSettings settings;
    settings.format = format;
    settings.width = settings.height = 16;
    settings.systemText = system;
    io::VideoWriter writer(path, settings);
    QImage frame(16, 16, QImage::Format_RGB32);
    frame.fill(Qt::red);
    writer.writeFrame(frame);
    return writer.finish() ? QByteArray() : contents(path);
}

QByteArray raster(io::PictureFile file, const QByteArray& system) {
    using enum io::PictureFormat::Depth;
    QBuffer device;
    device.open(QIODevice::WriteOnly);
    io::PictureFormat format;
    format.width = format.height = 2;
    format.depth = io::takes(file, Bits8) ? Bits8 : Bits16;
    format.systemText = system;
    const auto writer = io::pictureWriter(file, device, format);
    if (format.depth == Bits8)
        writer->writeRows(std::array<std::uint32_t, 4>{0xff000000, 0xffffffff, 0xff123456, 0xff808080});
    else
        writer->writeRows(std::array<attractor::Rgba16, 4>{});
    writer->finish();
    return device.data();
}

QByteArray svg(const document::Fractal& fractal) {
    attractor::Camera camera;
    camera.width = camera.height = 64;
    io::SvgFormat format;
    format.depth = 2;
    return io::svgPicture(fractal, camera, format).bytes;
}

QByteArray sums(const document::Fractal& fractal) {
    io::PlaneExport picture;
    picture.fractal = fractal;
    picture.request.camera.width = 300;
    picture.request.camera.height = 20;
    const io::SumHeader header{io::pictureRequest(picture), attractor::CellKind::Count, 300, 20, {1000},
                               {{0, 20, 0, {1, 2}}}};
    QBuffer device;
    device.open(QIODevice::WriteOnly);
    io::SumWriter writer(device, header);
    std::vector<std::uint64_t> values(io::TileGrid(header).valuesIn(1));
    values[0] = 1;
    values[7] = 1'000'000'007;
    writer.write({1, values});
    writer.finish();
    return device.data();
}

// What the program itself writes, by suffix.
QByteArrayList written(const QByteArray& suffix) {
    const document::Fractal triangle = document::sierpinskiTriangle();
    const auto fractal = std::make_shared<const document::Fractal>(triangle);
    const QByteArray own = contents(support::testData(QStringLiteral("seeds/own_lines.ifs")));
    if (const auto format = io::textFormat(QString::fromLatin1(suffix)))
        return {io::textOf({fractal}, *format)};
    if (suffix == "gpl") return {io::writeGimpPalette(attractor::builtInPalettes().front())};
    if (suffix == "png") return {png(io::writeEntry(triangle)), png({}), png(own.repeated(20))};
    if (const auto format = io::videoFormat(QString::fromLatin1(suffix)))
        return {video(*format, io::writeEntry(triangle)), video(*format, own)};
    if (suffix == "svg") return {svg(triangle)};
    if (const auto file = io::pictureFileOf(QString::fromLatin1(suffix)))
        return {raster(*file, io::writeEntry(triangle)), raster(*file, {})};
    if (suffix == "link") {
        const QByteArray link = io::linkOf(triangle).link, data = link.sliced(link.indexOf(':') + 1);
        return {link, QByteArray::fromBase64(data, QByteArray::Base64UrlEncoding)};
    }
    if (suffix == "sum") return {sums(triangle)};
    if (suffix == "journal")
        return {document::recoveryFile({QStringLiteral("/somewhere/a.ifs"),
                                        QStringLiteral("a.ifs"),
                                        0,
                                        QDateTime::fromMSecsSinceEpoch(0, Qt::UTC),
                                        own,
                                        {}})};
    if (suffix == "comments") {
        QByteArrayList lines;
        for (const QByteArray& line : own.split('\n'))
            if (line.contains("barycage:")) lines << line.trimmed();
        return {lines.join('\n'),
                "branch 2 1\nby 1 0\nby 0 1\nby 2 3\nbranch 3\nbranch 3\nby 0 0\nby 0 0\nby 1e300 0",
                "rest 0 0\nrest 1 0\nrest 0 1\ncurrent 1 1\ncurrent 2 1\ncurrent 1 2"};
    }
    return {};
}

} // namespace

QByteArrayList seedsOf(const Reader& reader) {
    QByteArrayList seeds{{}};
    for (const QString& folder : {support::testData(), support::sourcePath(QStringLiteral("ifs_library")),
                                  qEnvironmentVariable("BARYCAGE_CORPUS")})
        if (!folder.isEmpty()) seeds << filesIn(folder, reader);
    for (const QByteArray& suffix : reader.suffixes)
        seeds << written(suffix);
    return seeds;
}

const QByteArrayList& tokens() {
    static const QByteArrayList all{
        // numbers
        "nan", "-inf", "1e999", "-1e-999", "4.9e-324", "2.3e-308", "3.4028235e38", "3.5e38", "1.7e308",
        "-1e308", "0x1p3", "1D5", "--1", "+-1", "1e", ".", "-", "0,5", "1/3", "1/0", "1e308/1e-308",
        "\xc2\xbd",
        "\xe2\x88\x92"
        "1",
        "99999999999999999999", "2147483648", "-2147483649", "0", "-0", "1",
        // Fractint's
        "{", "}", ";", "(3D)", "\x1a", "\r", "\n", "\r\n", "\xef\xbb\xbf", "\xff\xfe", " ", "\t", "'", ",",
        "comment", "frm:", "par:", "ifs:", "a=b", "x { .5 0 0 .5 0 0 1 }\n", "barycage: ", "rest ",
        "current ", "branch ", "by ", "stop ", "palette ", "map-colour ", "off ", "unweighted ", "weight ",
        "all", "#00112233", "gamma ", "contrast ", "vibrancy ", "supersample ", "deformation bend",
        QByteArray("\0", 1),
        // tables
        "a b c d e f p\n", "theta", "cumulative", "1;1;1;1;1;1;1\n", "1\t2\t3\t4\t5\t6\n", "0 0 1\n",
        // markup
        "<", ">", "</", "/>", "\"", "&amp;", "&#0;", "&#x10FFFF;", "&a;", "<![CDATA[", "]]>", "<!--", "-->",
        "<?xml version=\"1.0\" encoding=\"UTF-16\"?>", "<!DOCTYPE a [<!ENTITY a \"aaaaaaaaaa\">]>", "<flame>",
        "<flames>", "<xform ", "linear=\"1\"", "coefs=\"1e300 0 0 1e300 0 0\"", "chaos=\"\"",
        "xmlns=", "urn:barycage:system:1", "<svg ", "<system ",
        // palettes
        "GIMP Palette",
        "Name:", "Columns:", "gradient:", "opacity:", "index=", "color=", "rotation=", "smooth=yes",
        "title=\"", "255 255 255\n",
        // lessons
        "lesson: ", "file: ", "\n## ", "\\", "view: area ", "view: orbit ", "construction: chaos-game ",
        "cage: ", "outlines: cylinders ", "\xe2\x80\xae", "\xe2\x80\xa8",
        // PNG
        "\x89PNG\r\n\x1a\n", "IHDR", "iTXt", "zTXt", "tEXt", "IDAT", "IEND", QByteArray("Barycage\0", 9),
        QByteArray("\0\0\0\0", 4), QByteArray("\x7f\xff\xff\xff", 4), QByteArray("\xff\xff\xff\xff", 4),
        // JPEG, WebP, TIFF, OpenEXR
        "\xff\xd8\xff\xfe", "Barycage\n", "RIFF", "WEBP", "XMP ", "EXIF", QByteArray("II*\0", 4),
        QByteArray("MM\0*", 4), QByteArray("II+\0", 4), "\x76\x2f\x31\x01", QByteArray("string\0", 7),
        // recovery files
        "barycage-journal 1\n", "\"sha256\":", "\"current\":-1", "{}"};
    return all;
}

} // namespace fuzz
