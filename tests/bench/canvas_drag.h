// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/system/iterated_function_system.h"

#include <QSize>

#include <cstdint>
#include <vector>

// A vertex of the cage dragged in the real canvas: milliseconds from handing the mouse event to the window
// until the pixels of its picture are painted, event by event. Needs a QApplication.
std::vector<double> dragInCanvas(const ifs::IteratedFunctionSystem<2>& system, std::uint64_t samples,
                                 int events, const QSize& size = {1920, 1080});

// The playhead of an animation set here and there: milliseconds until the pixels of its picture are painted.
std::vector<double> scrubInCanvas(const document::Fractal& animated, std::uint64_t samples, int events);

// An animation played once, `frames` long: the share of its frames whose picture is painted more than 16.7 ms
// after they are due, or not at all.
double lateInCanvas(document::Fractal animated, std::uint64_t samples, int frames);

// The same with colours stolen from `to`, which has as many maps, in a window of that size with two canvases:
// until the picture of F is painted. The first moves, until the number of points fits the machine, are left
// out.
std::vector<double> dragWithStolenColours(const ifs::IteratedFunctionSystem<2>& from,
                                          const ifs::IteratedFunctionSystem<2>& to, int events);
