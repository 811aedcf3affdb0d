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
        TooLarge, // more pixels than asked for
        Animated,
        Unreadable, // of a kind that is not read
    };
    QImage image;              // null where there is none; with its colour space where the file names one
    QSize size{};              // as far as it is known
    Flaw flaw = Flaw::Damaged; // where there is no image
};

} // namespace io
