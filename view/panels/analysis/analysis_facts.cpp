// SPDX-License-Identifier: MIT
#include "panels/analysis/analysis_facts.h"

#include "document/edits/cage/cage_edits.h"
#include "ifs/dimension/dimension.h"
#include "ifs/facts.h"
#include "io/report/figure_error.h"
#include "io/report/verdicts.h"
#include "panels/cage/cage_texts.h"
#include "widgets/numbers/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace view {

namespace {

using document::Analysis;

constexpr std::size_t maxListed = 24; // maps of which a line says something

class Facts {
    Q_DECLARE_TR_FUNCTIONS(Analysis)

public:
    explicit Facts(std::shared_ptr<const Analysis> analysis) : m_analysis(std::move(analysis)) {}
    QList<Fact> all();

private:
    using Format = QString (*)(double);
    // The same text with few digits and, when it is asked for, with all: those of 10⁵ maps take long.
    template <class Writer>
    void add(const QString& name, const QString& definition, bool isKnown, Writer write,
             const QString& absence = {}) {
        if (isKnown)
            m_lines.append({name, write(*m_analysis, &shortNumber),
                            [analysis = m_analysis, write] { return write(*analysis, &fullNumber); },
                            definition});
        else
            m_lines.append({name, QString(), [] { return QString(); }, definition, false, absence});
    }
    template <int Dim> void explainAbsences();
    template <int Dim> static const ifs::Facts<Dim>& factsIn(const Analysis& analysis) {
        if constexpr (Dim == 2)
            return analysis.facts;
        else
            return *analysis.solid;
    }
    static constexpr int shownDigits = 5, allDigits = 15;
    // With more digits than usual where things of that size lie far from 0.
    static QString figure(double value, double error, double size, Format number) {
        constexpr double far = 1e4; // sizes
        const bool isFar = size > 0 && std::abs(value) > far * size;
        return number == &shortNumber && isFar ? io::figure(value, error, size, shownDigits) : number(value);
    }
    template <int Dim>
    static QString tuple(const ifs::Vector<Dim>& v, double error, double size, Format number) {
        QStringList coordinates;
        for (const double x : v)
            coordinates << figure(x, error, size, number);
        return u'(' + coordinates.join(QStringLiteral(", ")) + u')';
    }
    // All of them with all digits, to copy; to read, those of the first maps.
    template <class Text> static QString list(std::size_t count, Format number, Text textOf) {
        const std::size_t listed = number == &shortNumber ? std::min(count, maxListed) : count;
        QStringList texts;
        for (std::size_t i = 0; i < listed; ++i)
            texts << textOf(i);
        if (listed < count) texts << tr("… and %n more", nullptr, static_cast<int>(count - listed));
        return texts.join(QStringLiteral("  "));
    }
    // With " ± …" when the error shows in the digits that are written.
    static QString note(const std::vector<double>& values, double error, double size, Format number) {
        return io::errorNote(values, error, size, number == &shortNumber ? shownDigits : allDigits);
    }
    static QString unknown() { return tr("unknown: the error would be larger"); }
    template <int Dim> void addMaps();
    template <int Dim> void addFixedPoints();
    template <int Dim> void addDimensions();
    template <int Dim> void addMoments();
    template <int Dim> void addExtents();
    template <int Dim> void addHull();
    template <int Dim> void addContacts();
    template <int Dim> void addInvariants();
    template <int Dim> void addOpenSet();
    void addTile();
    template <int Dim> static QString caveat(const Analysis& analysis);

