// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/tops/picture_patterns.h"
#include "document/fractal/fractal.h"
#include "ifs/names.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace document {

enum class TheftMode {
    StealColours,     // the picture lies around G as it would be rendered
    TransformPicture, // it covers the box of G, corner to corner
    DeformationGrid,  // a grid covers the box of G, whatever the picture
    Reduce,           // the picture lies on F, is carried to G, loses detail there, and comes back
    Posterise,        // the same, and loses shades
};

inline constexpr qsizetype maxEmbeddedPicture = 128 * 1024; // bytes

// The fractal transformation kept in an entry, in its comments "barycage: partner…". docs/formats.md,
// "Barycage's comment lines".
struct KeptTheft {
    QString partner;                // the name of the other entry, G
    std::vector<std::size_t> order; // indices of the maps, the one on top first; empty: as they are
    TheftMode mode = TheftMode::StealColours;
    attractor::Pattern pattern = attractor::Pattern::Wheel;
    QString picture;     // its path from the folder of the file, with slashes; empty: the pattern
    QByteArray embedded; // a file of it in the entry itself, which is used in place of that path; empty: none
    // Position of the picture in the plane of G, for StealColours; nullopt: as it would be rendered. y
    // upwards.
    std::optional<attractor::View> view;

    friend bool operator==(const KeptTheft&, const KeptTheft&) = default;
};

std::optional<KeptTheft> keptTheft(const Fractal& fractal); // lines that make no sense are passed over
// Without a partner, nothing is kept.
Fractal withTheft(Fractal fractal, const std::optional<KeptTheft>& theft);

} // namespace document

template <>
inline constexpr auto ifs::names<document::TheftMode> = std::to_array<ifs::Named<document::TheftMode>>({
    {document::TheftMode::StealColours, "steal"},
    {document::TheftMode::TransformPicture, "transform"},
    {document::TheftMode::DeformationGrid, "grid"},
    {document::TheftMode::Reduce, "reduce"},
    {document::TheftMode::Posterise, "posterise"},
});
