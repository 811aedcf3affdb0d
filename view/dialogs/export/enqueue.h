// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/export_queue.h"
#include "document/fractal/fractal.h"
#include "io/exports/export_recipe.h"

#include <QString>

namespace view {

// Adds the export of the fractal, as it is now, to the queue. A file that another export in the queue is
// going to write is refused. The user was asked about one that is there.
struct Enqueued {
    bool isAdded = false;
    QString sentence; // outcome for the user
};
Enqueued enqueue(ExportQueue& queue, const document::Fractal& fractal, const io::ExportRecipe& recipe,
                 const QString& path);

} // namespace view
