// SPDX-License-Identifier: MIT
#include "document/maps/branch_handles.h"
#include "document/branches/branch_as_map.h"
#include "document/branches/shown_branch.h"

#include <utility>

namespace document {

template <int Dim>
std::optional<BranchHandles<Dim>> branchHandles(const std::shared_ptr<const Fractal>& fractal,
                                                const ifs::ControlCage<Dim>& cage, const ifs::Word& branch,
                                                BranchEdit edit) {
    const auto* shape = std::get_if<Shape<Dim>>(&fractal->shape);
    if (branch.empty() || !shape) return std::nullopt;
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(shape->system);
    auto letters = ifs::overMaps(branch, active.index);
    const bool divides = edit == BranchEdit::OwnMap && branch.size() > 1;
    if (!letters || (divides && active.isLinked())) return std::nullopt;
    using Handles = decltype(BranchHandles<Dim>::handles);
    if (keepsCode(edit)) return {{Handles::ofBranch(fractal, cage, branch, edit == BranchEdit::Inside), 0}};
    const ifs::AffineMap<Dim> moved = movedBy(*shape, branch);
    if (divides) {
        auto code = std::make_shared<const Fractal>(withBranchAsMap<Dim>(*fractal, *letters));
        return {{Handles(std::move(code), cage, moved), 0}};
    }
    letters->pop_back();
    return {{Handles(fractal, cage, moved * ifs::composed<Dim>(active.maps, *letters)),
             std::size_t(branch.back())}};
}
template std::optional<BranchHandles<2>> branchHandles(const std::shared_ptr<const Fractal>&,
                                                       const ifs::ControlCage<2>&, const ifs::Word&,
                                                       BranchEdit);
template std::optional<BranchHandles<3>> branchHandles(const std::shared_ptr<const Fractal>&,
                                                       const ifs::ControlCage<3>&, const ifs::Word&,
                                                       BranchEdit);

} // namespace document
