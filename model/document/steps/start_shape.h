// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/traced_picture.h"

#include <QString>

#include <optional>
#include <vector>

namespace document {

// A set B from which the deterministic algorithm may start: closed contours, filled by the even-odd rule, y
// up. The longer side of its box is 1, and the middle of the box is the origin.
struct StartShape {
    std::vector<std::vector<ifs::Vector<2>>> contours;

    friend bool operator==(const StartShape&, const StartShape&) = default;
};

StartShape squareShape();
// A letter, or a few; nullopt for blanks. Needs a QGuiApplication and its thread.
std::optional<StartShape> letterShape(const QString& letters);
// The shape in a picture, of few corners.
StartShape pictureShape(const TracedPicture& picture);

// The shape over the attractor of the code, as large as its box is at its longer side; coordinates of the
// code.
StartShape overAttractor(const StartShape& shape, const Fractal& fractal);

} // namespace document
