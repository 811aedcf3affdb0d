// SPDX-License-Identifier: MIT
#include "io/exchange/latex.h"

#include "document/fractal/fractal_geometry.h"
#include "document/text/file_names.h"
#include "io/exchange/aifs.h"
#include "io/text/number.h"
#include "io/text/readable_number.h"

#include <QByteArrayList>

#include <algorithm>

namespace io {

namespace {

constexpr double figureSize = 8; // cm of the longer side

// A number as mathematics is set: 1.5·10⁻⁵ instead of 1.5e-05. Exact to the last digit.
QByteArray set(double value) {
    const QByteArray text = formatNumber(value);
    const qsizetype e = text.indexOf('e');
    if (e < 0) return text;
    const QByteArray digits = text.first(e);
    const QByteArray power = "10^{" + QByteArray::number(text.sliced(e + 1).toInt()) + '}';
    if (digits == "1") return power;
    return digits == "-1" ? '-' + power : digits + "\\cdot " + power;
}

// Formatting of numbers.
class Style {
public:
    enum Kind { Exact, Readable };
    explicit Style(Kind kind) : m_kind(kind) {}

    QByteArray operator()(double value) {
        if (m_kind == Exact) return set(value);
        const ReadableNumber number = readableNumber(value);
        m_isRounded = m_isRounded || number.isRounded;
        return number.latex;
    }

    // Text, preceded by a remark if something was rounded.
    QByteArray withRemark(const QByteArray& text) const {
        return m_isRounded ? "% rounded to six significant digits\n" + text : text;
    }

private:
    Kind m_kind;
    bool m_isRounded = false;
};

template <class Matrix> QByteArray matrix(const Matrix& values, Style& style) {
    QByteArrayList rows;
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        QByteArrayList row;
        for (Eigen::Index j = 0; j < values.cols(); ++j)
            row << style(values(i, j));
        rows << row.join(" & ");
    }
    return "\\begin{pmatrix} " + rows.join(" \\\\ ") + " \\end{pmatrix}";
}

// Splits lines among environments, which cannot be broken inside, so that each fits on a page.
QByteArray aligned(const QByteArrayList& lines, qsizetype most) {
    QByteArray text;
    for (qsizetype i = 0; i < std::max<qsizetype>(lines.size(), 1); i += most)
        text += "\\begin{align*}\n" + lines.mid(i, most).join(" \\\\\n") + "\n\\end{align*}\n";
    return text;
}

template <int Dim> QByteArray formulas(const ifs::IteratedFunctionSystem<Dim>& system, Style::Kind kind) {
    const std::vector<double> shares = ifs::probabilities(system);
    Style style(kind);
    QByteArrayList lines;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        if (!(shares[i] > 0)) continue;
        const QByteArray number = QByteArray::number(qulonglong(i) + 1);
        const ifs::AffineMap<Dim>& map = system.maps[i].map;
        lines << "  w_{" + number + "}(x) &= " + matrix(map.linear, style) + " x + " +
                     matrix(map.translation, style) + ", & p_{" + number + "} &= " + style(shares[i]);
    }
    constexpr qsizetype onAPage = Dim == 2 ? 16 : 11;
    return style.withRemark(aligned(lines, kind == Style::Exact ? std::max(lines.size(), onAPage) : onAPage));
}

// Row by row of the map, as in Fractint's files: a b c d e f in the plane.
template <int Dim> QByteArray table(const ifs::IteratedFunctionSystem<Dim>& system) {
    constexpr int numbers = Dim * (Dim + 1);
    constexpr qsizetype onAPage = 40;
    Style style(Style::Readable);
    QByteArrayList names{"$i$"};
    for (int k = 0; k < numbers; ++k)
        names << QByteArray("$") + char('a' + k) + '$';
    names << "$p$";
    QByteArrayList rows;
    const std::vector<double> shares = ifs::probabilities(system);
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        if (!(shares[i] > 0)) continue;
        const ifs::AffineMap<Dim>& map = system.maps[i].map;
        QByteArrayList cells{QByteArray::number(qulonglong(i) + 1)};
        for (int row = 0; row < Dim; ++row)
            for (int column = 0; column < Dim; ++column)
                cells << '$' + style(map.linear(row, column)) + '$';
        for (int row = 0; row < Dim; ++row)
            cells << '$' + style(map.translation[row]) + '$';
        cells << '$' + style(shares[i]) + '$';
        rows << "  " + cells.join(" & ") + " \\\\";
    }
    const QByteArrayList head{"\\begin{tabular}{r" + QByteArray(numbers + 1, 'r') + '}',
                              "  " + names.join(" & ") + " \\\\ \\hline"};
    QByteArrayList pages;
    for (qsizetype i = 0; i < std::max<qsizetype>(rows.size(), 1); i += onAPage)
        pages << (head + rows.mid(i, onAPage)).join('\n') + "\n\\end{tabular}\n";
    return style.withRemark(pages.join('\n'));
}

