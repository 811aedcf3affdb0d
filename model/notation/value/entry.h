// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "attractor/request/appearance.h"
#include "ifs/cage/control_cage.h"
#include "ifs/system/branch.h"
#include "ifs/system/iterated_function_system.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

// One entry of an .ifs file as a plain value, without Qt: what is drawn, computed and written from it.
// document::Fractal is what the window edits.
namespace notation {

// The code of an entry, by what it is held, and what of it is shown elsewhere.
template <int Dim> struct Figure {
    ifs::IteratedFunctionSystem<Dim> system; // ids 1, 2, … in the order of the maps
    std::optional<ifs::ControlCage<Dim>> cage{};
    std::vector<animation::BranchPose<Dim>> moved{}; // MapId::None first: the change recurs inside itself

    friend bool operator==(const Figure&, const Figure&) = default;
};

// Why an entry is none, and where: line and column of the file count from 1, the column in bytes.
struct Flaw {
    int line = 1;
    int column = 1;
    std::string sentence; // in English

    friend bool operator==(const Flaw&, const Flaw&) = default;
};

struct Entry {
    std::string name;
    std::string headerComment;         // text after the opening brace, without the semicolon
    std::vector<std::string> comments; // comment lines of the entry, without the semicolon
    std::variant<std::monostate, Figure<2>, Figure<3>> figure;
    attractor::Appearance appearance;
    // Lines of Barycage's without meaning here; those of an animation: notation/moments.
    std::vector<std::string> otherLines;
    std::optional<Flaw> flaw; // set for an entry without a figure

    friend bool operator==(const Entry&, const Entry&) = default;
};

// What is moved, as words over indices into the system; see ifs::pieces(). Branches that are moved once come
// first: they move what the others have moved. Those with a map that is gone are left out.
template <int Dim>
std::vector<ifs::MovedBranch<Dim>> movedBranches(const ifs::IteratedFunctionSystem<Dim>& system,
                                                 const std::vector<animation::BranchPose<Dim>>& moved);

} // namespace notation
