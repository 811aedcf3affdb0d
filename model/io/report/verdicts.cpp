// SPDX-License-Identifier: MIT
#include "io/report/verdicts.h"

#include "document/text/text.h"
#include "ifs/dimension/dimension.h"

#include <QStringList>

namespace io {

namespace {

// "= 0.85", with as many digits as it takes not to look like 1, which nothing that contracts has.
QString belowOne(double contractivity) {
    constexpr int usual = 6, maxDigits = 17;
    for (int precision = usual; precision <= maxDigits; ++precision) {
        const QString text = QString::number(contractivity, 'g', precision);
        if (text != u"1") return QStringLiteral("= ") + text;
    }
    return QStringLiteral("< 1");
}

QString contractionSentence(const ifs::Existence& existence) {
    if (!existence.hasFactor()) return Text::tr("contractive in some norm, γ < 1");
    const QString factor = belowOne(existence.contractivity);
    switch (existence.norm) {
    case ifs::NormKind::Ellipsoidal:
        return Text::tr("contractive in an ellipsoidal norm, γ %1").arg(factor);
    case ifs::NormKind::Polytope:
        return Text::tr("contractive in a polytope norm, γ %1").arg(factor);
    case ifs::NormKind::Euclidean:
    case ifs::NormKind::Words:
        break;
    }
    return Text::tr("eventually contractive, γ %1 from words of length %2")
        .arg(factor)
        .arg(existence.wordLength);
}

} // namespace

QString wordText(const ifs::Word& word, const std::vector<std::size_t>& rows) {
    QStringList letters;
    for (const int symbol : word)
        letters << QString::number(rows[std::size_t(symbol)] + 1);
    return letters.join(u' ');
}

QString verdictText(const ifs::Existence& existence, const std::vector<std::size_t>& rows) {
    switch (existence.verdict) {
    case ifs::Verdict::Hyperbolic:
        return Text::tr("hyperbolic, s %1").arg(belowOne(existence.contractivity));
    case ifs::Verdict::EventuallyContractive:
        return contractionSentence(existence);
    case ifs::Verdict::None:
        return Text::tr("none: ρ(A) ≥ 1 for the word %1").arg(wordText(existence.witness, rows));
    case ifs::Verdict::Undecided:
        return Text::tr("undecided");
    case ifs::Verdict::Empty:
        break;
    }
    return Text::tr("none: no map is active");
}

QString separationText(ifs::Separation separation) {
    switch (separation) {
    case ifs::Separation::Strong:
        return Text::tr("strong: no two pieces meet");
    case ifs::Separation::Overlapping:
        return Text::tr("none: pieces coincide");
    case ifs::Separation::Unknown:
        break;
    }
    return Text::tr("unknown");
}

QString connectednessText(ifs::Connectedness connectedness) {
    switch (connectedness) {
    case ifs::Connectedness::Connected:
        return Text::tr("connected");
    case ifs::Connectedness::ConnectedToRounding:
        return Text::tr("connected, within rounding error");
    case ifs::Connectedness::Disconnected:
        return Text::tr("not connected");
    case ifs::Connectedness::Unknown:
        break;
    }
    return Text::tr("unknown");
}

QString openSetText(const ifs::OpenSetFacts& facts) {
    const bool isExact = facts.certainty == ifs::Certainty::Exact;
    switch (facts.condition) {
    case ifs::OpenSetCondition::Holds:
        return isExact ? Text::tr("holds") : Text::tr("holds, within rounding error");
    case ifs::OpenSetCondition::Fails:
        return isExact ? Text::tr("fails") : Text::tr("fails, within rounding error");
    case ifs::OpenSetCondition::Unknown:
        break;
    }
    return Text::tr("unknown");
}

QString roundingNote(bool isExact) {
    return isExact ? QString() : u' ' + Text::tr("(within rounding error)");
}

template <int Dim> QString openSetNote(const ifs::Facts<Dim>& facts) {
    if (facts.similarityDimension == 0.0) return {}; // no lower value
    const ifs::Invariants& invariants = facts.invariants;
    if (facts.similarityDimension && ifs::exceedsSpace(*facts.similarityDimension, Dim))
        return u' ' + Text::tr("(upper bound: the open set condition fails)");
    switch (invariants.contacts ? invariants.contacts->separation : ifs::Separation::Unknown) {
    case ifs::Separation::Strong:
        return u' ' + Text::tr("(of the attractor: its pieces are disjoint)");
    case ifs::Separation::Overlapping:
        return u' ' + Text::tr("(upper bound: pieces coincide)");
    case ifs::Separation::Unknown:
        break;
    }
    if (!invariants.openSet || invariants.openSet->condition == ifs::OpenSetCondition::Unknown)
        return u' ' + Text::tr("(if the open set condition holds; else an upper bound)");
    if (invariants.openSet->condition == ifs::OpenSetCondition::Fails)
        return u' ' + Text::tr("(upper bound: the open set condition fails)");
    return u' ' + (invariants.openSet->certainty == ifs::Certainty::Exact
                       ? Text::tr("(the open set condition holds)")
                       : Text::tr("(the open set condition holds, within rounding error)"));
}

template QString openSetNote<2>(const ifs::Facts<2>&);
template QString openSetNote<3>(const ifs::Facts<3>&);

} // namespace io