    std::shared_ptr<const Analysis> m_analysis;
    QList<Fact> m_lines;
};

// By which a fixed point may be off: far where a map nearly keeps a direction.
template <int Dim> double errorOf(const ifs::Vector<Dim>& fixedPoint, const ifs::AffineMap<Dim>& map) {
    const auto enclosed = ifs::enclosedFixedPoint(map);
    return enclosed ? enclosed->error + (enclosed->point - fixedPoint).stableNorm()
                    : std::numeric_limits<double>::infinity();
}

// 0 under a flat cage, which has no maps.
double fixedPointError(const Analysis& analysis, std::size_t k) {
    const auto& active = analysis.facts.active;
    if (active.maps.empty()) return 0;
    double error = std::numeric_limits<double>::infinity();
    const auto& index = active.index; // copies under a symmetry have the same
    const auto [first, last] = std::equal_range(index.begin(), index.end(), analysis.fixedBy[k]);
    for (auto copy = first; copy != last; ++copy)
        error = std::min(error,
                         errorOf<2>(analysis.fixedPoints[k], active.maps[std::size_t(copy - index.begin())]));
    return error;
}

constexpr double roundOff = 1e-9; // of the size

template <int Dim> double sizeOf(const ifs::Facts<Dim>& facts) {
    if (facts.box) return (facts.box->max - facts.box->min).stableNorm();
    return std::sqrt(std::max(facts.moments->covariance.trace(), 0.0));
}

// What an area or a volume is compared with; of a point, what rounding leaves of it.
template <int Dim> double contentOf(const ifs::Facts<Dim>& facts) {
    return std::pow(std::max(sizeOf(facts), 1e-9 * facts.hull->vertices.front().stableNorm()), Dim);
}

template <int Dim> std::vector<double> coordinates(const ifs::Vector<Dim>& v) {
    return {v.begin(), v.end()};
}

QString signs(const ifs::Orientation<2>& orientation) {
    return document::orientationText(orientation);
}
QString signs(const ifs::Orientation<3>& orientation) {
    return orientationText(orientation);
}

// Σ sᵢᴰ = 1 with numbers, equal ratios together, and solved where there is one ratio.
QString moranEquation(std::vector<double> ratios, QString (*number)(double)) {
    constexpr double apart = 1e-9;
    std::ranges::sort(ratios, std::greater());
    QStringList terms;
    std::size_t count = 0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        ++count;
        if (i + 1 < ratios.size() && ratios[i + 1] > ratios[i] * (1 - apart)) continue;
        const QString power = number(ratios[i]) + u'ᴰ';
        terms << (count == 1 ? power : QStringLiteral("%1 · %2").arg(count).arg(power));
        count = 0;
    }
    QString text = terms.join(QStringLiteral(" + ")) + QStringLiteral(" = 1");
    if (terms.size() == 1 && ratios.size() > 1)
        text += QStringLiteral(" ⇒ D = ln %1 / ln %2").arg(ratios.size()).arg(number(1 / ratios.front()));
    return text;
}

QList<Fact> Facts::all() {
    const auto addAll = [this]<int Dim>(std::integral_constant<int, Dim>) {
        addMaps<Dim>();
        addFixedPoints<Dim>();
        addDimensions<Dim>();
        addMoments<Dim>();
        addExtents<Dim>();
        addHull<Dim>();
        const qsizetype first = m_lines.size();
        addContacts<Dim>();
        addOpenSet<Dim>();
        if constexpr (Dim == 2) addTile();
        addInvariants<Dim>();
        for (qsizetype k = first; k < m_lines.size(); ++k)
            m_lines[k].isPending = !m_analysis->isComplete;
        explainAbsences<Dim>();
    };
    if (m_analysis->solid)
        addAll(std::integral_constant<int, 3>());
    else
        addAll(std::integral_constant<int, 2>());
    return m_lines;
}

// Of those without a reason of their own, and of all where there may be nothing to measure.
template <int Dim> void Facts::explainAbsences() {
    using enum ifs::Verdict;
    const ifs::Existence& existence = factsIn<Dim>(*m_analysis).existence;
    for (Fact& fact : m_lines) {
        if (!fact.value.isEmpty()) continue;
        if (existence.verdict == Undecided)
            fact.absence = tr("There is no value, because it is not proved that there is an attractor.");
        else if (!existence.exists())
            fact.absence = tr("There is no value, because there is no attractor.");
        else if (!existence.hasFactor())
            fact.absence = tr("There is no value, because the maps contract by too little to bound it.");
        else if (fact.absence.isEmpty())
            fact.absence = tr("There is no value: for these maps, none could be computed.");
    }
}

