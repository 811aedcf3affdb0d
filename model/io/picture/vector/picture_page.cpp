// SPDX-License-Identifier: MIT
#include "io/picture/vector/picture_page.h"

#include "io/overlay/pdf_overlay.h"
#include "io/overlay/svg_overlay.h"
#include "io/picture/png/png_writer.h"
#include "io/picture/vector/pdf_file.h"
#include "io/picture/vector/svg_document.h"

#include <QBuffer>
#include <QColor>
#include <QXmlStreamWriter>
#include <QtEndian>

#include <algorithm>
#include <utility>

namespace io {

namespace {

using Depth = PictureFormat::Depth;
using Pixels = PictureFormat::Pixels;
using Row = std::span<const std::uint32_t>;

// The format without texts, for the pixels alone.
PictureFormat withoutTexts(const PictureFormat& format) {
    PictureFormat plain;
    plain.width = format.width;
    plain.height = format.height;
    plain.pixels = format.pixels;
    return plain;
}

// A PNG in memory.
class PngBytes {
public:
    explicit PngBytes(const PictureFormat& format) {
        m_buffer.open(QIODevice::WriteOnly);
        m_writer = std::make_unique<PngWriter>(m_buffer, format);
    }

    PngWriter& writer() { return *m_writer; }
    const QByteArray& bytes() const { return m_buffer.data(); } // complete after finish()

private:
    QBuffer m_buffer;
    std::unique_ptr<PngWriter> m_writer;
};

class PagePictureWriter : public PictureWriter {
public:
    Failure writeRows(std::span<const std::uint32_t> pixels) override {
        const auto width = std::size_t(m_format.width);
        for (std::size_t at = 0; at < pixels.size() && !m_failure; at += width)
            m_failure = writeRow(pixels.subspan(at, width));
        return m_failure;
    }
    Failure writeRows(std::span<const attractor::Rgba16>) override {
        Q_ASSERT(false);
        return m_failure;
    }
    Failure finish() override {
        if (!m_failure) m_failure = end();
        return m_failure;
    }

protected:
    explicit PagePictureWriter(const PictureFormat& format) : m_format(format) {}

    virtual Failure writeRow(Row row) = 0;
    virtual Failure end() = 0;

    double dotsPerInch() const { return m_format.dotsPerInch.value_or(pixelsOfSvg); }

    const PictureFormat m_format;

private:
    Failure m_failure;
};

// The picture in strips, each small enough for libxml2, which refuses an attribute of ten million bytes.
class SvgPage final : public PagePictureWriter {
public:
    SvgPage(PicturePage page, QIODevice& device, const PictureFormat& format)
        : PagePictureWriter(format), m_page(std::move(page)), m_device(device), m_xml(&device) {
        startSvg(m_xml, {{format.width, format.height}, dotsPerInch(), m_page.title, format.systemText});
    }

private:
    static constexpr std::size_t stripBytes = 7'000'000; // bytes of pixels; a third more as text

    int rowsInStrip() const {
        const std::size_t pixel = m_format.pixels == Pixels::Opaque ? 3 : 4;
        return int(std::max<std::size_t>(2, stripBytes / (pixel * std::size_t(m_format.width))));
    }

    Failure writeRow(Row row) override {
        if (!m_strip) {
            beginStrip();
            // Overlap of one row between opaque strips, so that no gap shows at any scale.
            if (!m_last.empty()) {
                const Failure failure = m_strip->writer().writeRows(m_last);
                if (failure) return failure;
            }
        }
        if (const Failure failure = m_strip->writer().writeRows(row)) return failure;
        if (++m_row < m_stripEnd) return std::nullopt;
        if (m_format.pixels == Pixels::Opaque) m_last.assign(row.begin(), row.end());
        return endStrip();
    }

    void beginStrip() {
        m_stripBegin = m_row - (m_last.empty() ? 0 : 1);
        m_stripEnd = std::min(m_format.height, m_stripBegin + rowsInStrip());
        PictureFormat format = withoutTexts(m_format);
        format.height = m_stripEnd - m_stripBegin;
        m_strip = std::make_unique<PngBytes>(format);
    }

