// SPDX-License-Identifier: MIT
#include "animation/motions/moved_back.h"
#include "ifs/extent/extent.h"
#include "ifs/links/linked_existence.h"
#include "ifs/links/linked_extent.h"
#include "notation/moments/entry_moment.h"
#include "notation/text/number.h"
#include "notation/text/words.h"
#include "web/engine.h"
#include "web/engine_rows.h"
#include "web/engine_state.h"

#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

namespace web {

namespace {

template <int Dim> bool orbits(const animation::Animation<Dim>& animation) {
    return std::ranges::any_of(animation.motions, [](const animation::Motion<Dim>& motion) {
        return std::holds_alternative<animation::Orbit<Dim>>(motion);
    });
}

template <int Dim> void readAnimation(Loaded<Dim>& loaded, std::string_view lines, bool ownsCage) {
    notation::Entry entry;
    notation::Figure<Dim> figure{loaded.system};
    if (ownsCage) figure.cage = loaded.cage;
    entry.figure = std::move(figure);
    for (const std::string& line : notation::words(lines, '\n')) {
        std::string_view comment = notation::trimmed(line);
        if (comment.starts_with(';')) comment.remove_prefix(1);
        if (notation::isOwnComment(comment)) entry.otherLines.emplace_back(comment);
    }
    loaded.animation = notation::animationOf<Dim>(entry);
    // A turn of the plane turns the cage, which an entry without one then has all the same.
    loaded.ownsCage = ownsCage || (Dim == 2 && loaded.animation && orbits<Dim>(*loaded.animation));
}

template <int Dim> void writeFacts(const Loaded<Dim>& loaded, double* facts) {
    const animation::Animation<Dim>& animation = *loaded.animation;
    for (const double fact :
         {double(animation.rate.frames), double(animation.rate.seconds), double(animation.length),
          double(animation::lastFrame(animation.loop, animation.length)), double(animation.loop),
          double(!animation.cage.empty()), double(!animation.camera.empty()), double(!animation.look.empty()),
          double(orbits<Dim>(animation))})
        *facts++ = fact;
    for (const auto& map : loaded.system.maps)
        *facts++ = double(std::ranges::find(animation.maps, map.id, &animation::MapTrack<Dim>::map) !=
                          animation.maps.end());
}

// Branches that keys move are named by ids, and all others by indices.
template <int Dim>
std::vector<animation::BranchPose<Dim>> named(const std::vector<ifs::MovedBranch<Dim>>& moved,
                                              const ifs::IteratedFunctionSystem<Dim>& system) {
    std::vector<animation::BranchPose<Dim>> poses;
    for (const ifs::MovedBranch<Dim>& branch : moved) {
        animation::BranchPose<Dim>& pose = poses.emplace_back();
        pose.change = branch.change;
        for (const int symbol : branch.word)
            pose.word.push_back(system.maps[std::size_t(symbol)].id);
    }
    return poses;
}

double* writeCamera(const animation::CameraPose<2>& view, double* to) {
    to = written(view.centre, to);
    for (const double number : {view.height, double(view.yAxis == attractor::YAxis::Down), view.rotation})
        *to++ = number;
    return to;
}

double* writeCamera(const attractor::OrbitCamera& camera, double* to) {
    to = written(camera.target, to);
    to = written(ifs::Matrix<3>(camera.orientation.toRotationMatrix()), to);
    *to++ = camera.height;
    *to++ = camera.projection == attractor::OrbitCamera::Projection::Perspective ? camera.fieldOfView : 0;
    return to;
}

template <int Dim>
int writeShown(const Engine& engine, const Shown<Dim>& shown, double* rows, double* vertices,
               double* camera) {
    for (const auto& map : shown.system.maps) {
        rows = written<Dim>(map.map, rows);
        *rows++ = map.enabled ? map.weight.value_or(std::numeric_limits<double>::quiet_NaN()) : 0;
    }
    if (shown.cage)
        for (const auto& vertex : shown.cage->current)
            vertices = written(vertex, vertices);
    if constexpr (Dim == 3)
        writeCamera(engine.cameraOf(shown), camera);
    else if (shown.camera)
        writeCamera(*shown.camera, camera);
    else
        return 0;
    return 1;
}

// For a view with a margin.
constexpr double roughly = 1e-3;

template <int Dim>
std::optional<ifs::BoundingBox<Dim>> boxOf(const ifs::IteratedFunctionSystem<Dim>& system) {
    const auto active = ifs::activeMaps(system);
    if constexpr (Dim == 2)
        if (active.isLinked()) {
            const auto linked = ifs::LinkedExtent::of(active, ifs::classifyLinked<2>(active));
            return linked ? std::optional(ifs::boundingBox(*linked)) : std::nullopt;
        }
    const auto support = ifs::SupportFunction<Dim>::of(active.maps);
    return support ? std::optional(ifs::boundingBox(*support, roughly * support->radius())) : std::nullopt;
}

template <int Dim>
void makeStill(const Engine& engine, const Loaded<Dim>& loaded, std::size_t map, double* row) {
    if (!engine.moment || !loaded.animation || map >= loaded.system.maps.size()) return;
    const animation::Animation<Dim>& animation = *loaded.animation;
    ifs::IteratedFunctionSystem<Dim> system = loaded.system;
    system.maps[map].map = mapAt<Dim>(row);
    const auto moment = animation::folded(*engine.moment, animation.loop, animation.length);
    system = animation::movedBack<Dim>(animation.motions, moment, animation.length, std::move(system));
    written<Dim>(system.maps[map].map, row);
}

} // namespace

template <int Dim> Shown<Dim> Engine::shown(const Loaded<Dim>& loaded) const {
    if (!knowsMotion || !moment || !loaded.animation)
        return {loaded.system, loaded.cage, loaded.moved, appearance, inSpace, {}, {}};
    const bool movesBranches = !loaded.animation->branches.empty();
    animation::Pose<Dim> still{loaded.system, {}, {}, appearance, {}, {}, inSpace};
    if (loaded.ownsCage) still.cage = loaded.cage;
    if (movesBranches) still.moved = named<Dim>(loaded.moved, loaded.system);
    animation::Pose<Dim> pose = loaded.animation->at(*moment, std::move(still));
    auto moved = movesBranches ? notation::movedBranches<Dim>(pose.system, pose.moved) : loaded.moved;
    return {std::move(pose.system), loaded.ownsCage ? std::move(pose.cage) : loaded.cage,
            std::move(moved),       std::move(pose.appearance),
            pose.inSpace,           pose.camera,
            std::move(pose.orbit)};
}
template Shown<2> Engine::shown<2>(const Loaded<2>&) const;
template Shown<3> Engine::shown<3>(const Loaded<3>&) const;

attractor::Camera Engine::cameraOf(const Shown<2>& shown) const {
    if (!followsCamera || !shown.camera) return camera;
    return attractor::cameraOf(*shown.camera, {camera.width, camera.height});
}

attractor::OrbitCamera Engine::cameraOf(const Shown<3>& shown) const {
    attractor::OrbitCamera seen = orbit;
    if (followsCamera && shown.camera) {
        seen = *shown.camera;
        seen.size = orbit.size;
    }
    return animation::orbited(seen, shown.orbit);
}

} // namespace web

