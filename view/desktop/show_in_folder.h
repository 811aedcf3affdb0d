// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace view {

// Shows the folder that holds the file, or the folder itself, in the file manager of the desktop.
void showInFolder(const QString& path);

} // namespace view
