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
    StealColours,     // picture around G as it would be rendered
    TransformPicture, // picture stretched to the box of G
    DeformationGrid,  // grid over the box of G, in place of the picture
    Reduce,           // picture on F, carried to G and back, which loses detail
    Posterise,        // same as Reduce, with fewer shades
};

inline constexpr qsizetype maxEmbeddedPicture = 128 * 1024; // bytes

// The fractal transformation kept in an entry, in its comments "barycage: partner…". docs/formats.md,
// "Barycage's comment lines".
struct KeptTheft {
    QString partner;                // name of the other entry, G
    std::vector<std::size_t> order; // indices of the maps, first the map on top; empty: unchanged
    TheftMode mode = TheftMode::StealColours;
    attractor::Pattern pattern = attractor::Pattern::Wheel;
    QString picture;     // path from the folder of the file, with slashes; empty: the pattern
    QByteArray embedded; // file contents embedded in the entry, used in place of the path; empty: none
    // Position of the picture in the plane of G, for StealColours; nullopt: as it would be rendered. y
    // upwards.
    std::optional<attractor::View> view;

    friend bool operator==(const KeptTheft&, const KeptTheft&) = default;
};

std::optional<KeptTheft> keptTheft(const Fractal& fractal); // ignores malformed lines
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
