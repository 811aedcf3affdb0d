// SPDX-License-Identifier: MIT
#include "io/table/written_map.h"

#include "io/text/expression.h"
#include "io/text/number.h"

#include <QRegularExpression>

#include <algorithm>

namespace io {

namespace {

using Weights = std::vector<std::optional<double>>;

const QString numberPattern = QStringLiteral(R"((\(*\d*[.]?\d+(?:[eE][-+]?\d+)?(?:\)*/\(*\d+\)*)?)\s*(%)?)");

std::optional<double> weightIn(const QString& text) {
    static const QRegularExpression named(
        QStringLiteral(
            R"((?:\b[pP](?:[_ ]?\{?\w{1,3}\}?)?\s*[&]?[=:]\s*|(?:prob|weight|chance|wahrsch)[^\d=:;\n]{0,24}[&]?[=:]?\s*))") +
            numberPattern,
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression share(QStringLiteral(R"((\d*[.]?\d+)\s*(%))"));
    for (const QRegularExpression& pattern : {named, share}) {
        const auto match = pattern.match(text);
        if (!match.hasMatch()) continue;
        if (const auto value = evaluate(match.captured(1)))
            return match.captured(2).isEmpty() ? *value : *value / 100;
    }
    return std::nullopt;
}

std::optional<double> upperBound(const QString& text) {
    static const QRegularExpression bound(QStringLiteral(R"(<=?\s*(\d*[.]?\d+))"));
    auto found = bound.globalMatch(text);
    std::optional<double> last;
    while (found.hasNext())
        last = parseNumber(found.next().captured(1));
    return last;
}

// Bounds that rise; the last map may have none and takes the rest of 1 or 100.
std::optional<Weights> ofBounds(const QStringList& before) {
    Weights weights;
    double sum = 0;
    for (qsizetype i = 0; i < before.size(); ++i) {
        auto bound = upperBound(before[i]);
        if (!bound && i + 1 == before.size() && i > 0) bound = sum <= 1 ? 1.0 : 100.0;
        if (!bound || *bound < sum) return std::nullopt;
        weights.push_back(*bound - sum);
        sum = *bound;
    }
    return weights;
}

// Numbers beside the functions of a list of pairs: (0.01, lambda x, y: …), or (lambda x, y: …, 0.01).
Weights ofPairs(const QStringList& between, bool isBefore) {
    static const QRegularExpression before(QStringLiteral(R"([\(\[{]\s*(\d*[.]?\d+)\s*,\s*$)"));
    static const QRegularExpression behind(QStringLiteral(R"(^\s*[\)\]]?\s*,\s*(\d*[.]?\d+)\s*[\)\]}])"));
    Weights weights;
    for (qsizetype i = isBefore ? 0 : 1; i < between.size() - (isBefore ? 1 : 0); ++i) {
        const auto match = (isBefore ? before : behind).match(between[i]);
        weights.push_back(match.hasMatch() ? parseNumber(match.captured(1)) : std::nullopt);
    }
    return weights;
}

bool areComplete(const Weights& weights) {
    return std::ranges::all_of(weights, [](const auto& weight) { return weight.has_value(); });
}

} // namespace

QString tableOf(const std::vector<WrittenMap>& maps) {
    const std::size_t count = maps.front().numbers.size();
    const bool hasWeights = std::ranges::all_of(maps, [](const auto& map) { return map.weight.has_value(); });
    const QString letters = count > 6 ? QStringLiteral("abcdefghijkl") : QStringLiteral("abcdef");
    QStringList names = letters.split(QString(), Qt::SkipEmptyParts);
    if (hasWeights) names << QStringLiteral("p");
    QString table = names.join(u'\t') + u'\n';
    for (const WrittenMap& map : maps) {
        if (map.numbers.size() != count) return {};
        QByteArrayList cells;
        for (const double number : map.numbers)
            cells << formatNumber(number);
        if (hasWeights) cells << formatNumber(*map.weight);
        table += QString::fromLatin1(cells.join('\t')) + u'\n';
    }
    return table;
}

std::vector<std::optional<double>> weightsBetween(const QStringList& between) {
    Weights found;
    for (const QString& text : between)
        found.push_back(weightIn(text));
    Weights behind(found.begin() + 1, found.end());
    if (areComplete(behind)) return behind;
    Weights before(found.begin(), found.end() - 1);
    if (areComplete(before)) return before;
    for (const bool isBefore : {true, false})
        if (Weights beside = ofPairs(between, isBefore); areComplete(beside)) return beside;
    if (auto bounds = ofBounds(between.first(between.size() - 1))) return *std::move(bounds);
    const auto given = [](const Weights& weights) {
        return std::ranges::count_if(weights, [](const auto& weight) { return weight.has_value(); });
    };
    Weights& more = given(behind) >= given(before) ? behind : before;
    const bool areMeant = 2 * given(more) >= qsizetype(more.size());
    return areMeant ? std::move(more) : Weights(behind.size());
}

} // namespace io
