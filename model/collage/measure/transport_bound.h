// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <stop_token>
#include <vector>

namespace collage {

// An upper bound of the Monge–Kantorovich distance of two measures: the least cost, mass times distance, of
// moving one to the other. Both are added lump by lump, on a grid whose cells are the unit of length; lumps
// outside count, too. docs/mathematics.md, "Collages".
class TransportBound {
public:
    TransportBound(int width, int height);

    // Mass around its mean; `variance` is that of its distance to the mean.
    struct Lump {
        double mass = 0;
        ifs::Vector<2> mean = ifs::Vector<2>::Zero();
        double variance = 0;
    };
    void addSupply(const Lump& lump) { add(m_supply, lump); }
    void addDemand(const Lump& lump) { add(m_demand, lump); }

    // Supply and demand must have the same mass. Can be called once; the result is meaningless when stopped.
    double cost(const std::stop_token& stop = {}) &&;

private:
    void add(std::vector<Lump>& to, const Lump& lump) const;

    int m_width;
    int m_height;
    std::vector<Lump> m_supply; // one for each cell
    std::vector<Lump> m_demand;
};

} // namespace collage
