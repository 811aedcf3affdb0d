// SPDX-License-Identifier: MIT
#include "collage/measure/transport_bound.h"

#include "animation/transport.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace collage {

namespace {

using Lump = TransportBound::Lump;

constexpr std::size_t maxLumps = 400; // largest number of lumps for an exact solution

Lump together(const Lump& a, const Lump& b) {
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;
    const double mass = a.mass + b.mass, share = b.mass / mass;
    return {mass, a.mean + share * (b.mean - a.mean),
            (1 - share) * a.variance + share * b.variance +
                share * (1 - share) * (b.mean - a.mean).squaredNorm()};
}

// The distance of a unit of mass, if each point of a sends to all of b alike: the root of the mean square is
// no less than the mean.
double distance(const Lump& a, const Lump& b) {
    return std::sqrt((a.mean - b.mean).squaredNorm() + a.variance + b.variance);
}

// The supply and the demand that are left in a square; one of them has no mass.
struct Square {
    Lump supply, demand;
};

// Settles the nearest lumps of the parts first; the remaining ones become one square.
Square settled(std::vector<Square>& parts, double& cost) {
    for (;;) {
        Lump* from = nullptr;
        Lump* to = nullptr;
        double least = HUGE_VAL;
        for (Square& a : parts)
            for (Square& b : parts) {
                if (a.supply.mass == 0 || b.demand.mass == 0) continue;
                const double here = distance(a.supply, b.demand);
                if (here >= least) continue;
                least = here;
                from = &a.supply;
                to = &b.demand;
            }
        if (from == nullptr) break;
        const double amount = std::min(from->mass, to->mass);
        cost += amount * least;
        from->mass -= amount;
        to->mass -= amount;
    }
    Square all;
    for (const Square& part : parts) {
        all.supply = together(all.supply, part.supply);
        all.demand = together(all.demand, part.demand);
    }
    return all;
}

struct Level {
    int width, height;
    std::vector<Square> squares;
};

Level coarser(const Level& fine, double& cost) {
    Level level{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    std::vector<Square> parts;
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) {
            parts.clear();
            for (int v = 2 * y; v < std::min(2 * y + 2, fine.height); ++v)
                for (int u = 2 * x; u < std::min(2 * x + 2, fine.width); ++u)
                    parts.push_back(fine.squares[std::size_t(v) * std::size_t(fine.width) + std::size_t(u)]);
            level.squares.push_back(settled(parts, cost));
        }
    return level;
}

double transportCost(const std::vector<Lump>& supply, const std::vector<Lump>& demand,
                     const std::stop_token& stop) {
    if (supply.empty() || demand.empty()) return 0;
    const auto amounts = [](const std::vector<Lump>& lumps) {
        std::vector<double> masses;
        double sum = 0;
        for (const Lump& lump : lumps)
            sum += lump.mass;
        for (const Lump& lump : lumps)
            masses.push_back(lump.mass / sum);
        return std::pair(std::move(masses), sum);
    };
    Eigen::MatrixXd cost(Eigen::Index(supply.size()), Eigen::Index(demand.size()));
    for (Eigen::Index i = 0; i < cost.rows(); ++i)
        for (Eigen::Index k = 0; k < cost.cols(); ++k)
            cost(i, k) = distance(supply[std::size_t(i)], demand[std::size_t(k)]);
    const auto [from, mass] = amounts(supply);
    double sum = 0;
    for (const auto& shipment : animation::transport(from, amounts(demand).first, cost, stop))
        sum += shipment.amount * cost(Eigen::Index(shipment.from), Eigen::Index(shipment.to));
    return mass * sum;
}

} // namespace

TransportBound::TransportBound(int width, int height)
    : m_width(width),
      m_height(height),
      m_supply(std::size_t(width) * std::size_t(height)),
      m_demand(m_supply.size()) {}

void TransportBound::add(std::vector<Lump>& to, const Lump& lump) const {
    const double column = std::clamp(std::floor(lump.mean.x()), 0.0, m_width - 1.0);
    const double row = std::clamp(std::floor(lump.mean.y()), 0.0, m_height - 1.0);
    Lump& there = to[std::size_t(row) * std::size_t(m_width) + std::size_t(column)];
    there = together(there, lump);
}

double TransportBound::cost(const std::stop_token& stop) && {
    double cost = 0;
    Level level{m_width, m_height, {}};
    for (std::size_t k = 0; k < m_supply.size(); ++k) {
        std::vector<Square> one{{m_supply[k], m_demand[k]}};
        level.squares.push_back(settled(one, cost));
    }
    std::vector<Lump> supply, demand;
    while (!stop.stop_requested()) {
        supply.clear();
        demand.clear();
        for (const Square& square : level.squares) {
            if (square.supply.mass > 0) supply.push_back(square.supply);
            if (square.demand.mass > 0) demand.push_back(square.demand);
        }
        if (supply.size() + demand.size() <= maxLumps || level.squares.size() == 1) break;
        level = coarser(level, cost);
    }
    return cost + transportCost(supply, demand, stop);
}

} // namespace collage
