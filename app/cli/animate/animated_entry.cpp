// SPDX-License-Identifier: MIT
#include "animate/animated_entry.h"

#include "options/tr.h"
#include "process/messages.h"
#include "render/render_note.h"

#include <algorithm>

namespace cli {

namespace {

bool isAnimated(const document::Entry& entry) {
    return document::animationFacts(*entry.fractal).has_value();
}

} // namespace

const document::Entry* animatedEntry(const Input& input, const std::vector<std::string>& names,
                                     ExitStatus& status) {
    if (names.empty()) {
        const auto& entries = input.collection.file.entries;
        if (const auto found = std::ranges::find_if(entries, isAnimated); found != entries.end()) {
            status = std::max(status, reportAll(input.collection.file.problems, input.name));
            status = std::max(status, reportAll(found->problems, input.name));
            return &*found;
        }
    }
    const ToDraw toDraw = entriesToDraw(input, names);
    status = std::max(status, toDraw.status);
    if (toDraw.entries.empty()) return nullptr;
    const document::Entry& entry = *toDraw.entries.front();
    if (isAnimated(entry)) return hasMaps(*entry.fractal, input.name) ? &entry : nullptr;
    reportError(input.name, tr("“%1” has no animation.").arg(printableLine(entry.fractal->name)));
    return nullptr;
}

std::vector<int> filesOf(const AnimateArguments& arguments, const Input& input,
                         const document::Fractal& entry) {
    const auto facts = *document::animationFacts(entry);
    const int count = animation::frameCount(facts.loop, facts.length);
    if (isAnyBeyond(arguments.ranges, count))
        reportWarning(input.name,
                      tr("The last frame of “%1” has the number %2; larger ones in --frames are ignored.")
                          .arg(printableLine(entry.name), QString::number(count)));
    const std::vector<int> all = filesIn(arguments.ranges, count);
    const Chunk part = arguments.chunk.value_or(Chunk());
    std::vector<int> files;
    for (auto i = std::size_t(part.i); i < all.size(); i += std::size_t(part.n))
        files.push_back(all[i]);
    return files;
}

} // namespace cli
