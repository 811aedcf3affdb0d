// SPDX-License-Identifier: MIT
#include "transformation/theft_sentences.h"

#include "widgets/number_text.h"

#include <QCoreApplication>

namespace view {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

} // namespace

QString sentenceOf(const document::CouplingOutcome& flaw, const QString& from, const QString& to) {
    const QString& name = flaw.isOfSecond ? to : from;
    switch (flaw.flaw) {
    case document::CouplingFlaw::NotInPlane:
        return Text::tr("“%1” is not a system in the plane.").arg(name);
    case document::CouplingFlaw::BentCage:
        return Text::tr("The cage of “%1” is flat or bends the picture. Bake or reset it first.").arg(name);
    case document::CouplingFlaw::NoMaps:
        return Text::tr("“%1” has no active map, so there is nothing to draw.").arg(name);
    case document::CouplingFlaw::Linked:
        return Text::tr("The maps of “%1” are linked, so not every address is one of its points.").arg(name);
    case document::CouplingFlaw::NoAttractor:
        return Text::tr("No attractor could be proved for “%1”, so its points have no addresses.").arg(name);
    case document::CouplingFlaw::Order:
        return Text::tr("The stored order does not list every active map of “%1” once.").arg(name);
    case document::CouplingFlaw::Counts:
        break;
    }
    return Text::tr("“%1” has %2 active maps and “%3” has %4. Both must have the same number.")
        .arg(from)
        .arg(flaw.fromCount)
        .arg(to)
        .arg(flaw.toCount);
}

QString sentenceOf(const ifs::Tear& tear) {
    if (!tear.place) return Text::tr("Continuous: the pieces do not touch");
    const ifs::Vector<2> place = (tear.place->front() + tear.place->back()) / 2;
    const QString text = tear.isCutShort ? Text::tr("Continuous to %1 or better, worst at (%2, %3)")
                                         : Text::tr("Continuous to %1, worst at (%2, %3)");
    return text.arg(QString::number(tear.size, 'g', 2), shortNumber(place.x()), shortNumber(place.y()));
}

} // namespace view
