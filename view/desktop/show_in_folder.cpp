// SPDX-License-Identifier: MIT
#include "desktop/show_in_folder.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

namespace view {

// Does not ask the file system about the path, because its drive may not answer: a path that ends in a slash
// is a folder.
void showInFolder(const QString& path) {
    if (!path.isEmpty()) QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).path()));
}

} // namespace view
