// SPDX-License-Identifier: MIT
#include "panels/analysis_facts.h"

#include "cage_edits.h"
#include "panels/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace view {

namespace {

using document::Analysis;

constexpr std::size_t mostListed = 24; // maps of which a line says something

class Facts {
    Q_DECLARE_TR_FUNCTIONS(Analysis)

public:
    explicit Facts(std::shared_ptr<const Analysis> analysis)
        : m_analysis(std::move(analysis)), m_facts(m_analysis->facts) {}
    QList<Fact> all();

private:
    using Format = QString (*)(double);
    // The same text with few digits and, when it is asked for, with all: those of 10⁵ maps take long.
    template <class Writer>
    void add(const QString& name, const QString& definition, bool isKnown, Writer write) {
        if (isKnown)
            m_lines.append({name, write(*m_analysis, &shortNumber),
                            [analysis = m_analysis, write] { return write(*analysis, &fullNumber); },
                            definition});
        else
            m_lines.append({name, QString(), [] { return QString(); }, definition});
    }
    static QString pair(const ifs::Vector<2>& v, Format number) {
        return QStringLiteral("(%1, %2)").arg(number(v.x()), number(v.y()));
    }
    // All of them with all digits, to copy; to read, those of the first maps.
    template <class Text> static QString list(std::size_t count, Format number, Text textOf) {
        const std::size_t listed = number == &shortNumber ? std::min(count, mostListed) : count;
        QStringList texts;
        for (std::size_t i = 0; i < listed; ++i)
            texts << textOf(i);
        if (listed < count) texts << tr("… and %n more", nullptr, static_cast<int>(count - listed));
        return texts.join(QStringLiteral("  "));
    }
    void addMaps();
    void addDimensions();
    void addMoments();
    void addExtents();

