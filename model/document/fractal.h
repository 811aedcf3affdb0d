// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/appearance.h"
#include "attractor/renderer.h"
#include "ifs/control_cage.h"
#include "ifs/iterated_function_system.h"
#include "ifs/support_function.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <variant>

namespace document {

using System2 = ifs::IteratedFunctionSystem<2>;
using System3 = ifs::IteratedFunctionSystem<3>;

// A branch, by the ids of the maps of its address, that is shown elsewhere: ifs::MovedBranch.
struct MovedBranch {
    std::vector<ifs::MapId> word;
    ifs::AffineMap<2> change;

    friend bool operator==(const MovedBranch&, const MovedBranch&) = default;
};

// One entry of a file, as a plain value.
struct Fractal {
    QString name;
    QString headerComment; // what follows the opening brace, without the semicolon
    QStringList comments;  // the entry's own comment lines in their order, without the semicolon
    // monostate: the entry could not be read; its bytes are kept in its source.
    std::variant<std::monostate, System2, System3> system;
    std::optional<ifs::ControlCage<2>> cage; // nullopt: the minimal canonical simplex of the code, at rest
    std::vector<MovedBranch> moved;          // each word once
    attractor::Appearance appearance;

    friend bool operator==(const Fractal&, const Fractal&) = default;
};

inline const System2* system2(const Fractal& fractal) {
    return std::get_if<System2>(&fractal.system);
}
inline System2* system2(Fractal& fractal) {
    return std::get_if<System2>(&fractal.system);
}
int dimension(const Fractal& fractal); // 2 or 3; 0 for an unreadable entry

// The extent of the code's attractor; nullptr when it has none. Any thread. Those of the last few systems of
// many maps are remembered: while only the cage moves, the same is asked for again and again.
std::shared_ptr<const ifs::SupportFunction<2>> supportFunction(const Fractal& fractal);

// The cage in force: the stored one, else the minimal canonical simplex of the code at rest (or, when the
// code has no attractor, a unit triangle). Costs a certified simplex when none is stored.
ifs::ControlCage<2> effectiveCage(const Fractal& fractal);

// Coordinates of the code → displayed ones.
ifs::Placement placement(const Fractal& fractal);

// The branches that are moved, as words over places in the system. Those with a map that is gone are left
// out.
std::vector<ifs::MovedBranch<2>> movedBranches(const Fractal& fractal);

// The code becomes M∘w∘M⁻¹, and so does what moves its branches; nullopt unless it is a plane system and M
// can be inverted. The cage stays.
std::optional<Fractal> conjugated(const Fractal& fractal, const ifs::AffineMap<2>& transformation);

// The code takes up its cage (ifs::bake); nullopt where that cannot be.
std::optional<Fractal> withCageBaked(const Fractal& fractal);

// The maps of the code as they act on the displayed picture, M_c∘w∘M_c⁻¹; nullopt while the placement is flat
// or bent.
std::optional<System2> effectiveSystem(const Fractal& fractal);

// The request that draws the fractal through the camera with default quality.
attractor::RenderRequest renderRequest(const Fractal& fractal, const attractor::Camera& camera);

// Certified box of what is displayed (the attractor under its cage), under a bend to a hundredth of its size;
// nullopt when there is none.
struct Box {
    ifs::Vector<2> min;
    ifs::Vector<2> max;
};
std::optional<Box> displayedBox(const Fractal& fractal);

Fractal sierpinskiTriangle(); // what File → New starts with

} // namespace document