QString notSimilarities() {
    return Facts::tr(
        "There is no value, because these maps are not all similarities in the same coordinates.");
}

template <int Dim> void Facts::addMaps() {
    const ifs::Facts<Dim>& facts = factsIn<Dim>(*m_analysis);
    const QString verdict = io::verdictText(facts.existence, facts.active.index);
    add(tr("Attractor"),
        tr("A compact set to which the iterates of every compact set converge. A system has one if and only "
           "if its maps contract in some norm."),
        true, [verdict](const Analysis&, Format) { return verdict; });
    add(tr("Contraction"), tr("‖A‖ of each active map: the largest factor by which it stretches distances."),
        !facts.active.maps.empty(), [](const Analysis& analysis, Format number) {
            const auto& maps = factsIn<Dim>(analysis).active.maps;
            return list(maps.size(), number,
                        [&](std::size_t i) { return number(ifs::spectralNorm<Dim>(maps[i].linear)); });
        });
}

template <int Dim> void Facts::addFixedPoints() {
    std::vector<std::size_t> rows; // in space: of the active maps that have one
    if constexpr (Dim == 3) {
        const auto& maps = m_analysis->solid->active.maps;
        for (std::size_t i = 0; i < maps.size(); ++i)
            if (ifs::fixedPoint(maps[i])) rows.push_back(i);
    }
    const std::size_t count = Dim == 2 ? m_analysis->fixedPoints.size() : rows.size();
    add(tr("Fixed points"), tr("The point that each map leaves unchanged; it belongs to the attractor."),
        count > 0, [count, rows](const Analysis& analysis, Format number) {
            return list(count, number, [&](std::size_t i) {
                ifs::Vector<Dim> point;
                double error = 0;
                if constexpr (Dim == 2) {
                    point = analysis.fixedPoints[i];
                    error = fixedPointError(analysis, i);
                } else {
                    const auto& map = analysis.solid->active.maps[rows[i]];
                    point = *ifs::fixedPoint(map);
                    error = errorOf<3>(point, map);
                }
                const ifs::Vector<Dim> known = io::withoutNoise(point, error);
                const auto& box = factsIn<Dim>(analysis).box;
                const double size = box ? (box->max - box->min).stableNorm() : point.stableNorm();
                return tuple<Dim>(known, error, size, number) +
                       note(coordinates<Dim>(known), error, size, number);
            });
        });
}

// What is known of the open set condition.
template <int Dim> QString Facts::caveat(const Analysis& analysis) {
    const auto& facts = factsIn<Dim>(analysis);
    return analysis.isComplete || facts.invariants.contacts ? io::openSetNote(facts) : QString();
}

template <int Dim> void Facts::addContacts() {
    const auto& invariants = factsIn<Dim>(*m_analysis).invariants;
    const auto& index = factsIn<Dim>(*m_analysis).active.index;
    add(tr("Separation"),
        tr("Whether the pieces that the maps make of the attractor are disjoint (strong separation, proved "
           "by disjoint covers), or words of maps coincide, so that the open set condition fails."),
        invariants.contacts.has_value(), [](const Analysis& analysis, Format) {
            return io::separationText(factsIn<Dim>(analysis).invariants.contacts->separation);
        });
    add(tr("Connectedness"),
        tr("An attractor is connected if and only if its pieces are joined by common points (Hata). Common "
           "points are looked for among fixed points of short words, and their absence is proved by "
           "disjoint covers."),
        invariants.contacts.has_value(), [](const Analysis& analysis, Format) {
            return io::connectednessText(factsIn<Dim>(analysis).invariants.contacts->connectedness);
        });
    add(
        tr("Overlaps"),
        tr("Different words that compose to the same map, neither a prefix of the other: their pieces "
           "coincide."),
        invariants.contacts && !invariants.contacts->overlaps.empty(),
        [index](const Analysis& analysis, Format) {
            QStringList texts;
            for (const auto& overlap : factsIn<Dim>(analysis).invariants.contacts->overlaps)
                texts << (overlap.isExact ? QStringLiteral("%1 = %2") : QStringLiteral("%1 ≈ %2"))
                             .arg(io::wordText(overlap.first, index), io::wordText(overlap.second, index));
            return texts.join(QStringLiteral("  "));
        },
        tr("No overlaps were found."));
}

