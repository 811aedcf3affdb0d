// SPDX-License-Identifier: MIT
#include "dialogs/export/handout_page.h"

#include "canvas/geometry/grid_spacing.h"
#include "dialogs/export/printed_parts.h"
#include "document/fractal_geometry.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

constexpr int maxRows = 12;        // of an empty table
constexpr double gridLines = 900;  // the grid is as dense as on a canvas of so many pixels
constexpr double cageMargin = 0.3; // of the cage's size, around it on the grid

QString subscript(std::size_t number) {
    static const QString digits = QStringLiteral("₀₁₂₃₄₅₆₇₈₉");
    QString text;
    for (const QChar digit : QString::number(number))
        text += digits[digit.digitValue()];
    return text;
}

QString digitsOf(double value) {
    return QString::number(value, 'g', 4).replace(u'-', QChar(0x2212));
}

bool isSeen(double value) {
    return std::abs(value) >= 5e-5;
}

// "0.5x − 0.25y + 1"
QString sumText(double x, double y, double constant) {
    QString text;
    const auto add = [&](double factor, const QString& variable) {
        if (!isSeen(factor)) return;
        const double size = std::abs(factor);
        if (text.isEmpty())
            text += factor < 0 ? QString(QChar(0x2212)) : QString();
        else
            text += factor < 0 ? QStringLiteral(" − ") : QStringLiteral(" + ");
        if (variable.isEmpty() || std::abs(size - 1) > 5e-5) text += digitsOf(size);
        text += variable;
    };
    add(x, QStringLiteral("x"));
    add(y, QStringLiteral("y"));
    add(constant, {});
    return text.isEmpty() ? QStringLiteral("0") : text;
}

// One entry in its part of a page. All lengths follow from `line`, the height of a line of text.
class CellPainter {
public:
    CellPainter(QPainter& painter, const QRectF& cell, double line, const HandoutOptions& options)
        : m_painter(painter), m_cell(cell), m_line(line), m_options(options) {}

    void paint(const HandoutItem& item) {
        setFont(0.8, true);
        m_painter.setPen(Qt::black);
        const QRectF heading(m_cell.left(), m_cell.top(), m_cell.width(), 1.2 * m_line);
        m_painter.drawText(
            heading, Qt::AlignLeft | Qt::AlignVCenter,
            QFontMetricsF(m_painter.font()).elidedText(item.fractal->name, Qt::ElideRight, heading.width()));
        const QRectF rest = m_cell.adjusted(0, 1.5 * m_line, 0, 0);
        const bool isTask = m_options.kind == HandoutOptions::Kind::TaskSheet;
        const bool hasText = isTask || m_options.hasFormulas;
        auto [picture, text] = divided(rest, hasText);
        if (isTask) {
            paintGrid(picture, *item.fractal);
            paintEmptyTable(text, *item.fractal);
            return;
        }
        QSizeF size = item.picture.size();
        size.scale(picture.size(), Qt::KeepAspectRatio);
        const QPointF corner(picture.left() + (picture.width() - size.width()) / 2, picture.top());
        m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
        m_painter.drawImage(QRectF(corner, size), item.picture);
        // Below a picture that is flat there is more room.
        if (text.top() >= picture.bottom()) text.setTop(corner.y() + size.height() + 0.7 * m_line);
        if (hasText) paintFormulas(text, *item.fractal);
    }

private:
    void setFont(double share, bool bold = false) {
        m_painter.setFont(printedFont(m_painter, share * m_line, bold));
    }

    // For the picture and for the text.
    std::pair<QRectF, QRectF> divided(const QRectF& room, bool hasText) const {
        if (!hasText) return {room, QRectF()};
        const double gap = m_line;
        if (room.width() > 1.15 * room.height()) {
            const double side = std::min(room.height(), 0.5 * room.width());
            return {QRectF(room.topLeft(), QSizeF(side, room.height())), room.adjusted(side + gap, 0, 0, 0)};
        }
        const double height = std::min(room.width(), 0.6 * room.height());
        return {QRectF(room.topLeft(), QSizeF(room.width(), height)), room.adjusted(0, height + gap, 0, 0)};
    }

