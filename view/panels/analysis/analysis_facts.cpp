// SPDX-License-Identifier: MIT
#include "panels/analysis/analysis_facts.h"

#include "io/report/facts.h"
#include "io/report/figure_error.h"
#include "widgets/numbers/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace view {

namespace {

using document::Analysis;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Analysis)
};

constexpr int shownDigits = 5, allDigits = 15;

// A figure with more digits than usual if things of that size lie far from 0.
QString shortFigure(double value, double error, double size) {
    constexpr double far = 1e4; // multiples of the size
    const bool isFar = size > 0 && std::abs(value) > far * size;
    return isFar ? io::figure(value, error, size, shownDigits) : shortNumber(value);
}

QString fullFigure(double value, double /*error*/, double /*size*/) {
    return fullNumber(value);
}

const io::Figures shortFigures{.text = shortFigure,
                               .count = [](std::size_t number) { return groupedNumber(double(number)); },
                               .bound = io::boundText,
                               .digits = shownDigits,
                               .isAbridged = true};
const io::Figures fullFigures{.text = fullFigure,
                              .count = [](std::size_t number) { return QString::number(number); },
                              .bound = fullNumber,
                              .digits = allDigits};

// Why facts without a reason of their own are missing, and all where there may be nothing to measure.
QString absenceOf(const ifs::Existence& existence, const QString& reason) {
    if (existence.verdict == ifs::Verdict::Undecided)
        return Texts::tr("There is no value, because it is not proved that there is an attractor.");
    if (!existence.exists()) return Texts::tr("There is no value, because there is no attractor.");
    if (!existence.hasFactor())
        return Texts::tr("There is no value, because the maps contract by too little to bound it.");
    return reason.isEmpty() ? Texts::tr("There is no value: for these maps, none could be computed.")
                            : reason;
}

// Data that the rows refer to, for as long as a line is shown.
template <int Dim> struct Shown {
    Shown(std::shared_ptr<const Analysis> given, const io::FactSource<Dim>& known)
        : analysis(std::move(given)), source(known), rows(io::facts(source)) {}
    Q_DISABLE_COPY_MOVE(Shown)

    std::shared_ptr<const Analysis> analysis;
    io::FactSource<Dim> source;
    std::vector<io::Fact> rows; // these refer to `source`
};

template <int Dim>
QList<Fact> factsOf(std::shared_ptr<const Analysis> analysis, const ifs::Facts<Dim>& known) {
    const auto shown = std::make_shared<Shown<Dim>>(
        analysis, io::FactSource<Dim>{.facts = known, .analysis = analysis.get()});
    std::erase_if(shown->rows, [](const io::Fact& row) { return row.definition.isEmpty(); });
    std::ranges::stable_sort(shown->rows, {}, &io::Fact::group);
    QList<Fact> facts;
    for (const io::Fact& row : shown->rows) {
        const auto& text = row.shown ? row.shown : row.value;
        Fact fact{row.title, text(shortFigures).value_or(QString()),
                  [shown, &text] { return text(fullFigures).value_or(QString()); }, row.definition};
        fact.isPending = !analysis->isComplete && (row.takesLong || row.group == io::FactGroup::Pieces);
        if (fact.value.isEmpty()) fact.absence = absenceOf(known.existence, row.absence);
        facts << fact;
    }
    return facts;
}

} // namespace

QList<Fact> analysisFacts(std::shared_ptr<const Analysis> analysis) {
    return analysis->solid ? factsOf<3>(analysis, *analysis->solid) : factsOf<2>(analysis, analysis->facts);
}

} // namespace view
