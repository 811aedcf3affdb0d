// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QList>
#include <QString>

namespace view {

// One line of what is known of a code.
struct Fact {
    QString name;
    QString value; // short digits
    QString exact; // all digits, to copy
    QString definition;
};

// Facts of the code (not of its placement) that cost a few milliseconds. Empty for an entry without a plane
// system.
QList<Fact> analysisFacts(const document::Fractal& fractal);

// Whether the system has an attractor, and why, in one sentence; maps are numbered from 1.
QString existenceSentence(const document::System2& system);

} // namespace view
