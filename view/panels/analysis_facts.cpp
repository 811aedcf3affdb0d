// SPDX-License-Identifier: MIT
#include "panels/analysis_facts.h"

#include "cage_edits.h"
#include "ifs/attractor_existence.h"
#include "ifs/dimension.h"
#include "ifs/moments.h"
#include "ifs/support_function.h"
#include "panels/number_text.h"

#include <QCoreApplication>

#include <utility>

namespace view {

namespace {

class Facts {
    Q_DECLARE_TR_FUNCTIONS(Analysis)

public:
    explicit Facts(const document::System2& system) : m_system(system), m_active(ifs::activeMaps(system)) {}
    QList<Fact> all();

private:
    using Format = QString (*)(double);
    struct Text {
        QString shown;
        QString exact;
    };
    // The same text with few and with all digits.
    template <class Writer> static Text both(Writer write) {
        return {write(&shortNumber), write(&fullNumber)};
    }
    static QString pair(const ifs::Vector<2>& v, Format number) {
        return QStringLiteral("(%1, %2)").arg(number(v.x()), number(v.y()));
    }
    void add(const QString& name, const Text& text, const QString& definition) {
        m_facts.append({name, text.shown, text.exact, definition});
    }
    void addContraction();
    void addExtents();
    void addDimensions();
    void addMoments();

    const document::System2& m_system;
    ifs::ActiveMaps<2> m_active;
    QList<Fact> m_facts;
};

QList<Fact> Facts::all() {
    const QString verdict = existenceSentence(m_system);
    add(tr("Attractor"), {verdict, verdict},
        tr("A system has one attractor if some power of it contracts: then every start leads to the same "
           "set."));
    addContraction();
    addExtents();
    addDimensions();
    addMoments();
    return m_facts;
}

void Facts::addContraction() {
    if (m_active.maps.empty()) return;
    add(tr("Contraction"), both([this](Format number) {
            QStringList factors;
            for (const auto& map : m_active.maps)
                factors << number(ifs::spectralNorm<2>(map.linear));
            return factors.join(QStringLiteral("  "));
        }),
        tr("‖A‖ of each map that takes part: the most by which it stretches distances."));
}

void Facts::addExtents() {
    const auto support = ifs::SupportFunction<2>::of(m_active.maps);
    if (!support) return;
    const double tolerance = 1e-10 * support->radius();
    const auto box = ifs::boundingBox(*support, tolerance);
    add(tr("Box"), both([&](Format number) {
            return QStringLiteral("[%1, %2] × [%3, %4]")
                .arg(number(box.min.x()), number(box.max.x()), number(box.min.y()), number(box.max.y()));
        }),
        tr("The smallest box with sides parallel to the axes that holds the attractor; certified."));
    const auto simplex = ifs::minimalCanonicalSimplex(*support, tolerance);
    add(tr("Canonical simplex"), both([&](Format number) {
            return tr("%1, leg %2, corner %3")
                .arg(orientationText(simplex.orientation), number(simplex.leg),
                     pair(simplex.vertices[0], number));
        }),
        tr("The smallest isosceles right triangle with legs parallel to the axes that holds the attractor. "
           "The signs "
           "are the directions of its legs."));
    const auto hull = ifs::convexHull(*support, 1e-4 * support->radius());
    add(tr("Convex hull area"), both([&](Format number) { return number(hull.area); }),
        tr("Area of the convex hull's inner polygon with %1 vertices; the hull reaches at most %2 beyond it.")
            .arg(hull.vertices.size())
            .arg(shortNumber(hull.error)));
}

void Facts::addDimensions() {
    if (const auto dimension = ifs::similarityDimension<2>(m_active.maps))
        add(tr("Similarity dimension"), both([&](Format number) { return number(*dimension); }),
            tr("The D with Σ sᵢᴰ = 1 over the ratios sᵢ. It is the dimension of the attractor when the "
               "pieces do not "
               "overlap."));
}

void Facts::addMoments() {
    const auto moments = ifs::moments(m_active);
    if (!moments) return;
    add(tr("Mean"), both([&](Format number) { return pair(moments->mean, number); }),
        tr("Mean of the invariant measure, solved exactly: the centre of mass of the picture."));
    const auto& covariance = moments->covariance;
    add(tr("Covariance"), both([&](Format number) {
            return QStringLiteral("%1, %2, %3")
                .arg(number(covariance(0, 0)), number(covariance(0, 1)), number(covariance(1, 1)));
        }),
        tr("Covariance xx, xy, yy of the invariant measure, solved exactly: how widely the picture "
           "spreads."));
}

QString word(const std::vector<int>& address) {
    QStringList letters;
    for (const int letter : address)
        letters << QString::number(letter + 1);
    return letters.join(u' ');
}

} // namespace

QString existenceSentence(const document::System2& system) {
    const auto active = ifs::activeMaps(system);
    const auto existence = ifs::classify<2>(active.maps);
    const auto tr = [](const char* text) { return QCoreApplication::translate("Analysis", text); };
    // The witness counts maps that take part; the user counts rows.
    std::vector<int> rows;
    for (const int letter : existence.witness)
        rows.push_back(static_cast<int>(active.index[static_cast<std::size_t>(letter)]));
    const QString factor = shortNumber(existence.contractivity);
    switch (existence.verdict) {
    case ifs::Verdict::Hyperbolic:
        return tr(QT_TRANSLATE_NOOP("Analysis", "Yes: hyperbolic, every map contracts by %1 or less."))
            .arg(factor);
    case ifs::Verdict::EventuallyContractive:
        return tr(QT_TRANSLATE_NOOP("Analysis",
                                    "Yes: eventually contractive, every word of %1 maps contracts (%2 a "
                                    "map)."))
            .arg(existence.wordLength)
            .arg(factor);
    case ifs::Verdict::None:
        return tr(QT_TRANSLATE_NOOP("Analysis", "None: the word %1 does not contract (%2 a map)."))
            .arg(word(rows), factor);
    case ifs::Verdict::Undecided:
        return tr(QT_TRANSLATE_NOOP("Analysis", "Undecided: no proof either way was found."));
    case ifs::Verdict::Empty:
        return tr(QT_TRANSLATE_NOOP("Analysis", "None: no map takes part."));
    }
    return {};
}

QList<Fact> analysisFacts(const document::Fractal& fractal) {
    const document::System2* system = document::system2(fractal);
    return system ? Facts(*system).all() : QList<Fact>{};
}

} // namespace view
