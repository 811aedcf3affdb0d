// SPDX-License-Identifier: MIT
#include "io/report/facts.h"

#include "io/report/facts_of_entry.h"
#include "io/report/facts_of_extent.h"
#include "io/report/facts_of_pieces.h"

#include <QStringList>

namespace io {

namespace {

// The keys that are null without the fact; nullopt: without any.
QStringList keysWithout(std::optional<ifs::LongFact> fact) {
    QStringList keys;
    const ifs::Facts<2> none;
    const document::Shape<2> empty;
    const FactSource<2> source{.facts = none, .shape = &empty};
    for (const Fact& row : facts<2>(source)) {
        if (!row.lateWith) continue;
        JsonSchema object;
        JsonMembers members(object);
        if (!fact || row.lateWith == fact)
            for (const auto& list : row.members)
                list(members);
        for (const auto& member : object.members)
            if (member.isRequired) keys << member.key;
        const bool isOfHull = row.lateWith == ifs::LongFact::Hull;
        if (isOfHull && fact.value_or(ifs::LongFact::ExtremePoints) == ifs::LongFact::ExtremePoints)
            keys << QStringLiteral("addresses"); // of its vertices
    }
    return keys;
}

void describeLateKey(JsonSchema& schema) {
    schema = JsonSchema::oneOf(keysWithout({}));
    schema.remark = QStringLiteral("What was not computed within the --budget; it is null. Of the hull, only "
                                   "the addresses may be missing.");
}
using LateKey = Described<QString, describeLateKey>;

template <int Dim> std::vector<LateKey> lateKeys(const ifs::Facts<Dim>& facts) {
    std::vector<LateKey> keys;
    for (const ifs::LongFact fact : facts.late)
        for (const QString& key : keysWithout(fact))
            keys.push_back({key});
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
