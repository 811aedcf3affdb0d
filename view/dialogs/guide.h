// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

class QWidget;

namespace view {

// docs/guide.md, which the program carries with it, at the section with this heading or from its beginning.
void showGuide(QWidget* parent, const QString& heading = {});

} // namespace view
