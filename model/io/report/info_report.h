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
    QString fileName; // name as given by the user
    QString format;   // "fractint", "png", "svg" …
    QList<document::Entry> entries;
    document::Problems problems;
    std::optional<double> hullTolerance;
    ifs::FactLimits limits = {};                             // limits of each entry
    std::optional<ifs::ProcessorClock::time_point> end = {}; // time after which no fact of any entry is begun
    std::optional<animation::Moment> moment = {};            // moment of all facts
    std::function<void(qsizetype)> begun = {};               // called with the index of each entry
    std::function<void(const document::Problem&)> remark = {}; // called for requests that were not met
};

// The facts of the system of an entry, with a remark where the hull is not as near as it was asked to be.
template <int Dim>
ifs::Facts<Dim> factsFor(const ifs::IteratedFunctionSystem<Dim>& system, const document::Entry& entry,
                         const InfoSubject& subject);

// The entry at the moment that the report is about.
document::Fractal momentOf(const document::Entry& entry, const InfoSubject& subject);

} // namespace io
