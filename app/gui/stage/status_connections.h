// SPDX-License-Identifier: MIT
#pragma once

namespace view {
class RenderBridge;
class SolidBridge;
} // namespace view

class Stage;
class StatusLine;

// Shows in the line where the pointer is, how the view is turned and what was drawn.
void connectStatus(StatusLine* line, Stage* stage, const view::RenderBridge* plane,
                   const view::SolidBridge* solid);
