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
    QString value;                  // short digits; empty: not known
    std::function<QString()> exact; // all digits, to copy
    QString definition;
    bool isPending = false; // still being worked out
    QString absence{};      // why there is no value, once that is worked out
};

// The same lines in the same order for every system of the plane, and for every system in space.
QList<Fact> analysisFacts(std::shared_ptr<const document::Analysis> analysis);

} // namespace view
