// SPDX-License-Identifier: MIT
#include "python/bindings.h"

#include "attractor/folds/density_fold.h"
#include "attractor/light/solid_appearance.h"
#include "attractor/light/solid_light.h"
#include "attractor/render/render_state.h"
#include "attractor/render/renderer.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/samples/prepared_space.h"
#include "attractor/samples/space_orbit.h"
#include "attractor/threads/hardware_threads.h"
#include "python/arrays.h"
#include "python/batch_painter.h"
#include "python/interruptible.h"
#include "python/placing.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

namespace python {

namespace {

namespace py = pybind11;

constexpr int maxSide = 32'768; // pixels
constexpr std::uint64_t maxPoints = 1'000'000'000;

using Sides = std::array<int, 2>; // rows, columns

void checkRaster(const Sides& shape) {
    if (std::ranges::any_of(shape, [](int side) { return side < 1 || side > maxSide; }))
        throw std::invalid_argument("shape: rows and columns must be from 1 to " + std::to_string(maxSide));
}

void checkCount(std::uint64_t count, const char* what) {
    if (count > maxPoints)
        throw std::invalid_argument(std::string(what) + ": at most " + std::to_string(maxPoints));
}

int threadsOf(int threads) {
    return threads > 0 ? threads : attractor::hardwareThreads();
}

// Points of the chaos game with their address coordinates, until `count` are there or it is stopped.
template <int Dim, class Orbit, class Place>
void follow(Orbit& orbit, const Place& place, std::vector<double>& points, std::vector<double>& addresses,
            const std::stop_token& stop) {
    constexpr std::size_t between = 1U << 14; // samples between two checks for a stop
    for (std::size_t i = 0; i < addresses.size(); ++i) {
        if (i % between == 0 && stop.stop_requested()) return;
        const auto point = orbit.next();
        const ifs::Vector<Dim> x = place(point.x);
        std::copy_n(x.data(), Dim, points.begin() + std::ptrdiff_t(i * Dim));
        addresses[i] = point.addressCoordinate;
    }
}

py::tuple points(const notation::Entry& entry, std::uint64_t count, std::uint64_t seed) {
    checkCount(count, "count");
    const bool isSpace = std::holds_alternative<notation::Figure<3>>(entry.figure);
    const int dimension = isSpace ? 3 : 2;
    std::vector<double> result, addresses;
    interruptibly([&](const std::stop_token& stop) {
        result.resize(count * std::size_t(dimension));
        addresses.resize(count);
        if (isSpace) {
            const auto& figure = figureIn<3>(entry);
            requireDrawable(ifs::activeMaps(figure.system));
            const auto system = attractor::preparedSpace(figure.system);
            attractor::SpaceOrbit orbit(system, seed);
            const bool isPlaced = figure.cage && !ifs::bends(*figure.cage);
            const ifs::AffineMap<3> placed = isPlaced ? ifs::displayMap(*figure.cage) : ifs::AffineMap<3>{};
            follow<3>(orbit, placed, result, addresses, stop);
        } else {
            const auto& figure = figureIn<2>(entry);
            requireDrawable(ifs::activeMaps(figure.system));
            const auto system =
                attractor::prepared(figure.system, notation::movedBranches(figure.system, figure.moved));
            attractor::Orbit orbit(system, seed);
            follow<2>(orbit, placementOf(figure), result, addresses, stop);
        }
    });
    const auto n = py::ssize_t(count);
    return py::make_tuple(arrayOf(std::move(result), {n, dimension}), arrayOf(std::move(addresses), {n}));
}

// Where one looks: all of what is shown, or a point in the middle and pixels per unit.
struct View {
    Sides shape{}; // rows, columns
    std::optional<std::array<double, 2>> centre;
    std::optional<double> scale;
};

attractor::RenderRequest framed(const notation::Entry& entry, const View& view) {
    attractor::RenderRequest request = requestOf(entry, view.shape[1], view.shape[0]);
    requireDrawable(ifs::activeMaps(request.system));
    if (!view.centre || !view.scale) request.camera = cameraAround(entry, request.camera);
    if (view.centre) request.camera.centre = {(*view.centre)[0], (*view.centre)[1]};
    if (view.scale) request.camera.pixelsPerUnit = *view.scale;
    if (!(request.camera.pixelsPerUnit > 0) || !request.camera.centre.allFinite())
        throw std::invalid_argument("centre and scale must be finite, and the scale above 0");
    return request;
}

py::array density(const notation::Entry& entry, const View& view, std::uint64_t samples, std::uint64_t seed,
                  int threads) {
    checkRaster(view.shape);
    const int height = view.shape[0], width = view.shape[1];
    std::vector<std::uint64_t> counts(std::size_t(height) * std::size_t(width));
    interruptibly([&](const std::stop_token& stop) {
        attractor::RenderRequest request = framed(entry, view);
        request.appearance = {};
        request.samples = samples;
        request.seed = seed;
        request.threads = threadsOf(threads);
        attractor::RenderState render;
        render.start(std::move(request));
        render.rewind(0, height);
        if (!render.isDrawable()) return;
        render.fold().begin(samples);
        if (!render.complete(stop)) return;
        const auto& sums = dynamic_cast<const attractor::DensityFold&>(render.fold()).sums();
        std::vector<std::uint64_t> row;
        for (int y = 0; y < height; ++y)
            if (sums.samplesOfRow(y, row))
                std::copy_n(row.begin(), width, counts.begin() + std::ptrdiff_t(y) * width);
    });
    return arrayOf(std::move(counts), {height, width});
}

// Straight, not premultiplied.
std::vector<std::uint8_t> rgbaOf(std::span<const std::uint32_t> pixels) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * pixels.size());
    for (const std::uint32_t pixel : pixels) {
        const std::uint32_t alpha = pixel >> 24;
        for (int shift = 16; shift >= 0; shift -= 8) {
            const std::uint32_t channel = (pixel >> shift) & 255;
            rgba.push_back(std::uint8_t(
                alpha == 255 || alpha == 0 ? channel : std::min((channel * 255 + alpha / 2) / alpha, 255U)));
        }
        rgba.push_back(std::uint8_t(alpha));
    }
    return rgba;
}