// The corners, in centimetres.
class Sheet {
public:
    explicit Sheet(const std::vector<std::vector<ifs::Vector<2>>>& polygons) {
        ifs::Vector<2> low = polygons.front().front();
        ifs::Vector<2> high = low;
        for (const auto& polygon : polygons)
            for (const ifs::Vector<2>& corner : polygon) {
                low = low.cwiseMin(corner);
                high = high.cwiseMax(corner);
            }
        m_low = low;
        const double size = (high - low).maxCoeff();
        m_scale = size > 0 ? figureSize / size : 1;
    }

    QByteArray point(const ifs::Vector<2>& x) const {
        const ifs::Vector<2> p = m_scale * (x - m_low);
        return '(' + QByteArray::number(p.x(), 'f', 4) + ',' + QByteArray::number(p.y(), 'f', 4) + ')';
    }
    QByteArray path(const std::vector<ifs::Vector<2>>& polygon) const {
        QByteArray text;
        for (const ifs::Vector<2>& corner : polygon)
            text += point(corner) + " -- ";
        return text + "cycle";
    }

private:
    ifs::Vector<2> m_low;
    double m_scale = 1;
};

QByteArray tikzColour(const attractor::Rgba& colour) {
    const auto level = [](std::uint8_t value) { return QByteArray::number(int(value)); };
    return "color={rgb,255:red," + level(colour.red) + ";green," + level(colour.green) + ";blue," +
           level(colour.blue) + '}';
}

QByteArray figure(const document::Fractal& fractal, const document::System2& system) {
    const std::vector<ifs::Vector<2>> cage = document::effectiveCage(fractal).rest;
    const std::vector<double> shares = ifs::probabilities(system);
    std::vector<std::vector<ifs::Vector<2>>> polygons{cage};
    std::vector<std::size_t> drawn;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        if (!(shares[i] > 0)) continue;
        std::vector<ifs::Vector<2>> image;
        for (const ifs::Vector<2>& corner : cage)
            image.push_back(system.maps[i].map(corner));
        if (!std::ranges::all_of(image, [](const auto& p) { return p.allFinite(); })) continue;
        polygons.push_back(std::move(image));
        drawn.push_back(i);
    }
    const Sheet sheet(polygons);
    QByteArray text = "\\begin{tikzpicture}\n  \\draw[thick] " + sheet.path(cage) + ";\n";
    QByteArray marks; // marks on top of all images
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        const std::size_t i = drawn[k];
        const QByteArray number = QByteArray::number(qulonglong(i) + 1);
        const QByteArray colour = tikzColour(attractor::mapColour(fractal.appearance, system.maps[i].id, i));
        const auto& image = polygons[k + 1];
        text +=
            "  \\draw[" + colour + ",fill,fill opacity=0.2] " + sheet.path(image) + "; % " + number + '\n';
        ifs::Vector<2> middle = ifs::Vector<2>::Zero();
        for (const ifs::Vector<2>& corner : image)
            middle += corner / double(image.size());
        marks += "  \\node at " + sheet.point(middle) + " {$" + number + "$};\n";
        if (const auto fixed = ifs::fixedPoint(system.maps[i].map))
            marks += "  \\fill[" + colour + "] " + sheet.point(*fixed) + " circle[radius=2pt];\n";
    }
    return text + marks + "\\end{tikzpicture}\n";
}

} // namespace

QByteArray writeLatex(const QList<std::shared_ptr<const document::Fractal>>& fractals) {
    QByteArrayList parts;
    for (const auto& fractal : fractals) {
        const QByteArray head =
            "% " + document::oneLine(fractal->name).toUtf8() + "\n% \\usepackage{amsmath,tikz}\n";
        if (const auto* plane = document::system2(*fractal))
            parts << head + formulas(*plane, Style::Exact) + figure(*fractal, *plane);
        else if (const auto* space = document::system3(*fractal))
            parts << head + formulas(*space, Style::Exact);
    }
    return parts.join('\n');
}

QByteArray latexTable(const document::Fractal& fractal) {
    if (const auto* plane = document::system2(fractal)) return table(*plane);
    const auto* space = document::system3(fractal);
    return space ? table(*space) : QByteArray();
}

QByteArray latexMatrices(const document::Fractal& fractal) {
    if (const auto* plane = document::system2(fractal)) return formulas(*plane, Style::Readable);
    const auto* space = document::system3(fractal);
    return space ? formulas(*space, Style::Readable) : QByteArray();
}

QByteArray latexInvariantForm(const document::Fractal& fractal) {
    const auto* system = document::system2(fractal);
    if (!system) return {};
    ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    if (cage.rest.size() != 3) cage = document::canonicalCage(fractal);
    const AffineInvariantForm form = affineInvariantForm(*system, {cage.rest[0], cage.rest[1], cage.rest[2]});
    const std::vector<double> shares = ifs::probabilities(*system);
    Style style(Style::Readable);
    QByteArrayList lines;
    for (std::size_t i = 0; i < form.maps.size(); ++i)
        if (shares[i] > 0)
            lines << "  S_{" + QByteArray::number(qulonglong(i) + 1) + "} &= " + matrix(form.maps[i], style);
    constexpr qsizetype onAPage = 11;
    return style.withRemark(aligned(lines, onAPage));
}

QByteArray tikzFigure(const document::Fractal& fractal) {
    const auto* system = document::system2(fractal);
    return system ? figure(fractal, *system) : QByteArray();
}

} // namespace io
