// SPDX-License-Identifier: MIT
#include "bench/engine_cases.h"

#include "attractor/systems.h"

#include <random>
#include <utility>

using namespace attractor;

namespace engine {

namespace {

ifs::IteratedFunctionSystem<2> randomSystem(int maps) {
    std::mt19937 random(32);
    std::uniform_real_distribution<double> u(-1, 1);
    ifs::IteratedFunctionSystem<2> result;
    for (int i = 0; i < maps; ++i)
        ifs::append<2>(result, ifs::affineMap(0.3 * u(random), 0.2 * u(random), 0.2 * u(random),
                                              0.3 * u(random), u(random), u(random)));
    return result;
}

} // namespace

std::vector<Case>& cases() {
    static std::vector<Case> all = [] {
        std::vector<Case> result;
        for (const auto& [name, system] :
             {std::pair<std::string, ifs::IteratedFunctionSystem<2>>{"sierpinski", systems::sierpinski()},
              {"fern", systems::fern()},
              {"maple", systems::maple()},
              {"flower", systems::flower()},
              {"random32", randomSystem(32)}}) {
            Case c{name, systems::request(system, tenMillion, 1920, 1080), prepared(system), {}};
            c.request.appearance = Appearance{};
            c.request.exposure = Exposure{0, 5, 1};
            result.push_back(std::move(c));
        }
        return result;
    }();
    return all;
}

RenderRequest dragged(RenderRequest request, int frame) {
    const double shift = 1e-3 * (frame % 100);
    request.cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1 + shift, 0}, {shift, 1}}};
    return request;
}

RenderRequest bent(RenderRequest request, int frame) {
    ifs::ControlCage<2> cage = ifs::polygonAtRest<2>({{3.264, 1.794},
                                                      {2.045, 4.100},
                                                      {0.992, 5.113},
                                                      {-1.210, 5.113},
                                                      {-3.018, 2.776},
                                                      {-3.434, 1.320},
                                                      {-0.116, -3.215},
                                                      {3.428, -0.152}});
    const double shift = 1e-3 * (frame % 100);
    cage.current[0] += ifs::Vector<2>(1.65 + shift, 0);
    cage.current[4] += ifs::Vector<2>(0, 1.65);
    request.cage = cage;
    return request;
}

} // namespace engine