std::uint64_t hashOf(std::span<const std::uint32_t> pixels) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const std::uint32_t pixel : pixels)
        for (int shift = 0; shift < 32; shift += 8)
            hash = (hash ^ ((pixel >> shift) & 255)) * 1099511628211ULL;
    return hash;
}

// The picture, and FNV-1a of its premultiplied pixels, as in tests/data/hashes.txt.
py::tuple picture(const notation::Entry& entry, const View& view, std::uint64_t samples, std::uint64_t seed,
                  int threads) {
    checkRaster(view.shape);
    const int height = view.shape[0], width = view.shape[1];
    attractor::Frame frame;
    interruptibly([&](const std::stop_token& stop) {
        attractor::RenderRequest request = framed(entry, view);
        request.samples = samples;
        request.seed = seed;
        request.threads = threadsOf(threads);
        attractor::Rendering rendering(std::move(request));
        if (rendering.refine(stop)) frame = rendering.frame({}, stop);
    });
    const std::uint64_t hash = hashOf(frame.pixels);
    return py::make_tuple(arrayOf(rgbaOf(frame.pixels), {height, width, 4}), hash);
}

// The angles: azimuth, elevation and field of view.
py::tuple solid(const notation::Entry& entry, const Sides& shape, const std::array<double, 3>& angles,
                const std::string& look, int threads) {
    checkRaster(shape);
    const int height = shape[0], width = shape[1];
    const double azimuth = angles[0], elevation = angles[1], fieldOfView = angles[2];
    const auto shown = ifs::named<attractor::LookInSpace>(look);
    if (!shown || attractor::showsCloud(*shown))
        throw std::invalid_argument("look: stone, ink, depth or normals");
    if (!std::isfinite(azimuth) || !std::isfinite(elevation) || !(fieldOfView >= 0 && fieldOfView < 180))
        throw std::invalid_argument("azimuth and elevation must be finite, and the field of view below 180");
    std::vector<std::uint32_t> pixels;
    interruptibly([&](const std::stop_token& stop) {
        const notation::Figure<3>& figure = figureIn<3>(entry);
        attractor::SpaceRequest request;
        request.system = figure.system;
        request.cage = figure.cage;
        request.moved = notation::movedBranches(figure.system, figure.moved);
        request.threads = threadsOf(threads);
        request.camera.size = {width, height};
        request.camera.orientation = attractor::orbit(azimuth, elevation);
        if (fieldOfView > 0) {
            request.camera.projection = attractor::OrbitCamera::Projection::Perspective;
            request.camera.fieldOfView = fieldOfView;
        }
        const ifs::AffineMap<3> placed = figure.cage ? ifs::displayMap(*figure.cage) : ifs::AffineMap<3>{};
        request.camera = attractor::fitted(request.camera, supportOf(figure.system), placed);
        const attractor::OrbitCamera camera = request.camera;
        attractor::SolidRendering rendering(std::move(request));
        if (!rendering.draw(stop)) return;
        using enum attractor::LookInSpace;
        const attractor::SolidAppearance appearance =
            attractor::appearanceOf(*shown == Ink       ? attractor::Look::Ink
                                    : *shown == Depth   ? attractor::Look::Depth
                                    : *shown == Normals ? attractor::Look::Normals
                                                        : attractor::Look::Stone);
        attractor::Workers workers(threadsOf(threads));
        const double middle = camera.target.y(), reach = camera.height / 2;
        pixels = attractor::lit(rendering.raster(), appearance,
                                attractor::solidView(camera, middle - reach, middle + reach), workers);
    });
    const std::uint64_t hash = hashOf(pixels);
    return py::make_tuple(arrayOf(rgbaOf(pixels), {height, width, 4}), hash);
}

