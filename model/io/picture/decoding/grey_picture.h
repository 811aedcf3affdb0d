// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/mask.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <stop_token>

namespace io {

// A picture as the target of a collage.
struct LoadedGrey {
    collage::GreyPicture picture;
    bool isReduced = false;      // it has more pixels than are traced: maxTracedSide
    std::optional<QString> flaw; // the user's sentence when it cannot be used
};

constexpr int minTracedSide = 8;    // pixels
constexpr int maxTracedSide = 1024; // pixels; larger pictures are scaled down

// Reads what decodedPicture() reads. Nearly opaque pixels are seen on white.
LoadedGrey readGreyPicture(const QByteArray& bytes, const std::stop_token& stop = {});

} // namespace io
