// SPDX-License-Identifier: MIT
#pragma once

#include "collage/suggestions.h"
#include "document/fractal/fractal.h"
#include "document/traced_picture.h"

#include <QString>

#include <optional>
#include <stop_token>
#include <vector>

// Fits of a fractal to a picture: functions from fractal to fractal, in displayed coordinates. All may run in
// any thread.
namespace document {

// Why the maps cannot be compared with a picture; empty when they can.
QString collageObstacle(const Fractal& fractal);

// The maps that are on, as they act in displayed coordinates.
struct CollageMaps {
    std::vector<ifs::AffineMap<2>> maps;
    std::vector<std::size_t> index; // index of each map in the system
};
std::optional<CollageMaps> collageMaps(const Fractal& fractal); // nullopt if there is an obstacle

// The fractal with these maps instead, at rest and still, where the picture lies. Its name, comments and
// appearance stay.
Fractal withSuggestion(Fractal fractal, const collage::Suggestion& suggestion, const PicturePlace& place);

// Permissions of a fit.
struct CollageFitOptions {
    collage::Constraints constraints;
    std::vector<ifs::MapId> locked; // maps that stay bit for bit
};

// The functions below return nullopt when there is an obstacle, when nothing gets better, and when stopped.

// Moves the maps to where their images of the target cover it best, from coarse to fine.
std::optional<Fractal> withMapsRefined(const Fractal& fractal, const TracedPicture& traced,
                                       const CollageFitOptions& options, const std::stop_token& stop = {});
// Moves the maps so that the attractor itself comes closer to the target.
std::optional<Fractal> withAttractorRefined(const Fractal& fractal, const TracedPicture& traced,
                                            const CollageFitOptions& options,
                                            const std::stop_token& stop = {});
// The weights with which the maps reproduce the shades of the picture: dark, or opaque, is dense.
std::optional<Fractal> withWeightsFitted(const Fractal& fractal, const TracedPicture& traced,
                                         const std::stop_token& stop = {});
// Distance in pixels by which the shades of the attractor must be moved, on average and at most, to become
// those of the picture; nullopt when there is an obstacle, or the maps do not contract on average.
std::optional<double> shadesBound(const Fractal& fractal, const TracedPicture& traced,
                                  const std::stop_token& stop = {});
// A cage of `corners` corners, 3 or more, under which the outline of the attractor follows that of the
// target. Needs no placement that can be undone: it is made anew.
std::optional<Fractal> withCageFittedTo(const Fractal& fractal, const TracedPicture& traced, int corners,
                                        const std::stop_token& stop = {});
// Adds a map whose image of the target lies at that point, and fits it while the others stay.
std::optional<Fractal> withMapAdded(const Fractal& fractal, const TracedPicture& traced,
                                    const ifs::Vector<2>& point, const collage::Constraints& constraints,
                                    const std::stop_token& stop = {});

} // namespace document
