// SPDX-License-Identifier: MIT
#include "dialogs/export/handout_page.h"

#include "canvas/geometry/grid_spacing.h"
#include "dialogs/export/printed_parts.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/text/text.h"
#include "io/overlay/space_overlay.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

namespace {

constexpr double lineSpacing = 1.15;
constexpr double textShare = 0.72; // share of a line's height, unless the text is too wide
constexpr double minScale = 0.6;   // least scale of a wide text, which is then broken
constexpr double brokenScale = 0.75;
constexpr int maxRows = 12;        // rows of an empty table
constexpr double gridLines = 900;  // pixels of a canvas with the same density of grid lines
constexpr double cageMargin = 0.3; // share of the cage's size around it on the grid

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
template <int Dim> QString sumText(const ifs::AffineMap<Dim>& map, int row) {
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
    for (int k = 0; k < Dim; ++k)
        add(map.linear(row, k), QStringLiteral("xyz").mid(k, 1));
    add(map.translation[row], {});
    return text.isEmpty() ? QStringLiteral("0") : text;
}

// An entry in its part of a page. All lengths follow from `line`, the height of a line of text.
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
            if (document::plane(*item.fractal))
                paintGrid(picture, *item.fractal);
            else
                paintCage(picture, *item.fractal);
            if (document::space(*item.fractal))
                text.setTop(paintTexts(text, joined(broken(cornersOf(*item.fractal), text.width()))) +
                            m_line);
            paintEmptyTable(text, *item.fractal);
            return;
        }
        QSizeF size = item.picture.size();
        size.scale(picture.size(), Qt::KeepAspectRatio);
        const QPointF corner(picture.left() + (picture.width() - size.width()) / 2, picture.top());
        m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
        m_painter.drawImage(QRectF(corner, size), item.picture);
        // A flat picture leaves more room for the text.
        if (text.top() >= picture.bottom()) text.setTop(corner.y() + size.height() + 0.7 * m_line);
        if (hasText) paintFormulas(text, *item.fractal);
    }

