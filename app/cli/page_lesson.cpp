// SPDX-License-Identifier: MIT
#include "page_lesson.h"

#include "options/tr.h"
#include "process/messages.h"

#include "document/fractal/fractal_geometry.h"
#include "document/lesson/shown_step.h"
#include "io/lesson/lesson_reader.h"

#include <QStringList>

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

namespace cli {

namespace {

using document::LessonState;

// The entry of that name, or the first, of those that a page can show; nullptr: none.
const document::Entry* entryToShow(const Input& collection, const QString& name) {
    const auto& entries = collection.collection.file.entries;
    const auto found = std::ranges::find_if(entries, [&](const document::Entry& entry) {
        return isLoaded(entry) && io::pageObstacle(*entry.fractal).isEmpty() &&
               (name.isEmpty() || document::lessonLine(entry.fractal->name) == name);
    });
    return found == entries.end() ? nullptr : &*found;
}

bool showsMore(const LessonState& state) {
    return state.construction.mode != document::LessonConstruction::Mode::Density ||
           !state.outlines.empty() || state.moment ||
           std::holds_alternative<document::LessonOrbit>(state.view);
}

} // namespace

ExitStatus addLesson(io::PageExport& page, const std::string& file, const Input& collection) {
    const QString name = fileNameOf(file);
    const io::Loaded loaded = loadBytes(file);
    if (loaded.failure) {
        reportError(name, *loaded.failure);
        return ExitStatus::CannotReadOrWrite;
    }
    const io::LessonFile read = io::readLesson(loaded.bytes);
    ExitStatus status = reportAll(read.problems, name);
    page.title = read.lesson.title;
    QStringList incomplete;
    QList<LessonState> states; // states of the entries of the page
    const document::Entry* entry = entryToShow(collection, {});
    for (const document::LessonStep& step : read.lesson.steps) {
        const QString number = QString::number(page.steps.size() + 1);
        LessonState state = step.state;
        const document::Entry* own = entryToShow(collection, state.entry);
        if (!state.entry.isEmpty() && own != nullptr) entry = own;
        if (own == nullptr) {
            reportError(
                name,
                tr("Step %1: the collection has no entry “%2” that can be shown.").arg(number, state.entry));
            status = std::max(status, ExitStatus::InputProblems);
        }
        if (entry == nullptr) break;
        state.entry = document::lessonLine(entry->fractal->name);
        const auto known = std::ranges::find_if(states, [&](const LessonState& other) {
            return other.entry == state.entry && other.cage == state.cage && other.colourBy == state.colourBy;
        });
        bool fits = true;
        if (known == states.end()) {
            document::ShownStep shown = document::withCageAndColours(state, *entry->fractal);
            fits = shown.fits;
            page.entries << std::make_shared<const document::Fractal>(std::move(shown.fractal));
        }
        if (!fits || showsMore(state)) incomplete << number;
        const auto* area = std::get_if<document::LessonArea>(&state.view);
        page.steps.append({step.title, step.text, known - states.begin(),
                           area ? std::optional(*area) : std::nullopt,
                           state.tool == document::LessonTool::Maps});
        if (known == states.end()) states << state;
    }
    if (!incomplete.isEmpty())
        reportWarning(
            name,
            tr("A web page shows no constructions, outlines, moments or directions of view, and no cage "
               "with other corners, as in these steps: %1.")
                .arg(incomplete.join(QStringLiteral(", "))));
    if (page.steps.isEmpty()) return std::max(status, ExitStatus::InputProblems);
    page.fractal = *page.entries.front();
    return status;
}

} // namespace cli
