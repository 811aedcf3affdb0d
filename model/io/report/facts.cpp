// SPDX-License-Identifier: MIT
#include "io/report/facts.h"

#include "io/report/facts_of_entry.h"
#include "io/report/facts_of_extent.h"
#include "io/report/facts_of_pieces.h"

#include <QStringList>

#include <vector>

namespace io {

namespace {

// A key that is null without a fact.
struct LateMember {
    ifs::LongFact fact;
    QString key;
};

std::vector<LateMember> findLateMembers() {
    std::vector<LateMember> found;
    const ifs::Facts<2> none;
    const document::Shape<2> empty;
    const FactSource<2> source{.facts = none, .shape = &empty};
    for (const Fact& row : facts<2>(source)) {
        if (!row.lateWith) continue;
        JsonSchema object;
        JsonMembers members(object);
        for (const auto& list : row.members)
            list(members);
        for (const auto& member : object.members)
            if (member.isRequired) found.push_back({*row.lateWith, member.key});
        if (row.lateWith == ifs::LongFact::Hull) // part of the hull
            found.push_back({ifs::LongFact::ExtremePoints, QStringLiteral("addresses")});
    }
    return found;
}

const std::vector<LateMember>& lateMembers() {
    static const std::vector<LateMember> members = findLateMembers();
    return members;
}

void describeLateKey(JsonSchema& schema) {
    QStringList keys;
    for (const LateMember& member : lateMembers())
        keys << member.key;
    schema = JsonSchema::oneOf(keys);
    schema.remark = QStringLiteral("What was not computed within the --budget; it is null. Of the hull, only "
                                   "the addresses may be missing.");
}
using LateKey = Described<QString, describeLateKey>;

template <int Dim> std::vector<LateKey> lateKeys(const ifs::Facts<Dim>& facts) {
    std::vector<LateKey> keys;
    for (const ifs::LongFact fact : facts.late)
        for (const LateMember& member : lateMembers())
            if (member.fact == fact) keys.push_back({member.key});
    return keys;
}

} // namespace

template <int Dim> FactRows facts(const FactSource<Dim>& source) {
    FactRows rows;
    addMapFacts(rows, source);
    addMoments(rows, source);
    addExtents(rows, source);
    addHull(rows, source);
    addDimensions(rows, source);
    add(rows).member("out_of_time", [&source] { return lateKeys(source.facts); });
    addPieces(rows, source);
    addMeasure(rows, source);
    addEntryFacts(rows, source);
    return rows;
}

template FactRows facts<2>(const FactSource<2>&);
template FactRows facts<3>(const FactSource<3>&);

} // namespace io
