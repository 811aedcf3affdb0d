// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

namespace view {
class CanvasView;
class MapsPanel;
} // namespace view

class Stage;
class WindowMessages;

// Selects the rows of the panel and the maps on the canvas together, and shows on both what one of them asks
// for.
void connectMaps(view::MapsPanel* maps, view::CanvasView* canvas, Stage* stage,
                 const document::Document& document, WindowMessages* messages);
