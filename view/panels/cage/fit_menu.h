// SPDX-License-Identifier: MIT
#pragma once

class QMenu;

namespace view {

class CagePanel;

// The cages that can be fitted to a picture, in the plane and in space. On the panel.
QMenu* makeFitMenu(CagePanel* panel);
QMenu* makeSpaceFitMenu(CagePanel* panel);

} // namespace view