    void paintFormulas(const QRectF& room, const document::Fractal& fractal) {
        const auto displayed = document::effectiveSystem(fractal);
        const document::System2& system = displayed ? *displayed : *document::system2(fractal);
        const std::vector<double> shares = ifs::probabilities(system);
        QStringList lines;
        for (std::size_t i = 0; i < system.maps.size(); ++i)
            if (shares[i] > 0)
                lines << formulaText(system.maps[i].map, i + 1) +
                             QStringLiteral("   p%1 = %2").arg(subscript(i + 1), digitsOf(shares[i]));
        const double height = 1.15 * m_line;
        const auto fit = qsizetype(std::max(0.0, room.height() / height));
        if (lines.size() > fit) {
            const qsizetype more = lines.size() - std::max<qsizetype>(0, fit - 1);
            lines = lines.first(lines.size() - more);
            lines << Text::tr("%n more maps", nullptr, int(more));
        }
        setFont(0.72);
        double widest = 1;
        for (const QString& line : std::as_const(lines))
            widest = std::max(widest, QFontMetricsF(m_painter.font()).horizontalAdvance(line));
        constexpr double minScale = 0.6;
        setFont(0.72 * std::clamp(room.width() / widest, minScale, 1.0));
        const QFontMetricsF metrics(m_painter.font());
        for (qsizetype k = 0; k < lines.size(); ++k)
            m_painter.drawText(QRectF(room.left(), room.top() + double(k) * height, room.width(), height),
                               Qt::AlignLeft | Qt::AlignVCenter,
                               metrics.elidedText(lines[k], Qt::ElideRight, room.width()));
    }

    // The cage as it is displayed, with its corners named, on a grid with the numbers of its lines.
    void paintGrid(const QRectF& whole, const document::Fractal& fractal) {
        const std::vector<ifs::Vector<2>> cage = document::effectiveCage(fractal).current;
        ifs::Vector<2> low = cage.front(), high = cage.front();
        for (const ifs::Vector<2>& corner : cage) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
        const double extent = (high - low).maxCoeff() > 0 ? (high - low).maxCoeff() : 1;
        const QRectF room = whole.adjusted(1.6 * m_line, 0, 0, -m_line); // beside the numbers
        const ifs::Vector<2> size = high - low + ifs::Vector<2>::Constant(2 * cageMargin * extent);
        const double scale = std::min(room.width() / size.x(), room.height() / size.y());
        if (!(scale > 0) || !std::isfinite(scale)) return;
        const ifs::Vector<2> middle = (low + high) / 2;
        const auto onPage = [&](const ifs::Vector<2>& x) {
            return QPointF(room.center().x() + (x.x() - middle.x()) * scale,
                           room.center().y() - (x.y() - middle.y()) * scale);
        };
        const GridSpacing spacing = gridSpacing(scale * gridLines / std::max(room.width(), room.height()));
        paintLines(room, middle, scale, spacing);
        QPolygonF polygon;
        for (const ifs::Vector<2>& corner : cage)
            polygon << onPage(corner);
        m_painter.setPen(QPen(Qt::black, 0.09 * m_line));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawPolygon(polygon);
        setFont(0.7, true);
        for (qsizetype k = 0; k < polygon.size(); ++k) {
            m_painter.setPen(Qt::NoPen);
            m_painter.setBrush(Qt::white);
            m_painter.drawEllipse(polygon[k], 0.55 * m_line, 0.55 * m_line);
            m_painter.setPen(QPen(Qt::black, 0.06 * m_line));
            m_painter.drawEllipse(polygon[k], 0.5 * m_line, 0.5 * m_line);
            m_painter.drawText(QRectF(polygon[k] - QPointF(m_line, m_line), QSizeF(2 * m_line, 2 * m_line)),
                               Qt::AlignCenter, QString::number(k + 1));
        }
    }

    void paintLines(const QRectF& room, const ifs::Vector<2>& middle, double scale,
                    const GridSpacing& spacing) {
        const ifs::Vector<2> half(room.width() / 2 / scale, room.height() / 2 / scale);
        setFont(0.6);
        for (const int axis : {0, 1}) {
            const double from = std::ceil((middle[axis] - half[axis]) / spacing.minor);
            const double to = std::floor((middle[axis] + half[axis]) / spacing.minor);
            for (double index = from; index <= to; ++index) {
                const double offset = (index * spacing.minor - middle[axis]) * scale;
                const bool isMajor = std::fmod(index, spacing.subdivisions) == 0;
                m_painter.setPen(QPen(index == 0 ? QColor(60, 60, 60)
                                      : isMajor  ? QColor(140, 140, 140)
                                                 : QColor(205, 205, 205),
                                      (index == 0 ? 0.06 : 0.035) * m_line));
                const QString label =
                    isMajor ? gridLabel(spacing.major, index / spacing.subdivisions) : QString();
                if (axis == 0) {
                    const double x = room.center().x() + offset;
                    m_painter.drawLine(QPointF(x, room.top()), QPointF(x, room.bottom()));
                    m_painter.setPen(Qt::black);
                    m_painter.drawText(QRectF(x - 3 * m_line, room.bottom(), 6 * m_line, m_line),
                                       Qt::AlignCenter, label);
                } else {
                    const double y = room.center().y() - offset;
                    m_painter.drawLine(QPointF(room.left(), y), QPointF(room.right(), y));
                    m_painter.setPen(Qt::black);
                    m_painter.drawText(QRectF(room.left() - 3.3 * m_line, y - m_line / 2, 3 * m_line, m_line),
                                       int(Qt::AlignRight | Qt::AlignVCenter) | Qt::TextDontClip, label);
                }
            }
        }
    }

