// SPDX-License-Identifier: MIT
#pragma once

class QWidget;

namespace view {

// What's This? for the parts of a panel or dialog that say in their tool tip or status tip all there is to
// say, and for the usual buttons of dialogs. Texts that are there already stay.
void explainByTips(QWidget* root);

} // namespace view
