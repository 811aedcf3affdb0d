// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

class QWidget;

namespace view {

// Asks where to write, beginning at `suggestion`: a path, or a name in the folder that was written to last.
// Empty: the user changed their mind. A name without an ending gets `suffix` before the dialog asks about
// replacing a file, so nothing is replaced unasked.
QString chooseFileToSave(QWidget* parent, const QString& title, const QString& suggestion,
                         const QString& filter, const QString& suffix);

} // namespace view
