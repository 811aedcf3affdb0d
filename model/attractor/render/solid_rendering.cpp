// SPDX-License-Identifier: MIT
#include "attractor/render/solid_rendering.h"

#include "attractor/solid/solid_band.h"
#include "attractor/solid/space_view.h"
#include "attractor/threads/job_shares.h"
#include "attractor/threads/workers.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace attractor {

namespace {

// Far inside, doubles have lost the digits of a pixel; a placement may be flat.
RenderNote noteOf(const SolidScene& scene, const ifs::AffineMap<3>& cage) {
    if (scene.system.note != RenderNote::None) return scene.system.note;
    const ifs::Vector<3> stretch = ifs::singularValues<3>(cage.linear);
    if (!scene.view.bend && !(stretch[2] > 1e-6 * stretch[0])) return RenderNote::Degenerate;
    const ifs::AffineMap<3> root =
        straightened(scene.view.toPixels * scene.system.fromBox(), scene.view).word;
    const double reach = root.translation.cwiseAbs().maxCoeff() + root.linear.cwiseAbs().maxCoeff();
    if (reach * 0x1p-48 > 1) return RenderNote::TooDeep;
    return scene.range.isClamped ? RenderNote::TooFar : RenderNote::None;
}

// Allocates in pieces: memory that is touched for the first time takes a second for every few gigabytes, in
// which somebody may stop. The raster is then empty.
bool makeRoom(DepthRaster& raster, const RasterSize& size, int firstRow, int rows,
              const std::stop_token& stop) {
    constexpr std::size_t piece = 1U << 22;
    raster.width = std::max(0, size.width);
    raster.height = std::max(0, size.height);
    raster.firstRow = firstRow;
    const std::size_t wanted = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(rows);
    raster.keys.resize(std::min(raster.keys.size(), wanted));
    raster.keys.reserve(wanted);
    while (raster.keys.size() < wanted && !stop.stop_requested())
        raster.keys.resize(std::min(wanted, raster.keys.size() + piece));
    if (raster.keys.size() == wanted) return true;
    raster = {};
    return false;
}

} // namespace

struct SolidRendering::State {
    SpaceRequest request;
    SolidScene scene;
    ifs::AffineMap<3> cage;
    std::unique_ptr<Workers> workers;
    std::vector<SolidBand> bands; // one for each thread
    DepthRaster raster;
    RenderNote note = RenderNote::None;
    Work work;

    bool draw(int firstRow, int endRow, const std::stop_token& stop);
};

// Bands begin where they do in the whole picture, which decides how many words are looked at for each.
bool SolidRendering::State::draw(int firstRow, int endRow, const std::stop_token& stop) {
    constexpr int rows = kernels::KeyBand::maxRows;
    const RasterSize size = request.camera.size;
    const int firstBand = std::max(0, firstRow) / rows;
    const int endBand = std::max(firstBand, (std::min(size.height, endRow) + rows - 1) / rows);
    const int kept = std::max(0, std::min(size.height, endBand * rows) - firstBand * rows);
    work = {};
    if (!makeRoom(raster, size, firstBand * rows, kept, stop)) return false;
    raster.near = 0;
    raster.far = 1;
    const bool drawable = !scene.system.maps.empty() && isUsable(request.camera);
    scene.range = drawable ? depthRange(scene.system, scene.view, stop) : DepthRange{1, 0, false};
    note = noteOf(scene, cage);
    if (!(scene.range.near < scene.range.far)) {
        std::fill(raster.keys.begin(), raster.keys.end(), emptyKey);
        return !stop.stop_requested();
    }
    const double unit = 1 / pixelsPerUnit(request.camera);
    raster.near = scene.range.near * unit;
    raster.far = scene.range.far * unit;
    JobShares shares;
    shares.reset(static_cast<std::size_t>(endBand - firstBand), *workers);
    bands.resize(workers->size());
    shares.run(*workers, stop, [&](std::size_t job, std::size_t thread) {
        const int first = (firstBand + static_cast<int>(job)) * rows;
        bands[thread].draw(scene, first, std::min(rows, size.height - first), raster, stop);
    });
    for (SolidBand& band : bands) {
        const SolidBand::Work done = band.takeWork();
        work.words += done.words;
        work.points += done.points;
        work.isCoarse = work.isCoarse || done.isCoarse;
    }
    return !stop.stop_requested();
}

SolidRendering::SolidRendering(SpaceRequest request) : m_state(std::make_unique<State>()) {
    restart(std::move(request));
}

SolidRendering::~SolidRendering() = default;
SolidRendering::SolidRendering(SolidRendering&&) noexcept = default;
SolidRendering& SolidRendering::operator=(SolidRendering&&) noexcept = default;

void SolidRendering::restart(SpaceRequest request) {
    State& state = *m_state;
    const bool sameSystem = !state.scene.system.maps.empty() && request.system == state.request.system &&
                            request.moved == state.request.moved;
    state.request = std::move(request);
    if (!sameSystem) state.scene.setSystem(preparedSpace(state.request.system, state.request.moved));
    const auto& cage = state.request.cage;
    state.cage = cage && ifs::isValid(*cage) ? ifs::displayMap(*cage) : ifs::AffineMap<3>();
    state.scene.setKey(state.request.key);
    state.scene.setView(spaceView(state.request, state.cage));
    const auto threads = static_cast<std::size_t>(std::clamp(state.request.threads, 1, 256));
    if (!state.workers || state.workers->size() != threads)
        state.workers = std::make_unique<Workers>(threads);
}

bool SolidRendering::draw(const std::stop_token& stop) {
    return m_state->draw(0, m_state->request.camera.size.height, stop);
}

bool SolidRendering::drawRows(int firstRow, int endRow, const std::stop_token& stop) {
    return m_state->draw(firstRow, endRow, stop);
}

const DepthRaster& SolidRendering::raster() const {
    return m_state->raster;
}

DepthRaster SolidRendering::takeRaster() {
    return std::exchange(m_state->raster, {});
}

RenderNote SolidRendering::note() const {
    return m_state->note;
}

SolidRendering::Work SolidRendering::work() const {
    return m_state->work;
}

} // namespace attractor
