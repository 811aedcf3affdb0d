// SPDX-License-Identifier: MIT
#pragma once

#include "document/tops/theft_thread.h"
#include "io/file/save_file.h"

#include <QString>

class QWidget;

namespace view {

// The stolen picture of the job's view of F as PNG, so many pixels on its longer side. Waits under a dialog
// that can cancel. nullopt without a sentence, also when cancelled.
io::Failure exportStolenPicture(const document::TheftJob& job, int longerSide, const QString& path,
                                QWidget* window);

} // namespace view
