// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/control_cage.h"

#include <memory>
#include <utility>

namespace document {

// The cage that holds a fractal without one of its own while it is played or edited live: that of another
// state of it, so that it does not hop with every frame. No part of a value: any two are equal.
class LastingCage {
public:
    LastingCage() = default;
    explicit LastingCage(ifs::ControlCage<2> cage)
        : m_plane(std::make_shared<const ifs::ControlCage<2>>(std::move(cage))) {}
    explicit LastingCage(ifs::ControlCage<3> cage)
        : m_space(std::make_shared<const ifs::ControlCage<3>>(std::move(cage))) {}

    const ifs::ControlCage<2>* plane() const { return m_plane.get(); } // nullptr: none
    const ifs::ControlCage<3>* space() const { return m_space.get(); }
    explicit operator bool() const { return m_plane || m_space; }

    friend bool operator==(const LastingCage&, const LastingCage&) { return true; }

private:
    std::shared_ptr<const ifs::ControlCage<2>> m_plane;
    std::shared_ptr<const ifs::ControlCage<3>> m_space;
};

} // namespace document
