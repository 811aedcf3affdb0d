// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

namespace view {
class CanvasView;
class MapsPanel;
} // namespace view

class Stage;
class WindowMessages;

// Selects the rows of the panel and the maps on the canvas together, and shows on both the map that one of
// them points at.
void connectMaps(view::MapsPanel* maps, view::CanvasView* canvas, Stage* stage,
                 const document::Document& document, WindowMessages* messages);