// How many points lie in each cell of the certified box: (z, y, x), and the box.
py::tuple volume(const notation::Entry& entry, const std::array<int, 3>& shape, std::uint64_t samples,
                 std::uint64_t seed) {
    const int depth = shape[0], height = shape[1], width = shape[2];
    constexpr int most = 2048;
    if (std::min({depth, height, width}) < 1 || std::max({depth, height, width}) > most)
        throw std::invalid_argument("shape: from 1 to " + std::to_string(most) + " cells along each axis");
    const ifs::Vector<3> cells(width, height, depth);
    std::vector<std::uint32_t> counts(std::size_t(width) * std::size_t(height) * std::size_t(depth));
    checkCount(samples, "samples");
    ifs::BoundingBox<3> box;
    interruptibly([&](const std::stop_token& stop) {
        const auto& figure = figureIn<3>(entry);
        box = boxOfAttractor(figure.system);
        const ifs::Vector<3> extent = (box.max - box.min).cwiseMax(1e-300);
        const auto system = attractor::preparedSpace(figure.system);
        attractor::SpaceOrbit orbit(system, seed);
        constexpr std::uint64_t between = 1U << 14;
        for (std::uint64_t i = 0; i < samples; ++i) {
            if (i % between == 0 && stop.stop_requested()) return;
            const ifs::Vector<3> at = (orbit.next().x - box.min).cwiseQuotient(extent).cwiseProduct(cells);
            const auto cell = [&](int axis) {
                return std::size_t(std::clamp(std::floor(at[axis]), 0.0, cells[axis] - 1));
            };
            ++counts[(cell(2) * std::size_t(height) + cell(1)) * std::size_t(width) + cell(0)];
        }
    });
    return py::make_tuple(arrayOf(std::move(counts), {depth, height, width}), arrayOf<3>(box.min),
                          arrayOf<3>(box.max));
}

