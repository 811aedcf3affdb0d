// SPDX-License-Identifier: MIT
#include "io/report/info_text.h"

#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"
#include "document/moments/animated_fractal.h"
#include "document/text/text.h"
#include "io/report/facts.h"

#include <algorithm>

namespace io {

namespace {

void addFact(FactLines& lines, const Fact& row, const std::vector<ifs::LongFact>& late) {
    if (row.lines) return row.lines(lines);
    if (row.late == Late::Said && std::ranges::count(late, *row.lateWith) > 0)
        return lines.add(row.label, Text::tr("not computed within the budget"));
    if (!row.value) return;
    if (const auto text = row.value(reportFigures()))
        lines.add(row.label, text->isEmpty() ? unknown() : *text);
}

template <int Dim>
void addShape(FactLines& lines, const document::Shape<Dim>& shape, const document::Entry& entry,
              const InfoSubject& subject) {
    const ifs::Facts<Dim> known = factsFor(ifs::expanded(shape.system), entry, subject);
    const FactSource<Dim> source{
        .facts = known, .shape = &shape, .withAffinityDimension = subject.limits.withAffinityDimension};
    for (const Fact& row : facts(source))
        addFact(lines, row, known.late);
    for (const auto& [branch, recurs] : document::storedBranches(shape)) {
        const QString address = document::addressText(branch.word, branch.word.size());
        lines.add(Text::tr("moved branch"),
                  recurs ? Text::tr("%1, and inside itself").arg(address) : address);
    }
    if (!shape.moved.empty())
        lines.add(Text::tr("moved branches"),
                  Text::tr("all figures are those of the code, where no branch is moved"));
}

QString mapCount(std::size_t maps) {
    return maps == 1 ? Text::tr("1 map") : Text::tr("%1 maps").arg(maps);
}

// "maple — in the plane, 4 maps"
QString titleOf(const document::Fractal& fractal) {
    const auto* space = document::system3(fractal);
    return space ? Text::tr("%1 — in space, %2").arg(fractal.name, mapCount(space->maps.size()))
                 : Text::tr("%1 — in the plane, %2")
                       .arg(fractal.name, mapCount(document::system2(fractal)->maps.size()));
}

QString loopText(animation::Loop loop) {
    switch (loop) {
    case animation::Loop::Cycle:
        return Text::tr("in a cycle");
    case animation::Loop::ThereAndBack:
        return Text::tr("there and back");
    case animation::Loop::Off:
        break;
    }
    return Text::tr("once");
}

// "; tracks: 2, motions: 1", without what there is none of.
QString movingText(const document::AnimationFacts& facts) {
    QStringList parts;
    if (facts.tracks > 0) parts << Text::tr("tracks: %1").arg(facts.tracks);
    if (facts.motions > 0) parts << Text::tr("motions: %1").arg(facts.motions);
    return parts.isEmpty() ? QString() : QStringLiteral("; ") + parts.join(QStringLiteral(", "));
}

void addAnimation(FactLines& lines, const document::Fractal& fractal) {
    const auto facts = document::animationFacts(fractal);
    if (!facts) return;
    lines.add(Text::tr("animation"),
              Text::tr("frames: %1, %2 per second, %3")
                      .arg(animation::frameCount(facts->loop, facts->length))
                      .arg(reportFigures()(double(facts->rate.frames) / facts->rate.seconds),
                           loopText(facts->loop)) +
                  movingText(*facts));
}

void addEntry(FactLines& lines, const document::Entry& entry, const InfoSubject& subject) {
    const document::Fractal fractal = momentOf(entry, subject);
    const auto* plane = document::plane(fractal);
    const auto* space = document::space(fractal);
    if (plane || space) {
        lines.title(titleOf(fractal));
        plane ? addShape(lines, *plane, entry, subject) : addShape(lines, *space, entry, subject);
        return addAnimation(lines, *entry.fractal);
    }
    lines.title(Text::tr("%1 — could not be read").arg(fractal.name));
    for (const auto& problem : entry.problems)
        if (problem.severity == document::Problem::Severity::Error)
            lines.add(Text::tr("reason"), problem.message);
}

} // namespace

QString listText(const QList<document::Entry>& entries, const QList<qsizetype>& numbers) {
    QString text;
    for (qsizetype i = 0; i < entries.size(); ++i) {
        const document::Fractal& fractal = *entries[i].fractal;
        const int dimension = document::dimension(fractal);
        const auto* space = document::system3(fractal);
        const QString size =
            dimension == 0 ? Text::tr("could not be read")
            : space        ? Text::tr("in space, %1").arg(mapCount(space->maps.size()))
                    : Text::tr("in the plane, %1").arg(mapCount(document::system2(fractal)->maps.size()));
        text += QStringLiteral("%1  %2  %3\n")
                    .arg(numbers[i], 5)
                    .arg(size, -24)
                    .arg(QString(fractal.name).replace(u'\n', u' '));
    }
    return text;
}

QString infoText(const InfoSubject& subject) {
    FactLines lines;
    for (qsizetype i = 0; i < subject.entries.size(); ++i) {
        const document::Entry& entry = subject.entries[i];
        if (subject.begun) subject.begun(i);
        if (!lines.text().isEmpty()) lines.title({});
        addEntry(lines, entry, subject);
    }
    return lines.text();
}

} // namespace io
