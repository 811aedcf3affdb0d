// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "document/fractal/fractal.h"
#include "io/export_job.h"

#include <QImage>
#include <QSize>
#include <QString>

#include <optional>
#include <stop_token>
#include <variant>

namespace io {

// Recipes: the settings of an export, as plain values that can be kept, without the entry.

struct PixelRecipe { // picture of pixels in the plane
    attractor::Camera camera;
    PictureFile file = PictureFile::Png;
    PictureFormat::Depth depth = PictureFormat::Depth::Bits8; // must be a depth of the file
    int samplesPerPixel = 100;
    int supersample = 1;
    double dotsPerInch = 300;
    CageVisibility cage = CageVisibility::Hidden;
    bool isTransparent = false;

    friend bool operator==(const PixelRecipe&, const PixelRecipe&) = default;
};

struct ShapeRecipe { // picture of shapes in the plane
    attractor::Camera camera;
    ShapeFile file = ShapeFile::Svg;
    ShapeStyle style = ShapeStyle::Structured;
    std::optional<int> depth; // depth of copies; nullopt: as many levels as a pixel needs
    int points = int(SvgFormat().points);
    double dotsPerInch = SvgFormat().dotsPerInch;
    CageVisibility cage = CageVisibility::Hidden;
    bool isTransparent = false;

    friend bool operator==(const ShapeRecipe&, const ShapeRecipe&) = default;
};

struct SpaceRecipe {
    attractor::OrbitCamera camera; // camera of the screen; everything visible there stays in the picture
    attractor::RasterSize size;    // size of the picture, including both eyes side by side
    PictureFile file = PictureFile::Png;
    std::optional<ShapeFile> page;                            // page in which a PNG of 8 bits is embedded
    PictureFormat::Depth depth = PictureFormat::Depth::Bits8; // must be a depth of the file
    Stereo stereo = Stereo::None;
    int supersample = 2;
    double dotsPerInch = 300;
    bool isTransparent = false;
    bool showsCage = false; // over the picture, but not over numbers nor in stereo

    friend bool operator==(const SpaceRecipe&, const SpaceRecipe&) = default;
};

struct BodyRecipe { // printable body of a system in space
    MeshFormat format = MeshFormat::Stl;
    double longest = 80; // mm
    int resolution = 128;
    double wall = 0; // mm
    bool fillsCavities = false;

    friend bool operator==(const BodyRecipe&, const BodyRecipe&) = default;
};

using ExportRecipe = std::variant<PixelRecipe, ShapeRecipe, SpaceRecipe, BodyRecipe>;

bool isInSpace(const ExportRecipe& recipe); // true for entries in space
// Returns true if every number is in the range that the dialogs have.
bool isUsable(const ExportRecipe& recipe);
// Returns true if the suffix of the file name belongs to the recipe's format.
bool isNamedFor(const ExportRecipe& recipe, const QString& path);

// The fractal has the dimension of the recipe, and the recipe is usable.
Export exportOf(const ExportRecipe& recipe, const document::Fractal& fractal);
PlaneExport exportOf(const PixelRecipe& recipe, const document::Fractal& fractal);
SvgExport exportOf(const ShapeRecipe& recipe, const document::Fractal& fractal);
SpaceExport exportOf(const SpaceRecipe& recipe, const document::Fractal& fractal);
SolidExport exportOf(const BodyRecipe& recipe, const document::Fractal& fractal);

// A preview in `pixels` pixels of the same shape; of shapes, as many as those pixels need. nullopt when
// stopped, and for bodies.
std::optional<QImage> previewOf(const ExportRecipe& recipe, const document::Fractal& fractal,
                                const QSize& pixels, const std::stop_token& stop);

} // namespace io
