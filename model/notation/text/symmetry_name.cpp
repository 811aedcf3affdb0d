// SPDX-License-Identifier: MIT
#include "notation/text/symmetry_name.h"

#include "notation/text/bytes.h"
#include "notation/text/number.h"
#include "notation/text/words.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace notation {

namespace {

using enum ifs::SymmetryGroup;

struct GroupName {
    ifs::SymmetryGroup group;
    const char* name;
};
constexpr std::array groupNames{GroupName{None, "none"}, GroupName{Mirror, "mirror"},
                                GroupName{Tetrahedral, "tetrahedral"}, GroupName{Octahedral, "octahedral"},
                                GroupName{Icosahedral, "icosahedral"}};

bool readGroup(std::string_view text, NamedSymmetry& result) {
    const std::string name = lowered(text);
    for (const GroupName& known : groupNames)
        if (name == known.name) {
            result.group = known.group;
            return true;
        }
    if (name.size() < 2 || name.size() > 3) return false;
    if (name[0] != 'c' && name[0] != 'd') return false;
    if (name.find_first_not_of("0123456789", 1) != std::string::npos) return false;
    result.group = name[0] == 'c' ? Rotation : Dihedral;
    result.order = wholeNumber(std::string_view(name).substr(1));
    return result.order >= ifs::minSymmetryOrder && result.order <= ifs::maxSymmetryOrder;
}

bool readCentre(std::string_view text, NamedSymmetry& result) {
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto coordinate = parseNumber(text.substr(begin, end - begin));
        if (!coordinate) return false;
        result.centre.push_back(*coordinate);
        begin = end + 1;
    }
    return result.centre.size() == 2 || result.centre.size() == 3;
}

} // namespace

std::optional<NamedSymmetry> symmetryNamed(std::string_view text) {
    NamedSymmetry result;
    text = trimmed(text);
    if (const std::size_t at = text.find('@'); at != std::string_view::npos) {
        if (!readCentre(text.substr(at + 1), result)) return std::nullopt;
        text = text.substr(0, at);
    }
    if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
        result.angle = parseNumber(text.substr(colon + 1));
        if (!result.angle) return std::nullopt;
        text = text.substr(0, colon);
    }
    if (!readGroup(text, result)) return std::nullopt;
    if (result.angle && result.group != Mirror && result.group != Dihedral) return std::nullopt;
    return result;
}

template <int Dim> std::optional<ifs::Symmetry<Dim>> symmetryIn(const NamedSymmetry& named) {
    if (named.centre.size() > Dim) return std::nullopt;
    ifs::Symmetry<Dim> symmetry{named.group, named.order, named.angle.value_or(0)};
    if (named.group == None) return symmetry;
    for (std::size_t i = 0; i < named.centre.size(); ++i)
        symmetry.centre[Eigen::Index(i)] = named.centre[i];
    return ifs::isValid(symmetry) ? std::optional(symmetry) : std::nullopt;
}
template std::optional<ifs::Symmetry<2>> symmetryIn<2>(const NamedSymmetry&);
template std::optional<ifs::Symmetry<3>> symmetryIn<3>(const NamedSymmetry&);

std::string symmetryName(ifs::SymmetryGroup group, int order) {
    if (group == Rotation) return 'c' + std::to_string(order);
    if (group == Dihedral) return 'd' + std::to_string(order);
    return std::ranges::find(groupNames, group, &GroupName::group)->name;
}

} // namespace notation
