// SPDX-License-Identifier: MIT
#include "render/render_note.h"

#include "options/tr.h"
#include "process/messages.h"

namespace cli {

QString sentenceOf(attractor::RenderNote note, bool isInSpace) {
    switch (note) {
    case attractor::RenderNote::None:
    case attractor::RenderNote::NoMaps:
        return {};
    case attractor::RenderNote::NoAttractor:
        return isInSpace ? tr("The system has no attractor: some word of maps does not contract. "
                              "The picture may be incomplete or empty.")
                         : tr("The system has no attractor: some word of maps does not contract. "
                              "The picture shows where points go before they escape.");
    case attractor::RenderNote::Undecided:
        return tr("Whether the system has an attractor could not be decided.");
    case attractor::RenderNote::TooDeep:
        return tr("The view is smaller than numerical precision can resolve.");
    case attractor::RenderNote::TooFar:
        return tr("What lies far behind this small view may be drawn in the wrong order: depths there can no "
                  "longer be told apart.");
    case attractor::RenderNote::FewerIterations:
        return tr("There would be more copies than can be drawn after so many "
                  "iterations; fewer iterations were made.");
    case attractor::RenderNote::Degenerate:
        return tr("The cage is flat, and so is the picture.");
    }
    return {};
}

void reportNote(attractor::RenderNote note, bool isInSpace, const QString& fileName) {
    if (const QString sentence = sentenceOf(note, isInSpace); !sentence.isEmpty())
        reportWarning(fileName, sentence);
}

bool hasMaps(const document::Fractal& fractal, const QString& fileName) {
    const auto* plane = document::system2(fractal);
    const auto* space = document::system3(fractal);
    if (plane != nullptr ? ifs::countActive(*plane) > 0 : space != nullptr && ifs::countActive(*space) > 0)
        return true;
    reportError(fileName, tr("“%1” has no active map, so there is nothing to draw.").arg(fractal.name));
    return false;
}

} // namespace cli