    Failure endStrip() {
        if (const Failure failure = m_strip->writer().finish()) return failure;
        m_xml.writeEmptyElement(svgNamespace(), QStringLiteral("image"));
        const auto number = [&](const char* name, int value) {
            m_xml.writeAttribute(QLatin1String(name), QString::number(value));
        };
        number("x", 0);
        number("y", m_stripBegin);
        number("width", m_format.width);
        number("height", m_stripEnd - m_stripBegin);
        m_xml.writeAttribute(QStringLiteral("preserveAspectRatio"), QStringLiteral("none"));
        m_xml.writeAttribute(xlinkNamespace(), QStringLiteral("href"),
                             QLatin1String("data:image/png;base64,") +
                                 QLatin1String(m_strip->bytes().toBase64()));
        m_strip.reset();
        return written();
    }

    Failure end() override {
        if (!m_page.marks.empty()) {
            m_xml.writeStartElement(svgNamespace(), QStringLiteral("g"));
            m_xml.writeAttribute(QStringLiteral("id"), QStringLiteral("overlay"));
            writeSvgMarks(m_xml, m_page.marks);
            m_xml.writeEndElement();
        }
        m_xml.writeEndDocument();
        return written();
    }

    Failure written() const { return m_xml.hasError() ? Failure(m_device.errorString()) : std::nullopt; }

    const PicturePage m_page;
    QIODevice& m_device;
    QXmlStreamWriter m_xml;
    std::unique_ptr<PngBytes> m_strip;
    std::vector<std::uint32_t> m_last; // last row of the previous strip
    int m_row = 0, m_stripBegin = 0, m_stripEnd = 0;
};

// The compressed rows of a PNG, which PDF reads as they are.
QByteArray compressedRows(const QByteArray& png) {
    // Length of the signature; length, name and checksum of a chunk.
    constexpr qsizetype signature = 8, around = 12;
    QByteArray rows;
    for (qsizetype at = signature; at + around <= png.size();) {
        const qsizetype length = qFromBigEndian<quint32>(png.constData() + at);
        if (png.mid(at + 4, 4) == "IDAT") rows += png.mid(at + 8, length);
        at += length + around;
    }
    return rows;
}

// Colours and opacity are two pictures.
class PdfPicturePage final : public PagePictureWriter {
public:
    PdfPicturePage(OverlayMarks marks, PdfFile& file, const PictureFormat& format)
        : PagePictureWriter(format), m_marks(std::move(marks)), m_file(file), m_colours(coloursOf(format)) {
        if (format.pixels == Pixels::Transparent)
            m_opacities = std::make_unique<PngBytes>(opacitiesOf(format));
    }

private:
    static PictureFormat coloursOf(const PictureFormat& format) {
        PictureFormat colours = withoutTexts(format);
        colours.pixels = Pixels::Opaque;
        return colours;
    }
    static PictureFormat opacitiesOf(const PictureFormat& format) {
        PictureFormat grey = withoutTexts(format);
        grey.pixels = Pixels::Grey;
        grey.depth = Depth::Bits16;
        return grey;
    }

    Failure writeRow(Row row) override {
        if (!m_opacities) return m_colours.writer().writeRows(row);
        m_opaque.resize(row.size());
        m_alpha.resize(row.size());
        std::ranges::transform(row, m_opaque.begin(),
                               [](std::uint32_t pixel) { return 0xff000000 | qUnpremultiply(pixel); });
        std::ranges::transform(row, m_alpha.begin(),
                               [](std::uint32_t pixel) { return std::uint16_t(qAlpha(pixel) * 257); });
        if (const Failure failure = m_colours.writer().writeRows(m_opaque)) return failure;
        return m_opacities->writer().writeRows(std::span<const std::uint16_t>(m_alpha));
    }

