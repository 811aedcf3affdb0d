// SPDX-License-Identifier: MIT
#include "panels/analysis/existence_sentence.h"

#include "widgets/numbers/number_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace view {

namespace {

struct Sentence {
    Q_DECLARE_TR_FUNCTIONS(Analysis)
};

// Never “1” for what is less.
QString factorText(double factor) {
    const QString text = shortNumber(factor);
    return factor < 1 && text.toDouble() >= 1 ? fullNumber(factor) : text;
}

QString slowSentence(const ifs::Existence& existence) {
    return existence.verdict == ifs::Verdict::Hyperbolic
               ? Sentence::tr("Yes: hyperbolic, but the maps contract by too little to bound anything else.")
               : Sentence::tr(
                     "Yes: the maps contract in some norm, but by too little to bound anything else.");
}

QString contractionSentence(const ifs::Existence& existence) {
    const QString factor = factorText(existence.contractivity);
    switch (existence.norm) {
    case ifs::NormKind::Ellipsoidal:
        return Sentence::tr("Yes: in an ellipsoidal norm, every map has a contraction factor of %1 or less.")
            .arg(factor);
    case ifs::NormKind::Polytope:
        return Sentence::tr(
                   "Yes: in a norm whose unit ball is a polytope, every map has a contraction factor of "
                   "%1 or less.")
            .arg(factor);
    case ifs::NormKind::Euclidean:
    case ifs::NormKind::Words:
        break;
    }
    return Sentence::tr("Yes: any %1 maps in a row contract, by a factor of %2 or less per map.")
        .arg(existence.wordLength)
        .arg(factor);
}

} // namespace

QString rowsOf(const std::vector<int>& word, const std::vector<std::size_t>& rows) {
    QStringList letters;
    for (const int letter : word)
        letters << QString::number(rows[std::size_t(letter)] + 1);
    return letters.join(u' ');
}

QString existenceSentence(const ifs::Existence& existence, const std::vector<std::size_t>& rows) {
    const QString factor = factorText(existence.contractivity);
    if (existence.exists() && !existence.hasFactor()) return slowSentence(existence);
    switch (existence.verdict) {
    case ifs::Verdict::Hyperbolic:
        return Sentence::tr("Yes: hyperbolic, every map has a contraction factor of %1 or less.").arg(factor);
    case ifs::Verdict::EventuallyContractive:
        return contractionSentence(existence);
    case ifs::Verdict::None:
        if (existence.witness.size() == 1)
            return Sentence::tr("None: map %1 contracts in no norm (ρ ≥ 1 is proved; %2 per map).")
                .arg(rowsOf(existence.witness, rows), factor);
        return Sentence::tr("None: the word %1 contracts in no norm (ρ ≥ 1 is proved; %2 per map).")
            .arg(rowsOf(existence.witness, rows), factor);
    case ifs::Verdict::Undecided:
        return Sentence::tr("Undecided: no proof either way was found.");
    case ifs::Verdict::Empty:
        return Sentence::tr("None: no map is active.");
    }
    return {};
}

} // namespace view