template <int Dim> void Facts::addOpenSet() {
    const auto& openSet = factsIn<Dim>(*m_analysis).invariants.openSet;
    add(tr("Open set condition"),
        tr("Whether there is an open set with disjoint images in it. It is proved where the pieces are "
           "disjoint, where "
           "an area of the attractor is, and where the neighbours of pieces of one size are finitely many, "
           "and "
           "none of them coincides with its neighbour."),
        openSet.has_value(), [](const Analysis& analysis, Format) {
            return io::openSetText(*factsIn<Dim>(analysis).invariants.openSet);
        });
    add(
        tr("Hausdorff dimension"),
        tr("Dimension of the attractor, where it is proved: the similarity dimension under the open set "
           "condition; or, where pieces coincide and there are finitely many neighbours, by the growth of "
           "the "
           "number of different maps."),
        openSet && openSet->dimension,
        [](const Analysis& analysis, Format number) {
            const auto& found = *factsIn<Dim>(analysis).invariants.openSet->dimension;
            return number(found.value) + note({found.value}, found.error, 1, number) +
                   io::roundingNote(found.certainty == ifs::Certainty::Exact);
        },
        tr("There is no value: it is not known how much the pieces overlap, or the maps are no "
           "similarities."));
}

void Facts::addTile() {
    const auto& tile = m_analysis->facts.invariants.tile;
    const auto withNote = [](const QString& figure, const Analysis& analysis) {
        return figure + io::roundingNote(analysis.facts.invariants.tile->isExact);
    };
    add(
        tr("Tile area"),
        tr("Area of the attractor, if its copies, moved by a lattice and turned by a few turns, cover the "
           "plane "
           "equally often; proved by the contacts of the copies, or by counting those that hold a point."),
        tile && tile->area,
        [withNote](const Analysis& analysis, Format number) {
            return withNote(number(*analysis.facts.invariants.tile->area), analysis);
        },
        tr("There is no value: it is not proved that copies of the attractor cover the plane in this way."));
    add(
        tr("Boundary dimension"),
        tr("Dimension of the boundary, if all maps are similarities of one ratio whose pieces fill an area "
           "and meet in finitely many ways: from the growth of the number of contacts."),
        tile && tile->boundaryDimension,
        [withNote](const Analysis& analysis, Format number) {
            const auto& found = *analysis.facts.invariants.tile;
            return withNote(number(*found.boundaryDimension) +
                                note({*found.boundaryDimension}, found.boundaryDimensionError, 1, number),
                            analysis);
        },
        tr("There is no value, because these maps are not of this kind."));
}