py::array_t<std::uint32_t> densityBatch(const Numbers& systems, const std::optional<Numbers>& weights,
                                        const Sides& shape, std::uint64_t samples, std::uint64_t seed,
                                        int threads) {
    checkRaster(shape);
    const int height = shape[0], width = shape[1];
    checkCount(samples, "samples");
    if (systems.ndim() != 4 || systems.shape(2) != 2 || systems.shape(3) != 3 || systems.shape(1) < 1)
        throw std::invalid_argument("systems: the shape must be (systems, maps, 2, 3)");
    const py::ssize_t count = systems.shape(0), maps = systems.shape(1);
    if (weights && (weights->ndim() != 2 || weights->shape(0) != count || weights->shape(1) != maps))
        throw std::invalid_argument("weights: the shape must be (systems, maps)");
    const auto cells = std::size_t(height) * std::size_t(width);
    // Zeros that the system hands out where they are needed.
    py::array_t<std::uint32_t> counts =
        py::module_::import("numpy").attr("zeros")(py::make_tuple(count, height, width), "uint32");
    std::uint32_t* const pictures = counts.mutable_data();
    const double* const numbers = systems.data();
    if (!std::all_of(numbers, numbers + systems.size(), [](double number) { return std::isfinite(number); }))
        throw std::invalid_argument("systems: every number must be finite");
    const double* const shares = weights ? weights->data() : nullptr;
    interruptibly([&](const std::stop_token& stop) {
        std::atomic<py::ssize_t> next{0};
        const auto work = [&] {
            BatchPainter painter(height, width, samples);
            std::vector<ifs::AffineMap<2>> list(static_cast<std::size_t>(maps));
            for (py::ssize_t k = next++; k < count && !stop.stop_requested(); k = next++) {
                const double* row = numbers + k * maps * 6;
                for (ifs::AffineMap<2>& map : list) {
                    map = ifs::affineMap(row[0], row[1], row[3], row[4], row[2], row[5]);
                    row += 6;
                }
                painter.paint(list,
                              shares ? ifs::shares({shares + k * maps, shares + (k + 1) * maps})
                                     : ifs::determinantWeights<2>(list),
                              seed + std::uint64_t(k), stop, pictures + std::size_t(k) * cells);
            }
        };
        std::vector<std::jthread> team;
        for (int i = 1; i < std::min<py::ssize_t>(threadsOf(threads), count); ++i)
            team.emplace_back(work);
        work();
    });
    return counts;
}

// The same entry in other colours.
notation::Entry coloured(notation::Entry entry, const std::optional<std::string>& colourBy,
                         const std::optional<std::string>& palette, const std::optional<double>& brightness,
                         const std::optional<double>& gamma,
                         const std::optional<std::array<int, 4>>& background) {
    attractor::Appearance& appearance = entry.appearance;
    if (colourBy) {
        const auto named = ifs::named<attractor::ColourBy>(*colourBy);
        if (!named) throw std::invalid_argument("colour_by: density, map, address, plain or blend");
        appearance.colourBy = *named;
    }
    if (palette) {
        const attractor::Palette* known = attractor::findPalette(*palette);
        if (!known) throw std::invalid_argument("palette: none has the name “" + *palette + "”");
        appearance.palette = *known;
    }
    const auto positive = [](const std::optional<double>& number, double& member, const char* what) {
        if (!number) return;
        if (!(*number > 0 && std::isfinite(*number)))
            throw std::invalid_argument(std::string(what) + ": must be above 0");
        member = *number;
    };
    positive(brightness, appearance.brightness, "brightness");
    positive(gamma, appearance.gamma, "gamma");
    if (background) {
        for (const int channel : *background)
            if (channel < 0 || channel > 255)
                throw std::invalid_argument("background: red, green, blue and opacity from 0 to 255");
        const auto channel = [&](std::size_t i) { return std::uint8_t((*background)[i]); };
        appearance.background = {channel(0), channel(1), channel(2), channel(3)};
    }
    return entry;
}

py::list palettes() {
    py::list names;
    for (const attractor::Palette& palette : attractor::builtInPalettes())
        names.append(palette.name);
    return names;
}

} // namespace

void bindPictures(py::module_& core) {
    py::class_<View>(core, "View")
        .def(py::init([](const Sides& shape, const std::optional<std::array<double, 2>>& centre,
                         const std::optional<double>& scale) {
            return View{shape, centre, scale};
        }));
    core.def("points", &points);
    core.def("density", &density);
    core.def("density_batch", &densityBatch);
    core.def("picture", &picture);
    core.def("coloured", &coloured);
    core.def("palettes", &palettes);
    core.def("solid", &solid);
    core.def("volume", &volume);
}

} // namespace python
