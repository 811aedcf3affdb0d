// SPDX-License-Identifier: MIT
#include "transformation/theft_sentences.h"

#include "widgets/number_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace view {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

QString sizeText(double size) {
    return QString::number(size, 'g', 2);
}

ifs::Vector<2> middleOf(const std::array<ifs::Vector<2>, 2>& place) {
    return (place.front() + place.back()) / 2;
}

QString placeText(const std::array<ifs::Vector<2>, 2>& place) {
    const ifs::Vector<2> middle = middleOf(place);
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
    return Text::tr("“%1” has %2 active maps and “%3” has %4. Both must have the same number.")
        .arg(from)
        .arg(flaw.fromCount)
        .arg(to)
        .arg(flaw.toCount);
}

QString sentenceOf(const ifs::Tear& tear) {
    if (!tear.place) return Text::tr("Continuous: the pieces do not touch");
    const ifs::Vector<2> place = middleOf(*tear.place);
    const QString text = tear.isCutShort ? Text::tr("Continuous to %1 or better, worst at (%2, %3)")
                                         : Text::tr("Continuous to %1, worst at (%2, %3)");
    return text.arg(sizeText(tear.size), shortNumber(place.x()), shortNumber(place.y()));
}

QString sentenceOf(const ifs::Tear& there, const ifs::Tear& back, ifs::Homeomorphism verdict) {
    if (verdict == ifs::Homeomorphism::Proved) return Text::tr("A homeomorphism, as is proved");
    if (verdict == ifs::Homeomorphism::Refuted) {
        if (!back.place) return Text::tr("Not a homeomorphism");
        return Text::tr("Not a homeomorphism: torn by %1 on the way back, worst at %2")
            .arg(sizeText(back.size), placeText(*back.place));
    }
    const bool isCutShort = there.isCutShort || back.isCutShort;
    const QString size = sizeText(std::max(there.size, back.size));
    if (!back.place)
        return (isCutShort ? Text::tr("Homeomorphism to %1 or better") : Text::tr("Homeomorphism to %1"))
            .arg(size);
    return (isCutShort ? Text::tr("Homeomorphism to %1 or better, worst on the way back at %2")
                       : Text::tr("Homeomorphism to %1, worst on the way back at %2"))
        .arg(size, placeText(*back.place));
}

} // namespace view