int barycage_animation(web::Engine* engine, const char* lines, int ownsCage, double* facts) {
    if (!web::knowsMotion) return 0;
    return engine->with([&](auto& loaded) {
        web::readAnimation(loaded, lines, ownsCage != 0);
        if (!loaded.animation) return 0;
        web::writeFacts(loaded, facts);
        return 1;
    });
}

void barycage_moment(web::Engine* engine, int frame, int followsCamera) {
    engine->moment = frame < 0 ? std::nullopt : std::optional(animation::moment(frame));
    engine->followsCamera = followsCamera != 0;
}

int barycage_shown(web::Engine* engine, double* rows, double* vertices, double* camera) {
    return engine->with([&](const auto& loaded) {
        return web::writeShown(*engine, engine->shown(loaded), rows, vertices, camera);
    });
}

int barycage_reach(web::Engine* engine, double* box) {
    return engine->with([&](const auto& loaded) {
        const auto found = web::boxOf(engine->shown(loaded).system);
        if (!found) return 0;
        *web::written(found->max, web::written(found->min, box)) = found->error;
        return 1;
    });
}

void barycage_still(web::Engine* engine, int map, double* row) {
    if (web::knowsMotion)
        engine->with([&](const auto& loaded) { web::makeStill(*engine, loaded, std::size_t(map), row); });
}

void barycage_turn(web::Engine* engine, double rotation, int isDown) {
    engine->camera.rotation = rotation;
    engine->camera.yAxis = isDown != 0 ? attractor::YAxis::Down : attractor::YAxis::Up;
}
