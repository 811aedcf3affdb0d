// SPDX-License-Identifier: MIT
#include "io/picture/contact_sheet.h"
#include "attractor/render/renderer.h"
#include "document/fractal_geometry.h"

#include <QCoreApplication>
#include <QFont>
#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

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

// Every measure follows from the tile.
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

class SheetPainter {
public:
    SheetPainter(const ContactSheet& sheet, QImage& image)
        : m_sheet(sheet), m_layout(sheet), m_inks(inksOf(sheet.paper)), m_painter(&image) {
        m_painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
        for (const auto& section : sheet.sections)
            m_count += section.fractals.size();
    }

    // False when stopped.
    bool paint(const Progress& progress, const std::stop_token& stop) {
        m_painter.fillRect(QRect(QPoint(), sizeOf(m_sheet)), m_inks.paper);
        int y = m_layout.margin;
        if (!m_sheet.title.isEmpty()) y = paintTitle(y);
        qsizetype done = 0;
        for (const auto& section : m_sheet.sections) {
            if (section.fractals.isEmpty()) continue;
            if (!section.title.isEmpty()) y = paintHeading(section, y);
            for (qsizetype i = 0; i < section.fractals.size(); ++i) {
                const QPoint corner(m_layout.margin +
                                        int(i % m_layout.columns) * (m_layout.tile.width() + m_layout.gap),
                                    y + int(i / m_layout.columns) * m_layout.row());
                paintTile(*section.fractals[i], QRect(corner, m_layout.tile), stop);
                if (stop.stop_requested()) return false;
                if (progress) progress(double(++done) / double(m_count));
            }
            y += m_layout.rowsFor(section.fractals.size()) * m_layout.row();
        }
        return true;
    }

private:
    int paintTitle(int y) {
        const QRect line(m_layout.margin, y, m_layout.width() - 2 * m_layout.margin, m_layout.title);
        paintText(line, Qt::AlignLeft | Qt::AlignTop, font(2 * m_layout.text, QFont::DemiBold), m_inks.text,
                  m_sheet.title);
        return y + m_layout.title;
    }

    int paintHeading(const ContactSheet::Section& section, int y) {
        const QRect line(m_layout.margin, y, m_layout.width() - 2 * m_layout.margin,
                         m_layout.heading - m_layout.gap);
        const QFont bold = font(1.35 * m_layout.text, QFont::DemiBold);
        paintText(line, Qt::AlignLeft | Qt::AlignVCenter, bold, m_inks.text, section.title);
        paintText(line, Qt::AlignRight | Qt::AlignVCenter, font(m_layout.text), m_inks.quiet,
                  QString::number(section.fractals.size()));
        m_painter.setPen(QPen(m_inks.line, std::max(1.0, m_layout.text / 12)));
        m_painter.drawLine(line.bottomLeft(), line.bottomRight());
        return y + m_layout.heading;
    }

    void paintText(const QRect& area, Qt::Alignment alignment, const QFont& font, const QColor& ink,
                   const QString& text) {
        m_painter.setFont(font);
        m_painter.setPen(ink);
        const QString shown = QFontMetrics(font).elidedText(text, Qt::ElideMiddle, area.width());
        m_painter.drawText(area, int(alignment) | Qt::TextSingleLine, shown);
    }

    void paintTile(const document::Fractal& fractal, const QRect& area, const std::stop_token& stop) {
        const QImage picture = drawn(fractal, stop);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(m_inks.placeholder);
        const double radius = m_layout.text / 2.5;
        QPainterPath card;
        card.addRoundedRect(area, radius, radius);
        if (picture.isNull()) {
            m_painter.drawPath(card);
            paintText(area, Qt::AlignCenter, font(m_layout.text), m_inks.quiet,
                      document::dimension(fractal) == 3 ? Text::tr("in space") : Text::tr("no attractor"));
        } else {
            m_painter.setBrushOrigin(area.topLeft());
            m_painter.fillPath(card, picture);
            m_painter.setBrushOrigin(QPoint());
        }
        const QRect label(area.left(), area.bottom() + 1, area.width(), m_layout.label);
        paintText(label, Qt::AlignHCenter | Qt::AlignVCenter, font(m_layout.text), m_inks.text, fractal.name);
    }

    // Null when there is nothing to draw.
    QImage drawn(const document::Fractal& fractal, const std::stop_token& stop) const {
        constexpr double margin = 0.06;
        if (!document::system2(fractal)) return {};
        const auto box = document::displayedBox(fractal);
        if (!box) return {};
        attractor::Camera camera;
        camera.width = m_layout.tile.width();
        camera.height = m_layout.tile.height();
        camera = attractor::fitted(camera, box->min, box->max, margin);
        attractor::RenderRequest request = document::renderRequest(fractal, camera);
        request.threads = m_sheet.threads;
        request.samples = std::uint64_t(camera.width) * std::uint64_t(camera.height) *
                          std::uint64_t(m_sheet.samplesPerPixel);
        attractor::Rendering rendering(request);
        if (!rendering.refine(stop)) return {};
        const attractor::Frame frame = rendering.frame();
        return QImage(reinterpret_cast<const uchar*>(frame.pixels.data()), camera.width, camera.height,
                      QImage::Format_ARGB32_Premultiplied)
            .copy();
    }

    const ContactSheet& m_sheet;
    Layout m_layout;
    Inks m_inks;
    QPainter m_painter;
    qsizetype m_count = 0;
};

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

DrawnSheet drawSheet(const ContactSheet& sheet, const Progress& progress, const std::stop_token& stop) {
    constexpr int maxSide = 32'767; // that can be painted on
    const QSize size = sizeOf(sheet);
    DrawnSheet drawn;
    if (size.width() <= maxSide && size.height() <= maxSide) drawn.image = QImage(size, QImage::Format_RGB32);
    if (drawn.image.isNull()) {
        drawn.failure = Text::tr("The sheet would have %1 by %2 pixels; the limit is %3 per side. Use "
                                 "smaller tiles or another number of columns.")
                            .arg(size.width())
                            .arg(size.height())
                            .arg(maxSide);
        return drawn;
    }
    const bool whole = SheetPainter(sheet, drawn.image).paint(progress, stop);
    if (!whole) drawn.image = {};
    return drawn;
}

} // namespace io
