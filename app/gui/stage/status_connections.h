// SPDX-License-Identifier: MIT
#pragma once

namespace view {
class RenderBridge;
class SolidBridge;
} // namespace view

class Stage;
class StatusLine;

// Shows in the line the position of the pointer, the rotation of the view, and a summary of the picture.
void connectStatus(StatusLine* line, Stage* stage, const view::RenderBridge* plane,
                   const view::SolidBridge* solid);
