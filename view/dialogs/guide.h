// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

class QWidget;

namespace view {

// docs/guide.md, which the program carries with it, at the section with this heading or from its beginning.
void showGuide(QWidget* parent, const QString& heading = {});

// The guide with these words in its search field.
void searchGuide(QWidget* parent, const QString& words);

} // namespace view
