// SPDX-License-Identifier: MIT
#pragma once

class QWidget;

namespace view {

// Adds What's This? texts to the parts of a panel or dialog whose tool tip or status tip says everything, and
// to the usual buttons of dialogs. Existing texts stay.
void explainByTips(QWidget* root);

} // namespace view
