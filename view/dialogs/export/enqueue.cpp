// SPDX-License-Identifier: MIT
#include "dialogs/export/enqueue.h"

#include "document/text/text.h"
#include "io/file/slow_disk.h"
#include "io/fractint/entry_writer.h"

#include <QFileInfo>

namespace view {

Enqueued enqueue(ExportQueue& queue, const document::Fractal& fractal, const io::ExportRecipe& recipe,
                 const QString& path) {
    const QString name = QFileInfo(path).fileName();
    if (!io::isNamedFor(recipe, path))
        return {false,
                Text::tr("The name “%1” does not match the chosen format. Choose another name.").arg(name)};
    if (queue.isTarget(path))
        return {false, Text::tr("Another export in the queue writes “%1”. Choose another name.").arg(name)};
    io::ExportTask task;
    task.path = path;
    task.name = fractal.name;
    task.entry = io::writeEntry(fractal);
    task.recipe = recipe;
    // True only for a file that exists now, about which the user was asked.
    task.mayReplace = io::answerSoon([path] { return QFileInfo::exists(path); }).value_or(true);
    queue.add(std::move(task));
    return {true, Text::tr("Added to the queue: %1.").arg(name)};
}

} // namespace view
