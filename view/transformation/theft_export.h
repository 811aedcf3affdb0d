// SPDX-License-Identifier: MIT
#pragma once

#include "document/tops/theft_thread.h"
#include "io/picture/plane_export.h"

#include <QImage>
#include <QString>

#include <optional>
#include <stop_token>

namespace view {

// The stolen picture of the job's F through a camera, whatever its own. Both take long: not in the thread of
// the window.

// Exports as PNG; `path` appears whole or not at all.
io::ExportOutcome exportStolenPicture(const document::TheftJob& job, const attractor::Camera& camera,
                                      const QString& path, const io::Progress& progress,
                                      const std::stop_token& stop);
// The picture in memory; nullopt when stopped, or when there is none.
std::optional<QImage> stolenPicture(const document::TheftJob& job, const attractor::Camera& camera,
                                    const std::stop_token& stop);

} // namespace view
