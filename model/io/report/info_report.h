// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/moment.h"
#include "document/fractal_file.h"
#include "ifs/facts.h"
#include "ifs/processor_clock.h"

#include <QList>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace io {

// Subject of a report.
struct InfoSubject {
    QString fileName; // as the user gave it
    QString format;   // "fractint", "png", "svg" …
    QList<document::Entry> entries;
    document::Problems problems;
    std::optional<double> hullTolerance;
    ifs::FactLimits limits = {};                               // for each entry
    std::optional<ifs::ProcessorClock::time_point> end = {};   // no fact of any entry begins after it
    std::optional<animation::Moment> moment = {};              // all facts are those of this one
    std::function<void(qsizetype)> begun = {};                 // the entry of this index
    std::function<void(const document::Problem&)> remark = {}; // about requests that were not met
};

// The facts of the system of an entry, with a remark where the hull is not as near as it was asked to be.
template <int Dim>
ifs::Facts<Dim> factsFor(const ifs::IteratedFunctionSystem<Dim>& system, const document::Entry& entry,
                         const InfoSubject& subject);

// The entry at the moment that the report is about.
document::Fractal momentOf(const document::Entry& entry, const InfoSubject& subject);

} // namespace io
