// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QSize>

namespace io {

// The pixels of a picture that a user gives, turned upright, or why there are none. A stop makes readers end
// with `Damaged`.
struct RasterPicture {
    enum class Flaw {
        Damaged,
        TooLarge, // more pixels than permitted
        Animated,
        Unreadable, // unsupported kind
    };
    QImage image;              // null if there is none; has the colour space of the file, if any
    QSize size{};              // empty if unknown
    Flaw flaw = Flaw::Damaged; // valid if there is no image
};

} // namespace io