template <int Dim> void Facts::addInvariants() {
    const auto& invariants = factsIn<Dim>(*m_analysis).invariants;
    add(tr("Joint spectral radius"),
        tr("The largest factor per map by which long words stretch. Both ends of the interval are proved; a "
           "system contracts in some norm if and only if it is less than 1."),
        invariants.jointSpectralRadius && std::isfinite(invariants.jointSpectralRadius->most),
        [](const Analysis& analysis, Format number) {
            const auto [least, most] = *factsIn<Dim>(analysis).invariants.jointSpectralRadius;
            constexpr double tight = 1e-8; // not to be told apart at short digits
            if (number == &shortNumber && most - least < tight) return number(most);
            if (number == &shortNumber)
                return QStringLiteral("%1 … %2").arg(QString::number(std::floor(least * 1e4) / 1e4),
                                                     QString::number(std::ceil(most * 1e4) / 1e4));
            return QStringLiteral("%1 … %2").arg(number(least), number(most));
        });
    add(tr("Entropy"), tr("−Σ pᵢ ln pᵢ: the uncertainty of one step of the chaos game, in nats."),
        invariants.entropy.has_value(), [](const Analysis& analysis, Format number) {
            return number(*factsIn<Dim>(analysis).invariants.entropy);
        });
    add(
        tr("Lyapunov exponent"),
        tr("Σ pᵢ ln sᵢ: how the logarithm of a distance changes per step of the chaos game, if all maps are "
           "similarities in some coordinates."),
        invariants.lyapunovExponent.has_value(),
        [](const Analysis& analysis, Format number) {
            return number(*factsIn<Dim>(analysis).invariants.lyapunovExponent);
        },
        notSimilarities());
    add(
        tr("Dimension of the measure"),
        Dim == 2
            ? tr("Entropy divided by minus the Lyapunov exponent, at most 2: the dimension of the invariant "
                 "measure under the open set condition, and an upper bound for it otherwise.")
            : tr("Entropy divided by minus the Lyapunov exponent, at most 3: the dimension of the invariant "
                 "measure under the open set condition, and an upper bound for it otherwise."),
        invariants.measureDimension.has_value(),
        [](const Analysis& analysis, Format number) {
            const auto& found = factsIn<Dim>(analysis).invariants;
            const QString value = number(*found.measureDimension);
            return (found.isMeasureDimensionCapped ? tr("at most %1").arg(value) : value) +
                   caveat<Dim>(analysis);
        },
        notSimilarities());
}

template <int Dim> void Facts::addDimensions() {
    const ifs::Facts<Dim>& facts = factsIn<Dim>(*m_analysis);
    add(
        tr("Similarity dimension"),
        tr("The number D with Σ sᵢᴰ = 1, where sᵢ are the ratios of the maps, if all maps are similarities "
           "in some coordinates. It is the dimension of the attractor under the open set condition, and an "
           "upper bound for it otherwise."),
        facts.similarityDimension.has_value(),
        [](const Analysis& analysis, Format number) {
            return number(*factsIn<Dim>(analysis).similarityDimension) + caveat<Dim>(analysis);
        },
        notSimilarities());
    constexpr std::size_t maxRatios = 1000;
    const bool isSum = facts.similarityDimension && !facts.active.isLinked();
    const auto ratios = isSum && facts.active.maps.size() <= maxRatios
                            ? ifs::similarityRatios<Dim>(facts.active.maps)
                            : std::nullopt;
    add(
        tr("Moran equation"),
        tr("Σ sᵢᴰ = 1 with the ratios of these maps, equal ratios combined. Its solution is the "
           "similarity dimension."),
        ratios.has_value(),
        [ratios](const Analysis&, Format number) { return moranEquation(*ratios, number); },
        isSum ? QString()
        : facts.active.isLinked()
            ? tr("There is no value, because the maps are linked: the equation is another.")
            : notSimilarities());
    if constexpr (Dim == 3) return; // the others are worked out in the plane
    add(tr("Affinity dimension"),
        tr("Falconer’s dimension, at most 2: the exponent at which the sum of the singular value functions "
           "of all words of one length neither grows nor shrinks as the words get longer. It is an upper "
           "bound for the box-counting dimension, and equal to it for almost all translations if the maps "
           "contract enough."),
        facts.affinityDimension.has_value(), [](const Analysis& analysis, Format number) {
            const double dimension = *analysis.facts.affinityDimension;
            if (analysis.facts.isAffinityDimensionCapped) return tr("at least %1").arg(number(dimension));
            return number(dimension) + note({dimension}, analysis.facts.affinityDimensionError, 1, number);
        });
    m_lines.last().isPending = !m_analysis->isComplete;
    add(tr("Box-counting dimension"),
        tr("Slope of the least-squares line of ln N against ln 1/ε, where N is the number of boxes of side ε "
           "that meet the attractor, over the sizes where it is most stable. This is an estimate: the "
           "uncertainty is the difference between parts of that range, not a proven bound."),
        m_analysis->boxCounting.has_value(), [](const Analysis& analysis, Format number) {
            const auto& counting = *analysis.boxCounting;
            return QStringLiteral("%1 ± %2").arg(number(counting.fit.slope),
                                                 io::boundText(counting.uncertainty));
        });
    m_lines.last().isPending = !m_analysis->isComplete;
}