private:
    void setFont(double share, bool bold = false) {
        m_painter.setFont(printedFont(m_painter, share * m_line, bold));
    }

    // Rooms for the picture and for the text.
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

    template <int Dim> static QStringList formulas(const ifs::IteratedFunctionSystem<Dim>& system) {
        const std::vector<double> shares = ifs::probabilities(system);
        QStringList lines;
        for (std::size_t i = 0; i < system.maps.size(); ++i)
            if (shares[i] > 0)
                lines << formulaText<Dim>(system.maps[i].map, i + 1) +
                             QStringLiteral("   p%1 = %2").arg(subscript(i + 1), digitsOf(shares[i]));
        return lines;
    }

    static QStringList cornersOf(const document::Fractal& fractal) {
        const auto cage = document::spaceCage(fractal);
        return cage ? cornerTexts(*cage) : QStringList();
    }

    void paintFormulas(const QRectF& room, const document::Fractal& fractal) {
        QStringList lines;
        if (const document::System3* system = document::system3(fractal)) {
            const auto displayed = document::effectiveSystem<3>(fractal);
            const QStringList corners = m_options.showsMaps ? cornersOf(fractal) : QStringList();
            QRectF rest = room;
            if (!corners.isEmpty())
                rest.setTop(paintTexts(room, joined(broken(corners, room.width()))) + m_line / 2);
            paintMaps(rest, formulas<3>(displayed ? *displayed : *system));
            return;
        }
        const auto displayed = document::effectiveSystem(fractal);
        paintMaps(room, formulas<2>(displayed ? *displayed : *document::system2(fractal)));
    }

    // Lines of each text: one, or as many as necessary if any text would be too wide.
    QList<QStringList> broken(const QStringList& texts, double width) {
        const auto fitAt = [&](double scale) {
            setFont(textShare * scale);
            return [metrics = QFontMetricsF(m_painter.font()), width](const QString& text) {
                return metrics.horizontalAdvance(text) <= width;
            };
        };
        const bool areNarrow = std::ranges::all_of(texts, fitAt(minScale));
        const auto fits = fitAt(brokenScale);
        QList<QStringList> lines;
        for (const QString& text : texts)
            lines << (areNarrow ? QStringList(text) : onLines(text, fits));
        return lines;
    }

    static QStringList joined(const QList<QStringList>& texts) {
        QStringList lines;
        for (const QStringList& text : texts)
            lines << text;
        return lines;
    }

    // Counts formulas that do not fit.
    void paintMaps(const QRectF& room, const QStringList& formulas) {
        const QList<QStringList> maps = broken(formulas, room.width());
        const qsizetype fit = linesIn(room);
        const qsizetype usable = joined(maps).size() <= fit ? fit : std::max<qsizetype>(0, fit - 1);
        QStringList lines;
        qsizetype shown = 0;
        while (shown < maps.size() && lines.size() + maps[shown].size() <= usable)
            lines << maps[shown++];
        if (shown < maps.size()) lines << Text::tr("%n more maps", nullptr, int(maps.size() - shown));
        paintTexts(room, lines);
    }

    qsizetype linesIn(const QRectF& room) const {
        return qsizetype(std::max(0.0, room.height() / (lineSpacing * m_line)));
    }

    // Largest font, down to `minScale`, in which all lines fit; by search, because widths of letters are not
    // quite proportional to their size.
    void setFontFor(const QStringList& lines, double width) {
        constexpr double step = 0.02;
        const auto fits = [this, width](const QString& line) {
            return QFontMetricsF(m_painter.font()).horizontalAdvance(line) <= width;
        };
        double scale = 1;
        setFont(textShare);
        while (scale > minScale && !std::ranges::all_of(lines, fits)) {
            scale = std::max(minScale, scale - step);
            setFont(textShare * scale);
        }
    }

    // Paints as many lines as fit; returns the y coordinate of their end.
    double paintTexts(const QRectF& room, QStringList lines) {
        const double height = lineSpacing * m_line;
        lines = lines.first(std::min(lines.size(), linesIn(room)));
        setFontFor(lines, room.width());
        const QFontMetricsF metrics(m_painter.font());
        for (qsizetype k = 0; k < lines.size(); ++k)
            m_painter.drawText(QRectF(room.left(), room.top() + double(k) * height, room.width(), height),
                               Qt::AlignLeft | Qt::AlignVCenter,
                               metrics.elidedText(lines[k], Qt::ElideRight, room.width()));
        return room.top() + double(lines.size()) * height;
    }

    // Cage in space, in the first view of a solid, with numbered corners.
    void paintCage(const QRectF& room, const document::Fractal& fractal) {
        const document::Fractal printed = onPaper(fractal);
        io::PictureOverlay overlay;
        overlay.cage = overlay.isCageInked = true;
        attractor::OrbitCamera camera = standardView();
        constexpr int side = 500;
        camera.size = {side, side};
        camera = attractor::fitted(camera,
                                   document::reachOfVertices(io::spaceOverlayPoints(printed, overlay)), 0.08);
        const double scale = std::min(room.width(), room.height()) / side;
        m_painter.save();
        m_painter.translate(room.left() + (room.width() - scale * side) / 2, room.top());
        m_painter.scale(scale, scale);
        io::paint(m_painter, io::spaceOverlayMarks(printed, camera, overlay));
        m_painter.restore();
    }

    // Displayed cage with named corners, on a grid with the numbers of its lines.
    void paintGrid(const QRectF& whole, const document::Fractal& fractal) {
        const std::vector<ifs::Vector<2>> cage = document::effectiveCage(fractal).current;
        ifs::Vector<2> low = cage.front(), high = cage.front();
        for (const ifs::Vector<2>& corner : cage) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
        const double extent = (high - low).maxCoeff() > 0 ? (high - low).maxCoeff() : 1;
        const QRectF room = whole.adjusted(1.6 * m_line, 0, 0, -m_line); // room beside the numbers
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

    // Row for each map, to be filled in by hand.
    void paintEmptyTable(const QRectF& room, const document::Fractal& fractal) {
        const document::System3* solid = document::system3(fractal);
        const std::size_t active =
            solid ? ifs::countActive(*solid) : ifs::countActive(*document::system2(fractal));
        const auto maps = int(std::min<std::size_t>(active, maxRows));
        const QStringList names = coefficientNames(solid ? 3 : 2);
        const auto columns = int(names.size());
        const double row = std::min(1.8 * m_line, 0.14 * room.height());
        const int rows = std::clamp(maps, 1, std::max(1, int(room.height() / row) - 1));
        constexpr double narrow = 0.5; // column of map numbers
        const double column = room.width() / (columns - 1 + narrow);
        m_painter.setPen(QPen(Qt::black, 0.04 * m_line));
        const double bottom = room.top() + row * (rows + 1);
        for (int k = 0; k <= rows + 1; ++k)
            m_painter.drawLine(QPointF(room.left(), room.top() + k * row),
                               QPointF(room.right(), room.top() + k * row));
        for (int k = 0; k <= columns; ++k) {
            const double left = room.left() + (k == 0 ? 0 : column * (k - 1 + narrow));
            m_painter.drawLine(QPointF(left, room.top()), QPointF(left, bottom));
            if (k == columns) break;
            setFont(0.75, true);
            m_painter.drawText(QRectF(left, room.top(), k == 0 ? narrow * column : column, row),
                               Qt::AlignCenter, names[k]);
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

template <int Dim> QString formulaText(const ifs::AffineMap<Dim>& map, std::size_t number) {
    QStringList sums;
    for (int row = 0; row < Dim; ++row)
        sums << sumText<Dim>(map, row);
    const QString arguments = Dim == 2 ? QStringLiteral("x, y") : QStringLiteral("x, y, z");
    return QStringLiteral("w%1(%2) = (%3)")
        .arg(subscript(number), arguments, sums.join(QStringLiteral(", ")));
}
template QString formulaText(const ifs::AffineMap<2>& map, std::size_t number);
template QString formulaText(const ifs::AffineMap<3>& map, std::size_t number);

QStringList onLines(const QString& formula, const std::function<bool(const QString&)>& fits) {
    static const QRegularExpression breaks(QStringLiteral("(?<=, )|(?= [+−] )|(?=   \\S)"));
    static const QRegularExpression firstLetter(QStringLiteral("\\S")), endBlanks(QStringLiteral(" +$"));
    const qsizetype begin = formula.indexOf(QStringLiteral(" = ")); // end of the arguments
    QStringList pieces = formula.sliced(std::max<qsizetype>(0, begin)).split(breaks);
    pieces.first().prepend(formula.first(std::max<qsizetype>(0, begin)));
    QStringList lines{pieces.takeFirst()};
    for (const QString& piece : std::as_const(pieces)) {
        if (fits(lines.last() + piece))
            lines.last() += piece;
        else
            lines << QStringLiteral("    ") + piece.sliced(piece.indexOf(firstLetter));
    }
    for (QString& line : lines)
        line.remove(endBlanks);
    return lines;
}

QStringList cornerTexts(const ifs::ControlCage<3>& cage) {
    constexpr std::size_t perLine = 2;
    QStringList lines;
    for (std::size_t k = 0; k < cage.current.size(); ++k) {
        QStringList numbers;
        for (const double value : cage.current[k])
            numbers << (isSeen(value) ? digitsOf(value) : QStringLiteral("0"));
        const QString text =
            QStringLiteral("v%1 = (%2)").arg(subscript(k + 1), numbers.join(QStringLiteral(", ")));
        if (k % perLine == 0)
            lines << text;
        else
            lines.back() += QStringLiteral("   ") + text;
    }
    return lines;
}

namespace {

// Number of entries side by side and above each other.
struct HandoutGrid {
    int columns = 1;
    int rows = 1;
};

// The grid; fewer entries than a page takes have the whole page.
HandoutGrid handoutGrid(int perPage, std::size_t items, bool isLandscape) {
    int cells = perPage;
    for (const int fewer : {4, 2, 1})
        if (fewer < cells && items <= std::size_t(fewer)) cells = fewer;
    const int shorter = cells <= 2 ? 1 : 2;
    const int longer = std::max(1, cells / shorter);
    return isLandscape ? HandoutGrid{longer, shorter} : HandoutGrid{shorter, longer};
}

} // namespace

void paintHandout(QPainter& painter, const QRectF& page, std::span<const HandoutItem> items,
                  const HandoutOptions& options, const std::function<void()>& newPage) {
    if (page.isEmpty()) return; // printer not set up
    painter.setRenderHint(QPainter::Antialiasing);
    const auto [columns, rows] = handoutGrid(options.perPage, items.size(), page.width() > page.height());
    const double line = std::max(page.width(), page.height()) / (columns * rows <= 2 ? 62 : 78);
    const double top = options.hasNameLine ? 2.4 * line : 0;
    const double gap = 1.6 * line;
    const QSizeF size((page.width() - gap * (columns - 1)) / columns,
                      (page.height() - top - gap * (rows - 1)) / rows);
    for (std::size_t k = 0; k < items.size(); ++k) {
        const int place = int(k % std::size_t(columns * rows));
        if (place == 0 && k > 0) newPage();
        if (place == 0 && options.hasNameLine)
            paintNameLine(painter, QRectF(page.topLeft(), QSizeF(page.width(), top)), line);
        const int column = place % columns, row = place / columns;
        const QPointF corner(page.left() + column * (size.width() + gap),
                             page.top() + top + row * (size.height() + gap));
        CellPainter(painter, QRectF(corner, size), line, options).paint(items[k]);
    }
}

} // namespace view
