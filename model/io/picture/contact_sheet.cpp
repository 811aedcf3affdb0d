// SPDX-License-Identifier: MIT
#include "io/picture/contact_sheet.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/text/text.h"
#include "io/picture/picture_writers.h"
#include "io/picture/space_export.h"

#include <QBuffer>
#include <QFont>
#include <QFontMetrics>
#include <QHashFunctions>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>

#include <algorithm>
#include <cmath>
#include <new>
#include <span>
#include <vector>

namespace io {

namespace {

struct Inks {
    QColor paper, text, quiet, line, placeholder;
};

Inks inksOf(ContactSheet::Paper paper) {
    if (paper == ContactSheet::Paper::Light)
        return {QColor(0xfa, 0xf9, 0xf6), QColor(0x1f, 0x23, 0x28), QColor(0x62, 0x6a, 0x73),
                QColor(0xdc, 0xd9, 0xd2), QColor(0xec, 0xea, 0xe4)};
    return {QColor(0x0d, 0x10, 0x17), QColor(0xe8, 0xea, 0xed), QColor(0x9a, 0xa3, 0xaf),
            QColor(0x2a, 0x30, 0x3a), QColor(0x16, 0x1a, 0x22)};
}

QFont font(double pixels, QFont::Weight weight = QFont::Normal) {
    QFont font;
    font.setFamilies({QStringLiteral("Inter"), QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans")});
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(std::max(6, int(std::lround(pixels))));
    font.setWeight(weight);
    return font;
}

// Layout of a sheet, in which every measure follows from the tile.
struct Layout {
    explicit Layout(const ContactSheet& sheet) : tile(sheet.tile) {
        const double module = std::sqrt(double(tile.width()) * tile.height()) / 12;
        text = std::clamp(0.62 * module, 9.0, 40.0);
        gap = int(std::lround(std::max(6.0, 0.8 * module)));
        margin = 2 * gap;
        label = int(std::lround(2.2 * text));
        heading = int(std::lround(3.6 * text));
        title = int(std::lround(5 * text));
        columns = sheet.columns;
        if (columns == 0) columns = naturalColumns(sheet);
    }

    int row() const { return tile.height() + label + gap; }
    int width() const { return 2 * margin + columns * tile.width() + (columns - 1) * gap; }
    int rowsFor(qsizetype fractals) const { return int((fractals + columns - 1) / columns); }

    QSize tile;
    double text = 12;
    int gap = 0, margin = 0, label = 0, heading = 0, title = 0, columns = 1;

private:
    int naturalColumns(const ContactSheet& sheet) const {
        constexpr double widthToHeight = 1.5;
        qsizetype all = 0;
        qsizetype largest = 0;
        for (const auto& section : sheet.sections) {
            all += section.fractals.size();
            largest = std::max(largest, section.fractals.size());
        }
        constexpr int screen = 1920; // pixels
        const int fitting = std::max(1, (screen - 2 * margin + gap) / (tile.width() + gap));
        const double square = std::sqrt(widthToHeight * double(all) * row() / (tile.width() + gap));
        return std::clamp(int(std::lround(square)), 1, std::min(fitting, std::max(1, int(largest))));
    }
};

// A part of the sheet over its whole width.
struct Band {
    enum class Kind { Space, Title, Heading, Row } kind = Kind::Space;
    int height = 0;
    const ContactSheet::Section* section = nullptr;
    qsizetype first = 0; // index of the first fractal of a row
};

std::vector<Band> bandsOf(const ContactSheet& sheet, const Layout& layout) {
    using enum Band::Kind;
    std::vector<Band> bands{{Space, layout.margin, nullptr, 0}};
    if (!sheet.title.isEmpty()) bands.push_back({Title, layout.title, nullptr, 0});
    for (const auto& section : sheet.sections) {
        if (section.fractals.isEmpty()) continue;
        if (!section.title.isEmpty()) bands.push_back({Heading, layout.heading, &section, 0});
        for (qsizetype first = 0; first < section.fractals.size(); first += layout.columns)
            bands.push_back({Row, layout.row(), &section, first});
    }
    bands.push_back({Space, layout.margin - layout.gap, nullptr, 0});
    return bands;
}

class SheetPainter {
public:
    SheetPainter(const ContactSheet& sheet, const Progress& progress, const std::stop_token& stop)
        : m_sheet(sheet), m_layout(sheet), m_inks(inksOf(sheet.paper)), m_progress(progress), m_stop(stop) {
        for (const auto& section : sheet.sections)
            m_count += section.fractals.size();
    }

    const Layout& layout() const { return m_layout; }
    QColor paper() const { return m_inks.paper; }

    // Paints with the upper left corner of the band at the origin. Returns false if stopped.
    bool paint(QPainter& painter, const Band& band) {
        m_painter = &painter;
        painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
        if (band.kind == Band::Kind::Title) paintTitle();
        if (band.kind == Band::Kind::Heading) paintHeading(*band.section);
        if (band.kind != Band::Kind::Row) return true;
        const auto& fractals = band.section->fractals;
        const qsizetype end = std::min(fractals.size(), band.first + m_layout.columns);
        for (qsizetype i = band.first; i < end; ++i) {
            const int column = int(i - band.first);
            const QPoint corner(m_layout.margin + column * (m_layout.tile.width() + m_layout.gap), 0);
            paintTile(*fractals[i], QRect(corner, m_layout.tile));
            if (m_stop.stop_requested()) return false;
            if (m_progress) m_progress(double(++m_done) / double(m_count));
        }
        return true;
    }

private:
    void paintTitle() {
        const QRect line(m_layout.margin, 0, m_layout.width() - 2 * m_layout.margin, m_layout.title);
        paintText(line, Qt::AlignLeft | Qt::AlignTop, font(2 * m_layout.text, QFont::DemiBold), m_inks.text,
                  m_sheet.title);
    }

    void paintHeading(const ContactSheet::Section& section) {
        const QRect line(m_layout.margin, 0, m_layout.width() - 2 * m_layout.margin,
                         m_layout.heading - m_layout.gap);
        const QFont bold = font(1.35 * m_layout.text, QFont::DemiBold);
        paintText(line, Qt::AlignLeft | Qt::AlignVCenter, bold, m_inks.text, section.title);
        paintText(line, Qt::AlignRight | Qt::AlignVCenter, font(m_layout.text), m_inks.quiet,
                  QString::number(section.fractals.size()));
        m_painter->setPen(QPen(m_inks.line, std::max(1.0, m_layout.text / 12)));
        m_painter->drawLine(line.bottomLeft(), line.bottomRight());
    }

    void paintText(const QRect& area, Qt::Alignment alignment, const QFont& font, const QColor& ink,
                   const QString& text) {
        m_painter->setFont(font);
        m_painter->setPen(ink);
        const QString shown = QFontMetrics(font).elidedText(text, Qt::ElideMiddle, area.width());
        m_painter->drawText(area, int(alignment) | Qt::TextSingleLine, shown);
    }

    void paintTile(const document::Fractal& fractal, const QRect& area) {
        const QImage picture = drawn(fractal);
        m_painter->setPen(Qt::NoPen);
        m_painter->setBrush(m_inks.placeholder);
        const double radius = m_layout.text / 2.5;
        QPainterPath card;
        card.addRoundedRect(area, radius, radius);
        if (picture.isNull()) {
            m_painter->drawPath(card);
            paintText(area, Qt::AlignCenter, font(m_layout.text), m_inks.quiet, Text::tr("no attractor"));
        } else {
            m_painter->save();
            m_painter->setClipPath(card);
            m_painter->drawImage(area, picture);
            m_painter->restore();
        }
        const QRect label(area.left(), area.bottom() + 1, area.width(), m_layout.label);
        paintText(label, Qt::AlignHCenter | Qt::AlignVCenter, font(m_layout.text), m_inks.text, fractal.name);
    }

    // Returns null if there is nothing to draw.
    QImage drawn(const document::Fractal& fractal) const {
        if (document::space(fractal)) return drawnInSpace(fractal);
        constexpr std::size_t cells = 64U << 20; // bytes
        if (!document::system2(fractal)) return {};
        const auto box = document::boxWithShadow(fractal, attractor::YAxis::Up);
        if (!box) return {};
        attractor::Camera camera;
        camera.width = m_layout.tile.width();
        camera.height = m_layout.tile.height();
        camera = attractor::fitted(camera, box->min, box->max, margin);
        PlaneExport picture{fractal, document::renderRequest(fractal, camera), {}};
        picture.bandBytes = cells;
        picture.request.threads = m_sheet.threads;
        picture.request.samples = samples();
        return drawPicture(picture, {}, m_stop).image;
    }

    // Same picture as that of `render` without options.
    QImage drawnInSpace(const document::Fractal& fractal) const {
        constexpr double azimuth = 30, elevation = 20;
        if (!document::spaceSupport(fractal)) return {};
        attractor::OrbitCamera camera;
        camera.size = {m_layout.tile.width(), m_layout.tile.height()};
        camera.orientation = attractor::orbit(azimuth, elevation);
        SpaceExport picture;
        picture.fractal = fractal;
        picture.look = fractal.inSpace.look;
        picture.solid = document::solidAppearance(fractal);
        picture.request = document::spaceRequest(fractal, document::fittedToPicture(fractal, camera, margin));
        picture.request.threads = m_sheet.threads;
        picture.request.samples = samples();
        return drawSpacePicture(picture, {}, m_stop).image;
    }

    std::uint64_t samples() const {
        return std::uint64_t(m_layout.tile.width()) * std::uint64_t(m_layout.tile.height()) *
               std::uint64_t(m_sheet.samplesPerPixel);
    }

    static constexpr double margin = 0.06; // share of a tile around the picture

    const ContactSheet& m_sheet;
    Layout m_layout;
    Inks m_inks;
    const Progress& m_progress;
    const std::stop_token& m_stop;
    QPainter* m_painter = nullptr; // painter of the current band
    qsizetype m_count = 0, m_done = 0;
};

PictureFormat formatOf(const ContactSheet& sheet) {
    PictureFormat format;
    const QSize size = sizeOf(sheet);
    format.width = size.width();
    format.height = size.height();
    return format;
}

// Writes each band as an image of its own. False when stopped.
bool writeBands(const ContactSheet& sheet, PictureWriter& writer, SheetPainter& sheetPainter,
                ExportOutcome& outcome) {
    for (const Band& band : bandsOf(sheet, sheetPainter.layout())) {
        if (band.height <= 0) continue;
        QImage image(sheetPainter.layout().width(), band.height, QImage::Format_ARGB32_Premultiplied);
        if (image.isNull()) throw std::bad_alloc();
        image.fill(sheetPainter.paper());
        QPainter painter(&image);
        if (!sheetPainter.paint(painter, band)) return false;
        painter.end();
        const auto pixels = std::size_t(image.width()) * std::size_t(image.height());
        outcome.failure =
            writer.writeRows(std::span(reinterpret_cast<const std::uint32_t*>(image.constBits()), pixels));
        if (outcome.failure) return true;
    }
    outcome.failure = writer.finish();
    return true;
}

// Bands that stay together on a page: headings go with the band below.
std::vector<std::vector<Band>> blocksOf(const std::vector<Band>& bands) {
    std::vector<std::vector<Band>> blocks(1);
    for (const Band& band : bands) {
        if (band.kind == Band::Kind::Space) continue;
        blocks.back().push_back(band);
        if (band.kind == Band::Kind::Row) blocks.emplace_back();
    }
    return blocks;
}

int heightOf(const std::vector<Band>& block) {
    int height = 0;
    for (const Band& band : block)
        height += band.height;
    return height;
}

// Tables with a seed that changes would put the parts of the file into another order each time.
class SteadyOrder {
public:
    SteadyOrder() { QHashSeed::setDeterministicGlobalSeed(); }
    ~SteadyOrder() { QHashSeed::resetRandomGlobalSeed(); }
    SteadyOrder(const SteadyOrder&) = delete;
    SteadyOrder& operator=(const SteadyOrder&) = delete;
};

// The day and the hour would make every file another one.
void forgetTime(QByteArray& pdf) {
    const qsizetype at = pdf.indexOf("/CreationDate");
    const qsizetype end = at < 0 ? -1 : pdf.indexOf('\n', at);
    if (end > at) std::fill(pdf.begin() + at, pdf.begin() + end, ' ');
}

} // namespace

QSize sizeOf(const ContactSheet& sheet) {
    const Layout layout(sheet);
    int height = 2 * layout.margin - layout.gap + (sheet.title.isEmpty() ? 0 : layout.title);
    for (const auto& section : sheet.sections)
        if (!section.fractals.isEmpty())
            height += (section.title.isEmpty() ? 0 : layout.heading) +
                      layout.rowsFor(section.fractals.size()) * layout.row();
    return {layout.width(), height};
}

Failure whyImpossible(const ContactSheet& sheet, PictureFile file) {
    constexpr int maxWidth = 32'767; // limit of QPainter
    const PictureFormat format = formatOf(sheet);
    if (format.width > maxWidth)
        return Text::tr("The sheet would have %1 by %2 pixels; the limit is %3 pixels in width. Use smaller "
                        "tiles or fewer columns.")
            .arg(format.width)
            .arg(format.height)
            .arg(maxWidth);
    return whyImpossible(file, format);
}

ExportOutcome exportSheet(const ContactSheet& sheet, PictureFile file, const QString& path,
                          const Progress& progress, const std::stop_token& stop) {
    return writtenWhole(path, whyImpossible(sheet, file), [&](QIODevice& device) {
        ExportOutcome outcome;
        SheetPainter painter(sheet, progress, stop);
        const auto writer = pictureWriter(file, device, formatOf(sheet));
        outcome.stopped = !writeBands(sheet, *writer, painter, outcome);
        return outcome;
    });
}

ExportOutcome exportSheetPdf(const ContactSheet& sheet, const QPageSize& page, const QString& path,
                             const Progress& progress, const std::stop_token& stop) {
    ExportOutcome outcome;
    const SteadyOrder steady;
    SheetPainter sheetPainter(sheet, progress, stop);
    const Layout& layout = sheetPainter.layout();
    QBuffer pdf;
    pdf.open(QIODevice::WriteOnly);
    QPdfWriter writer(&pdf);
    writer.setTitle(sheet.title);
    writer.setCreator(QStringLiteral("Barycage"));
    writer.setPageSize(page);
    writer.setPageMargins({});
    QPainter painter(&writer);
    const double scale = double(writer.width()) / layout.width();
    const double pageHeight = writer.height() / scale;
    double y = pageHeight; // beyond the page, to begin a new one
    bool isFirst = true;
    for (const std::vector<Band>& block : blocksOf(bandsOf(sheet, layout))) {
        if (block.empty()) continue;
        if (y + heightOf(block) > pageHeight - layout.margin) {
            if (!isFirst) writer.newPage();
            isFirst = false;
            painter.resetTransform();
            painter.scale(scale, scale);
            painter.fillRect(QRectF(0, 0, layout.width(), pageHeight), sheetPainter.paper());
            y = layout.margin;
        }
        for (const Band& band : block) {
            painter.save();
            painter.translate(0, y);
            outcome.stopped = !sheetPainter.paint(painter, band);
            painter.restore();
            if (outcome.stopped) return outcome;
            y += band.height;
        }
    }
    painter.end();
    QByteArray bytes = pdf.data();
    forgetTime(bytes);
    outcome.failure = saveFile(path, bytes);
    return outcome;
}

} // namespace io