template <int Dim> void Facts::addMoments() {
    const bool isKnown = factsIn<Dim>(*m_analysis).moments.has_value();
    add(tr("Mean"),
        tr("Mean of the invariant measure, solved without sampling: the centre of mass of the picture."),
        isKnown, [](const Analysis& analysis, Format number) {
            const auto& moments = *factsIn<Dim>(analysis).moments;
            const double error = moments.meanError, size = sizeOf(factsIn<Dim>(analysis));
            if (io::isWorthless(error, std::max(size, moments.mean.stableNorm()))) return unknown();
            const ifs::Vector<Dim> known = io::withoutNoise(moments.mean, error);
            return tuple<Dim>(known, error, size, number) +
                   note(coordinates<Dim>(known), error, size, number);
        });
    add(tr("Covariance"),
        Dim == 2 ? tr("Covariance xx, xy, yy of the invariant measure, solved without sampling: how far the "
                      "picture spreads. A uniform mass on the ellipse has the same mean and covariance.")
                 : tr("Covariance xx, xy, xz, yy, yz, zz of the invariant measure, solved without sampling: "
                      "how far the picture spreads."),
        isKnown, [](const Analysis& analysis, Format number) {
            const double error = factsIn<Dim>(analysis).moments->covarianceError;
            const double size = std::pow(sizeOf(factsIn<Dim>(analysis)), 2);
            const auto& covariance = factsIn<Dim>(analysis).moments->covariance;
            if (io::isWorthless(error, std::max(size, covariance.trace()))) return unknown();
            const ifs::Matrix<Dim> known = io::withoutNoise(covariance, error);
            std::vector<double> entries;
            QStringList texts;
            for (int row = 0; row < Dim; ++row)
                for (int column = row; column < Dim; ++column) {
                    entries.push_back(known(row, column));
                    texts << number(entries.back());
                }
            return texts.join(QStringLiteral(", ")) + note(entries, error, size, number);
        });
}

template <int Dim> void Facts::addExtents() {
    const ifs::Facts<Dim>& facts = factsIn<Dim>(*m_analysis);
    add(Dim == 2 ? tr("Box") : tr("Box", "in space"),
        Dim == 2 ? tr("The smallest box with sides parallel to the axes that contains the attractor; "
                      "certified. Each side is off by at most the error.")
                 : tr("The smallest box with edges parallel to the axes that contains the attractor, to the "
                      "error bound."),
        facts.box.has_value(), [](const Analysis& analysis, Format number) {
            const auto& box = *factsIn<Dim>(analysis).box;
            const double size = sizeOf(factsIn<Dim>(analysis));
            if (io::isWorthless(box.error, std::max(size, 1e-9 * box.max.stableNorm()))) return unknown();
            const ifs::Vector<Dim> low = io::withoutNoise(box.min, box.error);
            const ifs::Vector<Dim> high = io::withoutNoise(box.max, box.error);
            std::vector<double> ends;
            QStringList sides;
            for (int axis = 0; axis < Dim; ++axis) {
                ends.insert(ends.end(), {low[axis], high[axis]});
                sides << QStringLiteral("[%1, %2]")
                             .arg(figure(low[axis], box.error, size, number),
                                  figure(high[axis], box.error, size, number));
            }
            return sides.join(QStringLiteral(" × ")) + note(ends, box.error, size, number);
        });
    if constexpr (Dim == 3)
        add(tr("Box error bound"), tr("The attractor extends at most this far beyond the box; certified."),
            facts.box.has_value(), [](const Analysis& analysis, Format number) {
                const double error = analysis.solid->box->error;
                return number == &shortNumber ? io::boundText(error) : number(error);
            });
    add(tr("Canonical simplex"),
        Dim == 2 ? tr("The smallest isosceles right triangle with legs parallel to the axes that contains "
                      "the attractor; certified. The signs give the directions of its legs. For a single "
                      "point, the leg is 1.")
                 : tr("The smallest tetrahedron with three equal legs parallel to the axes that contains the "
                      "attractor; certified. The signs give the directions of its legs. For a single point, "
                      "the leg is 1."),
        facts.simplex.has_value(), [](const Analysis& analysis, Format number) {
            const auto& simplex = *factsIn<Dim>(analysis).simplex;
            if (io::isWorthless(simplex.error, simplex.leg)) return unknown();
            const ifs::Vector<Dim> corner = io::withoutNoise(simplex.vertices[0], simplex.error);
            std::vector<double> values = coordinates<Dim>(corner);
            values.push_back(simplex.leg);
            return tr("%1, leg %2, corner %3")
                       .arg(signs(simplex.orientation), number(simplex.leg),
                            tuple<Dim>(corner, simplex.error, simplex.leg, number)) +
                   note(values, simplex.error, simplex.leg, number);
        });
}

