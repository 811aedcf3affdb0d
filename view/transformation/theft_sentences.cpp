// SPDX-License-Identifier: MIT
#include "transformation/theft_sentences.h"

#include "document/text/text.h"
#include "widgets/numbers/number_text.h"

#include <algorithm>

namespace view {

namespace {

QString sizeText(double size) {
    return size < 99.5 ? QString::number(size, 'g', 2) : QString::number(size, 'f', 0);
}

// The bound as a part of the whole attractor, in per cent.
QString partText(const ifs::Tear& tear) {
    return sizeText(tear.whole > 0 ? std::min(100 * tear.size / tear.whole, 100.0) : 100);
}

QString placeText(const ifs::Tear& tear) {
    const ifs::Vector<2> middle = (tear.place->front() + tear.place->back()) / 2;
    return QStringLiteral("(%1, %2)").arg(shortNumber(middle.x()), shortNumber(middle.y()));
}

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
    return Text::tr("“%1” and “%2” must have the same number of active maps; they have %3 and %4.")
        .arg(from, to, QString::number(flaw.fromCount), QString::number(flaw.toCount));
}

QString sentenceOf(const ifs::Tear& tear) {
    if (!tear.place)
        return tear.isCutShort ? Text::tr("Too many maps to bound the jumps")
                               : Text::tr("Proved continuous: the pieces do not touch");
    const QString text =
        tear.isCutShort
            ? Text::tr(
                  "Proved so far: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3")
            : Text::tr("Proved: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3");
    return text.arg(sizeText(tear.size), partText(tear), placeText(tear));
}

QString sentenceOf(const ifs::Tear& back, ifs::Homeomorphism verdict) {
    if (verdict == ifs::Homeomorphism::Proved) return Text::tr("Proved to be a homeomorphism");
    const bool isRefuted = verdict == ifs::Homeomorphism::Refuted;
    if (!back.place)
        return isRefuted ? Text::tr("Proved not to be a homeomorphism")
                         : Text::tr("Not known whether it is a homeomorphism");
    const QString text =
        isRefuted
            ? Text::tr("Proved not to be a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), "
                       "worst near %3")
            : Text::tr("Not known whether it is a homeomorphism; no jump back exceeds %1 (%2 % of this "
                       "fractal), worst near %3");
    return text.arg(sizeText(back.size), partText(back), placeText(back));
}

} // namespace view
