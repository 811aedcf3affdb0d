// SPDX-License-Identifier: MIT
#include "io/overlay/map_legend.h"

#include "document/fractal/space_geometry.h"
#include "document/text/text.h"

#include <QFont>
#include <QFontMetrics>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <vector>

namespace io {

namespace {

QFont font(int pixels, QFont::Weight weight = QFont::Normal) {
    QFont font;
    font.setFamilies({QStringLiteral("Inter"), QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans")});
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(pixels);
    font.setWeight(weight);
    return font;
}

// A number to four digits, with the minus of mathematics.
QString shown(double number) {
    constexpr int digits = 4;
    return QString::number(number == 0 ? 0.0 : number, 'g', digits).replace(u'-', QChar(0x2212));
}

struct Row {
    QColor colour;
    QStringList cells;
};

template <int Dim>
std::vector<Row> rowsOf(const ifs::IteratedFunctionSystem<Dim>& system, const document::Fractal& fractal,
                        std::size_t limit) {
    const std::vector<double> probabilities = ifs::probabilities(system);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < std::min(limit, system.maps.size()); ++i) {
        const auto& [linear, translation] = system.maps[i].map;
        const attractor::Rgba colour = mapColour(fractal.appearance, system.maps[i].id, i);
        Row row{QColor(colour.red, colour.green, colour.blue), {QString::number(i + 1)}};
        for (int k = 0; k < Dim * Dim; ++k)
            row.cells << shown(linear(k / Dim, k % Dim));
        for (int k = 0; k < Dim; ++k)
            row.cells << shown(translation[k]);
        row.cells << shown(probabilities[i]);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<Row> rowsOf(const document::Fractal& fractal, std::size_t limit) {
    if (const document::System3* system = document::system3(fractal)) return rowsOf(*system, fractal, limit);
    return rowsOf(*document::system2(fractal), fractal, limit);
}

std::size_t mapCount(const document::Fractal& fractal) {
    if (const document::System3* system = document::system3(fractal)) return system->maps.size();
    return document::system2(fractal)->maps.size();
}

// The letters of the formats of code for the numbers of a map.
QStringList titlesOf(const document::Fractal& fractal) {
    QStringList titles{QString()};
    for (char letter = 'a'; letter <= (dimension(fractal) == 3 ? 'l' : 'f'); ++letter)
        titles << QChar::fromLatin1(letter);
    return titles << QStringLiteral("p");
}

// Painter of a legend whose measures all follow from the size of the letters.
class LegendPainter {
public:
    LegendPainter(const document::Fractal& fractal, int height)
        : m_height(height),
          m_pixels(std::clamp(height / 42, 7, 64)),
          m_usual(font(m_pixels)),
          m_bold(font(m_pixels, QFont::DemiBold)),
          m_name(fractal.name),
          m_titles(titlesOf(fractal)) {
        const attractor::Rgba background =
            dimension(fractal) == 3 ? document::backgroundInSpace(fractal) : fractal.appearance.background;
        m_paper = background.alpha == 255 ? QColor(background.red, background.green, background.blue)
                                          : QColor(Qt::white);
        const bool onDark = qGray(m_paper.rgb()) < 128;
        m_ink = onDark ? QColor(232, 234, 237) : QColor(31, 35, 40);
        m_quiet = onDark ? QColor(154, 163, 175) : QColor(98, 106, 115);
        const std::size_t all = mapCount(fractal);
        const int room = std::max(0, (height - 2 * margin() - heading()) / line() - 1);
        const bool isCut = all > std::size_t(room);
        m_rows = rowsOf(fractal, isCut ? std::size_t(std::max(0, room - 1)) : all);
        if (isCut) m_more = Text::tr("… and %1 more").arg(all - m_rows.size());
        for (qsizetype i = 0; i < m_titles.size(); ++i)
            m_widths << widthOf(i);
    }

    QImage painted() {
        QImage image(width(), m_height, QImage::Format_ARGB32_Premultiplied);
        image.fill(m_paper);
        QPainter painter(&image);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
        painter.setFont(font(m_pixels * 3 / 2, QFont::DemiBold));
        painter.setPen(m_ink);
        const QRect name(margin(), margin(), image.width() - 2 * margin(), heading());
        painter.drawText(name, int(Qt::AlignLeft | Qt::AlignTop) | Qt::TextSingleLine,
                         QFontMetrics(painter.font()).elidedText(m_name, Qt::ElideMiddle, name.width()));
        int y = margin() + heading();
        paintRow(painter, y, m_titles, m_bold, m_quiet);
        for (const Row& row : m_rows) {
            y += line();
            paintRow(painter, y, row.cells, m_usual, m_ink);
            painter.fillRect(QRect(margin(), y + line() / 4, swatch(), line() / 2), row.colour);
        }
        painter.setFont(m_usual);
        painter.setPen(m_quiet);
        painter.drawText(margin(), y + line() + QFontMetrics(m_usual).ascent() + line() / 5, m_more);
        return image;
    }

private:
    int margin() const { return 2 * m_pixels; }
    int heading() const { return 3 * m_pixels; }
    int line() const { return m_pixels * 8 / 5; }
    int gap() const { return m_pixels; }
    int swatch() const { return m_pixels; }
    int width() const {
        int all = 2 * margin() + swatch();
        for (const int width : m_widths)
            all += gap() + width;
        return std::max(all, 2 * margin() + QFontMetrics(m_usual).horizontalAdvance(m_more));
    }
    int widthOf(qsizetype column) const {
        int widest = QFontMetrics(m_bold).horizontalAdvance(m_titles[column]);
        for (const Row& row : m_rows)
            widest = std::max(widest, QFontMetrics(m_usual).horizontalAdvance(row.cells[column]));
        return widest;
    }
    void paintRow(QPainter& painter, int y, const QStringList& cells, const QFont& letters,
                  const QColor& ink) const {
        painter.setFont(letters);
        painter.setPen(ink);
        int x = margin() + swatch();
        for (qsizetype i = 0; i < cells.size(); ++i) {
            x += gap();
            painter.drawText(QRect(x, y, m_widths[i], line()), int(Qt::AlignRight | Qt::AlignVCenter),
                             cells[i]);
            x += m_widths[i];
        }
    }

    int m_height, m_pixels;
    QFont m_usual, m_bold;
    QString m_name, m_more;
    QColor m_paper, m_ink, m_quiet;
    const QStringList m_titles;
    std::vector<Row> m_rows;
    QList<int> m_widths;
};

} // namespace

QImage mapLegend(const document::Fractal& fractal, int height) {
    return LegendPainter(fractal, height).painted();
}

} // namespace io
