// SPDX-License-Identifier: MIT
#include "io/report/info_report.h"

#include "document/moments/animated_fractal.h"
#include "document/text/text.h"
#include "io/report/figure_error.h"

#include <algorithm>
#include <limits>

namespace io {

namespace {

// Error of the hull up to which no remark is made. Without a requested tolerance it may be twice the usual
// one, since finding the addresses of its vertices can add to the error, plus the rounding far from the
// origin.
template <int Dim> double bearableError(const ifs::Facts<Dim>& facts, std::optional<double> wanted) {
    if (wanted) return *wanted;
    if (!facts.box) return std::numeric_limits<double>::infinity();
    const double distance = facts.box->min.cwiseAbs().cwiseMax(facts.box->max.cwiseAbs()).stableNorm();
    return 2 * ifs::usualHullTolerance(*facts.box) + 1e-12 * distance;
}

} // namespace

template <int Dim>
ifs::Facts<Dim> factsFor(const ifs::IteratedFunctionSystem<Dim>& system, const document::Entry& entry,
                         const InfoSubject& subject) {
    ifs::FactLimits limits = subject.limits;
    if (subject.end) {
        const auto left = *subject.end - ifs::ProcessorClock::now();
        limits.together = limits.together ? std::min(*limits.together, left) : left;
    }
    ifs::Facts<Dim> facts = ifs::factsOf(system, subject.hullTolerance, limits);
    const auto& wanted = subject.hullTolerance;
    if (subject.remark && facts.hull && facts.hull->error > bearableError(facts, wanted)) {
        document::Problem problem;
        problem.entry = entry.fractal->name;
        problem.line = entry.source ? entry.source->line : 0;
        problem.column = problem.line > 0 ? 1 : 0;
        problem.message =
            Text::tr("The convex hull has an error of up to %1: the tolerance %2 "
                     "was not reached.")
                .arg(boundText(facts.hull->error))
                .arg(wanted ? *wanted : ifs::usualHullTolerance(*facts.box), 0, 'g', wanted ? 6 : 2);
        subject.remark(problem);
    }
    return facts;
}

template ifs::Facts<2> factsFor(const ifs::IteratedFunctionSystem<2>&, const document::Entry&,
                                const InfoSubject&);
template ifs::Facts<3> factsFor(const ifs::IteratedFunctionSystem<3>&, const document::Entry&,
                                const InfoSubject&);

document::Fractal momentOf(const document::Entry& entry, const InfoSubject& subject) {
    return subject.moment ? document::frameAt(*entry.fractal, *subject.moment).fractal : *entry.fractal;
}

} // namespace io
