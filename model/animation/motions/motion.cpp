// SPDX-License-Identifier: MIT
#include "animation/motions/motion.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace animation {

namespace {

constexpr double maxDegrees = 360;
constexpr std::size_t maxWaves = 64;

ifs::Matrix<2> rotation(const ifs::Vector<2>&, const ifs::Vector<3>&, double degrees) {
    const double c = attractor::cosineOfDegrees(degrees), s = attractor::sineOfDegrees(degrees);
    ifs::Matrix<2> matrix;
    matrix << c, -s, s, c;
    return matrix;
}

// Rodrigues.
ifs::Matrix<3> rotation(const ifs::Vector<3>&, const ifs::Vector<3>& axis, double degrees) {
    const double c = attractor::cosineOfDegrees(degrees), s = attractor::sineOfDegrees(degrees);
    ifs::Matrix<3> cross;
    cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    return c * ifs::Matrix<3>::Identity() + s * cross + (1 - c) * axis * axis.transpose();
}

// Exactly the map itself when the factor is the identity: the caller sees to that.
template <int Dim>
ifs::AffineMap<Dim> movedAbout(const ifs::AffineMap<Dim>& map, const ifs::Vector<Dim>& reference,
                               const ifs::Matrix<Dim>& factor) {
    const ifs::Vector<Dim> pivot = map(reference);
    return {factor * map.linear, pivot + factor * (map.translation - pivot)};
}

template <int Dim, class Move>
void forMaps(const MapIds& ids, ifs::IteratedFunctionSystem<Dim>& system, Move move) {
    for (std::size_t j = 0; j < system.maps.size(); ++j)
        if (ids.empty() || std::ranges::find(ids, system.maps[j].id) != ids.end())
            move(j, system.maps[j].map);
}

bool isCount(int cycles) {
    return cycles >= 1 && cycles <= maxCycles;
}
bool isTurns(int turns) {
    return turns != 0 && std::abs(turns) <= maxCycles;
}
bool isAngle(double degrees) {
    return std::abs(degrees) <= maxDegrees;
}
bool isUnit(const ifs::Vector<3>& axis) {
    return std::abs(axis.norm() - 1) <= 1e-9;
}
bool isWave(const Wave& wave) {
    return std::abs(wave.amplitude) <= 1 && isCount(wave.cycles) && isAngle(wave.phase) && isAngle(wave.lag);
}

template <int Dim> bool holds(const Sway<Dim>& sway) {
    return isAngle(sway.strength) && sway.root.allFinite() && isUnit(sway.axis) && !sway.waves.empty() &&
           sway.waves.size() <= maxWaves && std::ranges::all_of(sway.waves, isWave);
}
template <int Dim> bool holds(const Turn<Dim>& turn) {
    return isTurns(turn.turns) && turn.reference.allFinite() && isUnit(turn.axis);
}
template <int Dim> bool holds(const Orbit<Dim>& orbit) {
    return isTurns(orbit.turns) && orbit.centre.allFinite() && isUnit(orbit.axis);
}
template <int Dim> bool holds(const Breathe<Dim>& breathe) {
    return isCount(breathe.cycles) && std::abs(breathe.strength) < 1 && breathe.reference.allFinite();
}
bool holds(const PaletteCycle& cycle) {
    return isTurns(cycle.cycles);
}

template <int Dim>
void move(const Sway<Dim>& sway, const Moment& moment, int length, ifs::IteratedFunctionSystem<Dim>& system) {
    forMaps(sway.maps, system, [&](std::size_t j, ifs::AffineMap<Dim>& map) {
        double angle = 0;
        for (const Wave& wave : sway.waves)
            angle += wave.amplitude * attractor::sineOfDegrees(360 * phase(moment, length, wave.cycles) +
                                                               wave.phase + double(j) * wave.lag);
        angle *= sway.strength;
        if (angle != 0) map = movedAbout<Dim>(map, sway.root, rotation(sway.root, sway.axis, angle));
    });
}

template <int Dim>
void move(const Turn<Dim>& turn, const Moment& moment, int length, ifs::IteratedFunctionSystem<Dim>& system) {
    const double angle = 360 * phase(moment, length, turn.turns);
    if (angle == 0) return;
    forMaps(turn.maps, system, [&](std::size_t, ifs::AffineMap<Dim>& map) {
        map = movedAbout<Dim>(map, turn.reference, rotation(turn.reference, turn.axis, angle));
    });
}

template <int Dim>
void move(const Breathe<Dim>& breathe, const Moment& moment, int length,
          ifs::IteratedFunctionSystem<Dim>& system) {
    const double swell =
        breathe.strength * attractor::sineOfDegrees(360 * phase(moment, length, breathe.cycles));
    if (swell == 0) return;
    forMaps(breathe.maps, system, [&](std::size_t, ifs::AffineMap<Dim>& map) {
        map = movedAbout<Dim>(map, breathe.reference, (1 + swell) * ifs::Matrix<Dim>::Identity());
    });
}

} // namespace

template <int Dim> bool isValid(const Motion<Dim>& motion) {
    return std::visit([](const auto& which) { return holds(which); }, motion);
}

template <int Dim> Motion<Dim> weakened(Motion<Dim> motion, double share) {
    if (auto* sway = std::get_if<Sway<Dim>>(&motion)) sway->strength *= share;
    if (auto* breathe = std::get_if<Breathe<Dim>>(&motion)) breathe->strength *= share;
    return motion;
}

template <int Dim>
void moveMaps(const Motion<Dim>& motion, const Moment& moment, int length,
              ifs::IteratedFunctionSystem<Dim>& system) {
    if (const auto* sway = std::get_if<Sway<Dim>>(&motion)) move(*sway, moment, length, system);
    if (const auto* turn = std::get_if<Turn<Dim>>(&motion)) move(*turn, moment, length, system);
    if (const auto* breathe = std::get_if<Breathe<Dim>>(&motion)) move(*breathe, moment, length, system);
}

template <int Dim> double orbitAngle(const Motion<Dim>& motion, const Moment& moment, int length) {
    const auto* orbit = std::get_if<Orbit<Dim>>(&motion);
    return orbit ? 360 * phase(moment, length, orbit->turns) : 0;
}

void turnCage(ifs::ControlCage<2>& cage, const ifs::Vector<2>& centre, double degrees) {
    if (degrees == 0) return;
    const ifs::Matrix<2> turn = rotation(centre, ifs::Vector<3>::UnitZ(), degrees);
    for (auto& vertex : cage.current)
        vertex = centre + turn * (vertex - centre);
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template bool isValid<Dim>(const Motion<Dim>&);                                                          \
    template Motion<Dim> weakened<Dim>(Motion<Dim>, double);                                                 \
    template void moveMaps<Dim>(const Motion<Dim>&, const Moment&, int, ifs::IteratedFunctionSystem<Dim>&);  \
    template double orbitAngle<Dim>(const Motion<Dim>&, const Moment&, int);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace animation
