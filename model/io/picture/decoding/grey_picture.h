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
    bool isReduced = false;      // true if it had more pixels than maxTracedSide permits
    std::optional<QString> flaw; // reason why it cannot be used, as a sentence
};

constexpr int minTracedSide = 8;    // pixels
constexpr int maxTracedSide = 1024; // pixels; larger pictures are scaled down

// Reads what decodedPicture() reads. Nearly opaque pixels are seen on white.
LoadedGrey readGreyPicture(const QByteArray& bytes, const std::stop_token& stop = {});

} // namespace io
