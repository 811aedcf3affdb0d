// SPDX-License-Identifier: MIT
#include "document/fractal_file.h"

#include "document/text/unique_names.h"

#include <algorithm>

namespace document {

bool operator==(const Entry& a, const Entry& b) {
    return a.id == b.id && a.source == b.source && a.problems == b.problems &&
           (a.fractal == b.fractal || *a.fractal == *b.fractal);
}

bool operator==(const FractalFile& a, const FractalFile& b) {
    return a.entries == b.entries && a.head == b.head && a.tail == b.tail && a.lineEnd == b.lineEnd &&
           a.problems == b.problems;
}

EntryId freshId(const FractalFile& file) {
    std::uint32_t largest = 0;
    for (const Entry& entry : file.entries)
        largest = std::max(largest, static_cast<std::uint32_t>(entry.id));
    return static_cast<EntryId>(largest + 1);
}

qsizetype indexOf(const FractalFile& file, EntryId id) {
    const auto found = std::find_if(file.entries.begin(), file.entries.end(),
                                    [id](const Entry& entry) { return entry.id == id; });
    return found == file.entries.end() ? -1 : found - file.entries.begin();
}

QString uniqueName(const FractalFile& file, const QString& name, EntryId except) {
    UniqueNames names;
    for (const Entry& entry : file.entries)
        if (entry.id != except) names.take(entry.fractal->name);
    return names.give(name);
}

FractalFile fileOf(Fractal fractal) {
    FractalFile file;
    file.entries.append({freshId(file), std::make_shared<const Fractal>(std::move(fractal)), nullptr, {}});
    return file;
}

} // namespace document
