// SPDX-License-Identifier: MIT
#include "document/addresses.h"
#include "ifs/facts.h"
#include "io/info_report.h"

#include <QCoreApplication>

#include <algorithm>

namespace io {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

QString digits(double number) {
    return QString::number(number == 0 ? 0.0 : number, 'g', 6);
}

QString digits(const std::optional<double>& number) {
    return number ? digits(*number) : Text::tr("not known");
}

template <typename Vector> QString tuple(const Vector& v) {
    QStringList parts;
    for (Eigen::Index i = 0; i < v.size(); ++i)
        parts << digits(double(v[i]));
    return QStringLiteral("(%1)").arg(parts.join(QStringLiteral(", ")));
}

template <typename Matrix> QString rows(const Matrix& m) {
    QStringList parts;
    for (Eigen::Index i = 0; i < m.rows(); ++i)
        parts << tuple(m.row(i));
    return parts.join(QStringLiteral(" "));
}

template <typename Points> QString list(const Points& points) {
    QStringList parts;
    for (const auto& point : points)
        parts << tuple(point);
    return parts.join(QStringLiteral(" "));
}

QString verdictSentence(const ifs::Existence& existence) {
    switch (existence.verdict) {
    case ifs::Verdict::Hyperbolic:
        return Text::tr("hyperbolic, s = %1").arg(digits(existence.contractivity));
    case ifs::Verdict::EventuallyContractive:
        return Text::tr("eventually contractive, γ = %1 from words of length %2")
            .arg(digits(existence.contractivity))
            .arg(existence.wordLength);
    case ifs::Verdict::None:
        return Text::tr("none: a word of length %1 does not contract").arg(existence.witness.size());
    case ifs::Verdict::Undecided:
        return Text::tr("undecided");
    case ifs::Verdict::Empty:
        break;
    }
    return Text::tr("none: no map takes part");
}

class Lines {
public:
    void add(const QString& name, const QString& value) {
        m_text += QStringLiteral("  %1  %2\n").arg(name, -22).arg(value);
    }
    void title(const QString& text) { m_text += text + u'\n'; }
    const QString& text() const { return m_text; }

private:
    QString m_text;
};

template <int Dim> QString mapLine(const ifs::WeightedMap<Dim>& map, double probability) {
    QStringList row;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            row << digits(map.map.linear(i, j)).rightJustified(11);
    for (int i = 0; i < Dim; ++i)
        row << digits(map.map.translation[i]).rightJustified(11);
    row << digits(probability).rightJustified(11);
    return row.join(u' ') + Text::tr("   norm %1, determinant %2")
                                .arg(digits(ifs::spectralNorm<Dim>(map.map.linear)),
                                     digits(ifs::determinant<Dim>(map.map.linear)));
}

template <int Dim>
void addSystem(Lines& lines, const ifs::IteratedFunctionSystem<Dim>& system, const InfoSubject& subject) {
    const ifs::Facts<Dim> facts = ifs::factsOf(system, subject.hullTolerance);
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        lines.add(Text::tr("map %1").arg(i + 1), mapLine(system.maps[i], facts.probabilities[i]));
    lines.add(Text::tr("attractor"), verdictSentence(facts.existence));
    if (facts.mean) lines.add(Text::tr("mean"), tuple(*facts.mean));
    if (facts.moments) lines.add(Text::tr("covariance"), rows(facts.moments->covariance));
    if (facts.box)
        lines.add(Text::tr("bounding box"),
                  tuple(facts.box->min) + QStringLiteral(" ") + tuple(facts.box->max));
    if (facts.simplex) lines.add(Text::tr("canonical simplex"), list(facts.simplex->vertices));
    if constexpr (Dim == 2) {
        if (facts.hull)
            lines.add(Text::tr("convex hull"),
                      Text::tr("%1 vertices, %2 of them with periodic addresses, area %3; error at most %4")
                          .arg(facts.hull->vertices.size())
                          .arg(std::ranges::count_if(facts.extremePoints,
                                                     [](const auto& point) { return point.has_value(); }))
                          .arg(digits(facts.hull->area), digits(facts.hull->error)));
    } else if (facts.hull) {
        lines.add(Text::tr("convex hull"), Text::tr("%1 vertices, %2 facets, volume %3; error at most %4")
                                               .arg(facts.hull->vertices.size())
                                               .arg(facts.hull->facets.size())
                                               .arg(digits(facts.hull->volume), digits(facts.hull->error)));
    }
    lines.add(Text::tr("similarity dimension"), digits(facts.similarityDimension));
    lines.add(Text::tr("affinity dimension"), digits(facts.affinityDimension));
}

void addEntry(Lines& lines, const document::Entry& entry, const InfoSubject& subject) {
    const document::Fractal& fractal = *entry.fractal;
    if (const auto* plane = std::get_if<document::System2>(&fractal.system)) {
        lines.title(Text::tr("%1 — in the plane, %2 maps").arg(fractal.name).arg(plane->maps.size()));
        addSystem(lines, *plane, subject);
    } else if (const auto* space = std::get_if<document::System3>(&fractal.system)) {
        lines.title(Text::tr("%1 — in space, %2 maps").arg(fractal.name).arg(space->maps.size()));
        addSystem(lines, *space, subject);
    } else {
        lines.title(Text::tr("%1 — could not be read").arg(fractal.name));
        for (const auto& problem : entry.problems)
            if (problem.severity == document::Problem::Severity::Error)
                lines.add(Text::tr("reason"), problem.message);
    }
    if (fractal.cage) {
        lines.add(Text::tr("cage at rest"), list(fractal.cage->rest));
        lines.add(Text::tr("cage now"), list(fractal.cage->current));
        if (fractal.cage->rest.size() > 3)
            lines.add(Text::tr("deformation"), fractal.cage->deformation == ifs::Deformation::Bend
                                                   ? Text::tr("bend")
                                                   : Text::tr("affine fit"));
    }
    for (const auto& [word, change] : document::movedBranches(fractal))
        lines.add(Text::tr("moved branch"), document::addressText(word, word.size()));
}

} // namespace

QString infoText(const InfoSubject& subject) {
    Lines lines;
    for (const auto& entry : subject.entries) {
        if (!lines.text().isEmpty()) lines.title({});
        addEntry(lines, entry, subject);
    }
    return lines.text();
}

} // namespace io