    std::shared_ptr<const Analysis> m_analysis;
    const ifs::Facts<2>& m_facts;
    QList<Fact> m_lines;
};

// A bound says its size, not its digits.
QString bound(double value) {
    return QString::number(value, 'g', 2);
}

QList<Fact> Facts::all() {
    addMaps();
    addDimensions();
    addMoments();
    addExtents();
    return m_lines;
}

void Facts::addMaps() {
    const QString verdict = existenceSentence(m_facts.existence, m_facts.active.index);
    add(tr("Attractor"),
        tr("A system has one attractor if some power of it contracts: then every start leads to the same "
           "set."),
        true, [verdict](const Analysis&, Format) { return verdict; });
    add(tr("Contraction"), tr("‖A‖ of each map that takes part: the most by which it stretches distances."),
        !m_facts.active.maps.empty(), [](const Analysis& analysis, Format number) {
            const auto& maps = analysis.facts.active.maps;
            return list(maps.size(), number,
                        [&](std::size_t i) { return number(ifs::spectralNorm<2>(maps[i].linear)); });
        });
    add(tr("Fixed points"), tr("The point that each map leaves where it is; it lies on the attractor."),
        !m_analysis->fixedPoints.empty(), [](const Analysis& analysis, Format number) {
            const auto& points = analysis.fixedPoints;
            return list(points.size(), number, [&](std::size_t i) { return pair(points[i], number); });
        });
}

void Facts::addDimensions() {
    add(tr("Similarity dimension"),
        tr("The D with Σ sᵢᴰ = 1 over the ratios sᵢ, when all maps are similarities in some coordinates. It "
           "is "
           "the dimension of the attractor when the pieces do not overlap."),
        m_facts.similarityDimension.has_value(),
        [](const Analysis& analysis, Format number) { return number(*analysis.facts.similarityDimension); });
    add(tr("Affinity dimension"),
        tr("Falconer’s dimension: where the sum of the singular value functions of all words of one length "
           "neither grows nor falls, at most 2. An upper bound of the box-counting dimension, and equal to "
           "it "
           "for almost all translations when the maps contract enough."),
        m_facts.affinityDimension.has_value(),
        [](const Analysis& analysis, Format number) { return number(*analysis.facts.affinityDimension); });
    m_lines.last().isPending = !m_analysis->isComplete;
    add(tr("Box-counting dimension"),
        tr("Slope of the least-squares line through ln N against ln 1/ε, where N boxes of side ε meet the "
           "attractor. An estimate: it depends on the sizes counted."),
        m_analysis->boxCounting.has_value(),
        [](const Analysis& analysis, Format number) { return number(analysis.boxCounting->fit.slope); });
    m_lines.last().isPending = !m_analysis->isComplete;
}

void Facts::addMoments() {
    add(tr("Mean"), tr("Mean of the invariant measure, solved exactly: the centre of mass of the picture."),
        m_facts.moments.has_value(),
        [](const Analysis& analysis, Format number) { return pair(analysis.facts.moments->mean, number); });
    add(tr("Covariance"),
        tr("Covariance xx, xy, yy of the invariant measure, solved exactly: how widely the picture spreads. "
           "The ellipse is the one on which an even mass has the same mean and covariance."),
        m_facts.moments.has_value(), [](const Analysis& analysis, Format number) {
            const auto& covariance = analysis.facts.moments->covariance;
            return QStringLiteral("%1, %2, %3")
                .arg(number(covariance(0, 0)), number(covariance(0, 1)), number(covariance(1, 1)));
        });
}

void Facts::addExtents() {
    add(tr("Box"),
        tr("The smallest box with sides parallel to the axes that holds the attractor; certified."),
        m_facts.box.has_value(), [](const Analysis& analysis, Format number) {
            const auto& box = analysis.facts.box;
            return QStringLiteral("[%1, %2] × [%3, %4]")
                .arg(number(box->min.x()), number(box->max.x()), number(box->min.y()), number(box->max.y()));
        });
    add(tr("Canonical simplex"),
        tr("The smallest isosceles right triangle with legs parallel to the axes that holds the attractor; "
           "certified. The signs are the directions of its legs."),
        m_facts.simplex.has_value(), [](const Analysis& analysis, Format number) {
            const auto& simplex = analysis.facts.simplex;
            return tr("%1, leg %2, corner %3")
                .arg(orientationText(simplex->orientation), number(simplex->leg),
                     pair(simplex->vertices[0], number));
        });
    add(tr("Hull area"),
        tr("Area of the convex hull: of the polygon whose vertices were found on the "
           "attractor. The hull itself is larger by at most its border times the error bound."),
        m_facts.hull.has_value(),
        [](const Analysis& analysis, Format number) { return number(analysis.facts.hull->area); });
    add(tr("Hull vertices"),
        tr("Corners of the convex hull as found, each a point of the attractor. A hull "
           "with infinitely many has as many as its tolerance asks for."),
        m_facts.hull.has_value(), [](const Analysis& analysis, Format) {
            return QString::number(analysis.facts.hull->vertices.size());
        });
    add(tr("Hull error bound"), tr("The attractor reaches at most this far beyond the polygon; certified."),
        m_facts.hull.has_value(), [](const Analysis& analysis, Format number) {
            const double error = analysis.facts.hull->error;
            return number == &shortNumber ? bound(error) : number(error);
        });
}

QString word(const std::vector<int>& address, const std::vector<std::size_t>& rows) {
    QStringList letters;
    for (const int letter : address)
        letters << QString::number(rows[std::size_t(letter)] + 1);
    return letters.join(u' ');
}

} // namespace

QString existenceSentence(const ifs::Existence& existence, const std::vector<std::size_t>& rows) {
    const QString factor = shortNumber(existence.contractivity);
    switch (existence.verdict) {
    case ifs::Verdict::Hyperbolic:
        return Facts::tr("Yes: hyperbolic, every map contracts by %1 or less.").arg(factor);
    case ifs::Verdict::EventuallyContractive:
        return Facts::tr("Yes: eventually contractive, every word of %1 maps contracts (%2 a map).")
            .arg(existence.wordLength)
            .arg(factor);
    case ifs::Verdict::None:
        if (existence.witness.size() == 1)
            return Facts::tr("None: map %1 does not contract (%2 a map).")
                .arg(word(existence.witness, rows), factor);
        return Facts::tr("None: the word %1 does not contract (%2 a map).")
            .arg(word(existence.witness, rows), factor);
    case ifs::Verdict::Undecided:
        return Facts::tr("Undecided: no proof either way was found.");
    case ifs::Verdict::Empty:
        return Facts::tr("None: no map takes part.");
    }
    return {};
}

QList<Fact> analysisFacts(std::shared_ptr<const document::Analysis> analysis) {
    return Facts(std::move(analysis)).all();
}

} // namespace view
