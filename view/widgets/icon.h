// SPDX-License-Identifier: MIT
#pragma once

#include <QIcon>
#include <QString>

namespace view {

// The monochrome icon ":/icons/<name>.svg" in the text colour of the application's palette: rendered at the
// size and device pixel ratio asked for, and anew when the palette changes. A null icon when there is none of
// that name.
QIcon icon(const QString& name);

} // namespace view