    // A row for each map, to be filled in by hand.
    void paintEmptyTable(const QRectF& room, const document::Fractal& fractal) {
        const auto maps = int(std::min<std::size_t>(ifs::countActive(*document::system2(fractal)), maxRows));
        const double row = std::min(1.8 * m_line, 0.14 * room.height());
        const int rows = std::clamp(maps, 1, std::max(1, int(room.height() / row) - 1));
        constexpr double narrow = 0.5; // the numbers of the maps
        const double column = room.width() / (printedColumns - 1 + narrow);
        m_painter.setPen(QPen(Qt::black, 0.04 * m_line));
        const double bottom = room.top() + row * (rows + 1);
        for (int k = 0; k <= rows + 1; ++k)
            m_painter.drawLine(QPointF(room.left(), room.top() + k * row),
                               QPointF(room.right(), room.top() + k * row));
        const QString names = QStringLiteral(" abcdefp");
        for (int k = 0; k <= printedColumns; ++k) {
            const double left = room.left() + (k == 0 ? 0 : column * (k - 1 + narrow));
            m_painter.drawLine(QPointF(left, room.top()), QPointF(left, bottom));
            if (k == printedColumns) break;
            setFont(0.75, true);
            m_painter.drawText(QRectF(left, room.top(), k == 0 ? narrow * column : column, row),
                               Qt::AlignCenter, names.mid(k, 1).trimmed());
        }
        for (int k = 1; k <= rows; ++k)
            m_painter.drawText(QRectF(room.left(), room.top() + k * row, narrow * column, row),
                               Qt::AlignCenter, QString::number(k));
    }

    QPainter& m_painter;
    QRectF m_cell;
    double m_line;
    const HandoutOptions& m_options;
};

void paintNameLine(QPainter& painter, const QRectF& strip, double line) {
    painter.setFont(printedFont(painter, 0.75 * line, false));
    painter.setPen(QPen(Qt::black, 0.04 * line));
    const double half = 0.62 * strip.width();
    const auto field = [&](double left, double right, const QString& name) {
        const double width = QFontMetricsF(painter.font()).horizontalAdvance(name);
        painter.drawText(QPointF(left, strip.top() + line), name);
        painter.drawLine(QPointF(left + width + 0.4 * line, strip.top() + 1.1 * line),
                         QPointF(right, strip.top() + 1.1 * line));
    };
    field(strip.left(), strip.left() + half, Text::tr("Name:"));
    field(strip.left() + half + line, strip.right(), Text::tr("Date:"));
}

} // namespace

QString formulaText(const ifs::AffineMap<2>& map, std::size_t number) {
    const auto row = [&](int k) { return sumText(map.linear(k, 0), map.linear(k, 1), map.translation[k]); };
    return QStringLiteral("w%1(x, y) = (%2, %3)").arg(subscript(number), row(0), row(1));
}

void paintHandout(QPainter& painter, const QRectF& page, std::span<const HandoutItem> items,
                  const HandoutOptions& options, const std::function<void()>& newPage) {
    if (page.isEmpty()) return; // of a printer that is not set up
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = page.height() / (options.perPage <= 2 ? 62 : 78);
    const double top = options.hasNameLine ? 2.4 * line : 0;
    const int columns = options.perPage <= 2 ? 1 : 2;
    const int rows = std::max(1, options.perPage / columns);
    const double gap = 1.6 * line;
    const QSizeF size((page.width() - gap * (columns - 1)) / columns,
                      (page.height() - top - gap * (rows - 1)) / rows);
    for (std::size_t k = 0; k < items.size(); ++k) {
        const int place = int(k % std::size_t(columns * rows));
        if (place == 0 && k > 0) newPage();
        if (place == 0 && options.hasNameLine)
            paintNameLine(painter, QRectF(page.topLeft(), QSizeF(page.width(), top)), line);
        const QPointF corner(page.left() + (place % columns) * (size.width() + gap),
                             page.top() + top + (place / columns) * (size.height() + gap));
        CellPainter(painter, QRectF(corner, size), line, options).paint(items[k]);
    }
}

} // namespace view
