// SPDX-License-Identifier: MIT
#pragma once

class QWidget;

namespace view {

void showGuide(QWidget* parent); // docs/guide.md, which the program carries with it

} // namespace view
