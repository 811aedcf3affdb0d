// SPDX-License-Identifier: MIT
#pragma once

#include "document/analysis/analysis.h"
#include "panels/analysis/analysis_facts.h"

#include <QList>
#include <QString>

#include <memory>

// What the *Analysis* panel says of a fractal.
namespace facts_support {

inline QList<view::Fact> factsOf(const document::Fractal& fractal) {
    document::Analyser analyser;
    const auto analysis = analyser.completed(
        analyser.begun({.fractal = std::make_shared<const document::Fractal>(fractal), .outlines = {}}), {});
    return view::analysisFacts(std::make_shared<const document::Analysis>(*analysis));
}

// Empty for a fact that is not there.
inline QString valueOf(const QList<view::Fact>& facts, const QString& name) {
    for (const auto& fact : facts)
        if (fact.name == name) return fact.value;
    return {};
}

} // namespace facts_support