template <int Dim> void Facts::addHull() {
    const bool isKnown = factsIn<Dim>(*m_analysis).hull.has_value();
    if constexpr (Dim == 2)
        add(tr("Hull area"),
            tr("Area of the computed hull, whose vertices are points of the attractor. The exact convex hull "
               "is larger by at most its perimeter times the error bound e, and πe² for the corners."),
            isKnown, [](const Analysis& analysis, Format number) {
                const auto& hull = *analysis.facts.hull;
                const double error = ifs::areaError(hull), size = contentOf(analysis.facts);
                if (io::isWorthless(error, std::max(hull.area, 1e-3 * size))) return unknown();
                return number(hull.area) + note({hull.area}, error, size, number);
            });
    else
        add(tr("Hull volume"),
            tr("Volume of the computed hull, whose vertices are points of the attractor. The exact convex "
               "hull is larger by at most the error."),
            isKnown, [](const Analysis& analysis, Format number) {
                const auto& hull = *analysis.solid->hull;
                const double error = ifs::volumeError(hull), size = contentOf(*analysis.solid);
                if (io::isWorthless(error, std::max(hull.volume, 1e-3 * size))) return unknown();
                return number(hull.volume) + note({hull.volume}, error, size, number);
            });
    add(tr("Hull vertices"),
        tr("Vertices of the computed hull; each is a point of the attractor. If the exact hull has "
           "infinitely many, as many are computed as the tolerance requires."),
        isKnown, [](const Analysis& analysis, Format number) {
            const ifs::Facts<Dim>& facts = factsIn<Dim>(analysis);
            const std::size_t count = facts.hull->vertices.size();
            const QString text =
                number == &shortNumber ? groupedNumber(double(count)) : QString::number(count);
            // Where the hull is not known exactly, neither is the number of its vertices.
            const bool isExact = facts.isHullExact || facts.hull->error <= roundOff * sizeOf(facts);
            return isExact ? text : tr("%1 (approximation)").arg(text);
        });
    add(tr("Hull error bound"),
        Dim == 2 ? tr("The attractor extends at most this far beyond the polygon; certified.")
                 : tr("The attractor extends at most this far beyond the polyhedron; certified."),
        isKnown, [](const Analysis& analysis, Format number) {
            const double error = factsIn<Dim>(analysis).hull->error;
            return number == &shortNumber ? io::boundText(error) : number(error);
        });
}

} // namespace

QList<Fact> analysisFacts(std::shared_ptr<const document::Analysis> analysis) {
    return Facts(std::move(analysis)).all();
}

} // namespace view
