// SPDX-License-Identifier: MIT
#pragma once

#include "document/analysis/analysis.h"
#include "document/fractal/fractal.h"
#include "ifs/facts.h"
#include "io/report/json_members.h"

#include <QCoreApplication>
#include <QString>

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

// Facts of a system: a row for each, from which follow the report of `barycage-cli info`, its JSON and
// schema, and the *Analysis* panel.
namespace io {

// Data that the rows read.
template <int Dim> struct FactSource {
    const ifs::Facts<Dim>& facts;
    const document::Analysis* analysis = nullptr; // source in the panel
    const document::Shape<Dim>* shape = nullptr;  // source in a report
    bool withAffinityDimension = true;            // true if it was requested

    // Returns true if no part of the analysis is still under way.
    bool isComplete() const { return !analysis || analysis->isComplete; }
};

// Formatting of numbers.
struct Figures {
    // Texts of numbers of things of that size, which may be off by the error; 0: as a number alone.
    QString (*text)(double value, double error, double size);
    QString (*count)(std::size_t number);
    QString (*bound)(double error);
    int digits = 0;          // significant digits of an error; fewer are not shown
    bool isAbridged = false; // true: long lists are shortened

    QString operator()(double value, double error = 0, double size = 0) const {
        return text(value, error, size);
    }
    std::optional<QString> known(const std::optional<double>& value) const {
        return value ? std::optional(text(*value, 0, 0)) : std::nullopt;
    }
    QString note(const std::vector<double>& values, double error, double size) const;
};

// The lines of a report, each with its name.
class FactLines {
public:
    void add(const QString& name, const QString& value);
    void title(const QString& text) { m_text += text + u'\n'; }
    const QString& text() const { return m_text; }

private:
    QString m_text;
};

// The groups in the order of the panel. Reports have the order of the rows.
enum class FactGroup { Maps, Dimensions, Moments, Extents, Hull, Pieces };

// Whether a report has a line for a fact that would take too long.
enum class Late { Silent, Said };

// A row. It refers to its source, which must outlive it.
class Fact {
public:
    using Text = std::function<std::optional<QString>(const Figures&)>;

    explicit Fact(QString name) : label(std::move(name)) {}

    QString label; // label in the report
    // The line in the report: "unknown" if the text is empty, no line for nullopt.
    Text value{};
    std::function<void(FactLines&)> lines{}; // lines of the report, in place of a value
    std::vector<std::function<void(JsonMembers&)>> members{};
    std::optional<ifs::LongFact> lateWith{}; // fact without which there is no value
    Late late = Late::Silent;
    QString title{}, definition{}; // texts of the panel, if any
    Text shown{};                  // value in the panel; null: same as in the report
    FactGroup group = FactGroup::Pieces;
    bool takesLong = false; // true if computed last, as all facts about pieces are
    QString absence{};      // reason why there is no value although there is an attractor

    template <class Source>
    Fact& written(const Source& source, std::optional<QString> (*text)(const Source&, const Figures&)) {
        value = [&source, text](const Figures& number) { return text(source, number); };
        return *this;
    }
    // A number or nothing, in reports and in JSON.
    Fact& written(const char* key, const std::optional<double>& number, const char* remark = "") {
        value = [number](const Figures& figures) { return figures.known(number); };
        return member(key, number, remark);
    }
    template <class Source> Fact& inLines(const Source& source, void (*write)(const Source&, FactLines&)) {
        lines = [&source, write](FactLines& out) { write(source, out); };
        return *this;
    }
    // Adds a member: a value, or a function that works it out when it is needed.
    template <class T> Fact& member(const char* key, T member, const char* remark = "") {
        members.push_back([=](JsonMembers& out) {
            if constexpr (std::is_invocable_v<T>)
                out(key, member(), remark);
            else
                out(key, member, remark);
        });
        return *this;
    }
    Fact& mark(const char* key, bool isTrue, const char* remark) {
        members.push_back([=](JsonMembers& out) { out.mark(key, isTrue, remark); });
        return *this;
    }
    Fact& isLateWith(ifs::LongFact fact, Late said) {
        lateWith = fact;
        late = said;
        return *this;
    }
    Fact& inPanel(FactGroup where, const QString& name, const QString& meaning, const QString& reason = {}) {
        group = where;
        title = name;
        definition = meaning;
        absence = reason;
        return *this;
    }
    template <class Source>
    Fact& shownAs(const Source& source, std::optional<QString> (*text)(const Source&, const Figures&)) {
        shown = [&source, text](const Figures& number) { return text(source, number); };
        return *this;
    }
};

using FactRows = std::vector<Fact>;

inline Fact& add(FactRows& rows, const QString& label = {}) {
    return rows.emplace_back(label);
}

// Sentences of the panel.
struct Panel {
    Q_DECLARE_TR_FUNCTIONS(Analysis)
};

// The text for a value whose error bound leaves nothing of it, or that could not be computed.
QString unknown();

// The numbers of reports: six digits.
const Figures& reportFigures();

// Digits as in reports, rounded up.
QString upperDigits(double number);

// The diagonal of the box, or the spread of the measure where there is none.
template <int Dim> double sizeOf(const ifs::Facts<Dim>& facts);

// "(1, 2)"
template <int Dim>
QString tuple(const ifs::Vector<Dim>& point, double error, double size, const Figures& number);
// The same with what is noise as 0, and " ± …" where the error shows.
template <int Dim>
QString tupleWithError(const ifs::Vector<Dim>& point, double error, double size, const Figures& number);

} // namespace io
