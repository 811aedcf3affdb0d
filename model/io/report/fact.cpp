// SPDX-License-Identifier: MIT
#include "io/report/fact.h"

#include "document/text/text.h"
#include "io/report/figure_error.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

constexpr int reportDigits = 6;

QString reportNumber(double value, double error, double size) {
    return figure(value, error, size, reportDigits);
}

} // namespace

QString Figures::note(const std::vector<double>& values, double error, double size) const {
    return errorNote(values, error, size, digits);
}

void FactLines::add(const QString& name, const QString& value) {
    m_text += QStringLiteral("  %1  %2\n").arg(name, -22).arg(value);
}

QString unknown() {
    return Text::tr("unknown");
}

const Figures& reportFigures() {
    static const Figures figures{.text = reportNumber,
                                 .count = [](std::size_t number) { return QString::number(number); },
                                 .bound = boundText,
                                 .digits = reportDigits};
    return figures;
}

template <int Dim> double sizeOf(const ifs::Facts<Dim>& facts) {
    if (facts.box) return (facts.box->max - facts.box->min).stableNorm();
    return std::sqrt(std::max(facts.moments ? facts.moments->covariance.trace() : 0, 0.0));
}

template <int Dim>
QString tuple(const ifs::Vector<Dim>& point, double error, double size, const Figures& number) {
    QStringList coordinates;
    for (const double x : point)
        coordinates << number(x, error, size);
    return u'(' + coordinates.join(QStringLiteral(", ")) + u')';
}

template <int Dim>
QString tupleWithError(const ifs::Vector<Dim>& point, double error, double size, const Figures& number) {
    const ifs::Vector<Dim> known = withoutNoise(point, error);
    return tuple<Dim>(known, error, size, number) + number.note({known.begin(), known.end()}, error, size);
}

QString upperDigits(double number) {
    const QString text = reportFigures()(number);
    return text.toDouble() < number ? reportFigures()(number + 1e-6 * std::abs(number)) : text;
}

template QString tuple<2>(const ifs::Vector<2>&, double, double, const Figures&);
template QString tuple<3>(const ifs::Vector<3>&, double, double, const Figures&);
template QString tupleWithError<2>(const ifs::Vector<2>&, double, double, const Figures&);
template QString tupleWithError<3>(const ifs::Vector<3>&, double, double, const Figures&);
template double sizeOf<2>(const ifs::Facts<2>&);
template double sizeOf<3>(const ifs::Facts<3>&);

} // namespace io
