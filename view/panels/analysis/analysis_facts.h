// SPDX-License-Identifier: MIT
#pragma once

#include "document/analysis/analysis.h"

#include <QList>
#include <QString>

#include <functional>
#include <memory>

namespace view {

// A line about a picture.
struct Fact {
    QString name;
    QString value;                  // few digits; empty: unknown
    std::function<QString()> exact; // all digits, for copying
    QString definition;
    bool isPending = false; // true while it is being computed
    QString absence{};      // reason why there is no value, after the computation
};

// The same lines in the same order for every system of the plane, and for every system in space.
QList<Fact> analysisFacts(std::shared_ptr<const document::Analysis> analysis);

} // namespace view
