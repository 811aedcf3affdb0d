// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <stop_token>
#include <vector>

namespace animation {

struct Shipment {
    std::size_t from = 0;
    std::size_t to = 0;
    double amount = 0; // > 0

    friend bool operator==(const Shipment&, const Shipment&) = default;
};

// The cheapest way to ship `supply` to `demand`, both positive with the same sum, where a unit from i to k
// costs cost(i, k): a vertex of the transport polytope, so at most one shipment fewer than there are places,
// by place of origin and then by destination. The network simplex on the spanning trees of the places. When
// stopped, a way to ship it that need not be the cheapest.
std::vector<Shipment> transport(const std::vector<double>& supply, const std::vector<double>& demand,
                                const Eigen::MatrixXd& cost, const std::stop_token& stop = {});

} // namespace animation