    QByteArray dictionary(const char* space, int channels, int bits) const {
        const QByteArray width = QByteArray::number(m_format.width), depth = QByteArray::number(bits);
        return "/Type/XObject/Subtype/Image/Width " + width + "/Height " +
               QByteArray::number(m_format.height) + "/ColorSpace/" + space + "/BitsPerComponent " + depth +
               "/DecodeParms<</Predictor 15/Colors " + QByteArray::number(channels) + "/BitsPerComponent " +
               depth + "/Columns " + width + ">>";
    }

    Failure end() override {
        if (const Failure failure = m_colours.writer().finish()) return failure;
        QByteArray picture = dictionary("DeviceRGB", 3, 8);
        if (m_opacities) {
            if (const Failure failure = m_opacities->writer().finish()) return failure;
            const int mask =
                m_file.addCompressed(dictionary("DeviceGray", 1, 16), compressedRows(m_opacities->bytes()));
            picture += "/SMask " + pdfReference(mask);
        }
        addPage(m_file.addCompressed(picture, compressedRows(m_colours.bytes())));
        return std::nullopt;
    }

    void addPage(int image) {
        const double points = 72 / dotsPerInch(); // points per pixel
        const QByteArray width = QByteArray::number(m_format.width);
        const QByteArray height = QByteArray::number(m_format.height);
        const int content =
            m_file.addStream({}, pdfNumber(points) + " 0 0 " + pdfNumber(-points) + " 0 " +
                                     pdfNumber(points * m_format.height) + " cm\nq " + width + " 0 0 -" +
                                     height + " 0 " + height + " cm /Picture Do Q\n" + pdfMarks(m_marks));
        m_file.addPage("/MediaBox[0 0 " + pdfNumber(points * m_format.width) + ' ' +
                       pdfNumber(points * m_format.height) + "]/Resources<</XObject<</Picture " +
                       pdfReference(image) + ">>" + pdfMarkResources(m_marks) + ">>/Contents " +
                       pdfReference(content));
    }

    const OverlayMarks m_marks;
    PdfFile& m_file;
    PngBytes m_colours;
    std::unique_ptr<PngBytes> m_opacities; // null: opaque
    std::vector<std::uint32_t> m_opaque;
    std::vector<std::uint16_t> m_alpha;
};

// A file of one page.
class PdfDocument final : public PagePictureWriter {
public:
    PdfDocument(PicturePage page, QIODevice& device, const PictureFormat& format)
        : PagePictureWriter(format),
          m_title(std::move(page.title)),
          m_device(device),
          m_page(std::move(page.marks), m_file, format) {}

private:
    Failure writeRow(Row row) override { return m_page.writeRows(row); }
    Failure end() override {
        if (const Failure failure = m_page.finish()) return failure;
        const QByteArray bytes = m_file.bytes(m_title);
        return m_device.write(bytes) == bytes.size() ? std::nullopt : Failure(m_device.errorString());
    }

    const QString m_title;
    QIODevice& m_device;
    PdfFile m_file;
    PdfPicturePage m_page;
};

} // namespace

std::unique_ptr<PictureWriter> pageWriter(PicturePage page, QIODevice& device, const PictureFormat& format) {
    if (page.file == ShapeFile::Pdf) return std::make_unique<PdfDocument>(std::move(page), device, format);
    return std::make_unique<SvgPage>(std::move(page), device, format);
}

std::unique_ptr<PictureWriter> pageWriter(OverlayMarks marks, PdfFile& file, const PictureFormat& format) {
    return std::make_unique<PdfPicturePage>(std::move(marks), file, format);
}

ShapeFileTitles titlesOf(ShapeFile file) {
    if (file == ShapeFile::Pdf)
        return {QT_TRANSLATE_NOOP("Text", "PDF: shapes for print"),
                QT_TRANSLATE_NOOP("Text", "PDF: a page with the picture")};
    return {QT_TRANSLATE_NOOP("Text", "SVG: shapes for drawing programs"),
            QT_TRANSLATE_NOOP("Text", "SVG: a page with the picture")};
}

} // namespace io
