// SPDX-License-Identifier: MIT
#include "convert/symmetry_arguments.h"

#include "options/options.h"
#include "options/tr.h"
#include "options/usage_error.h"

#include "document/edits/maps/link_expansion.h"
#include "document/edits/maps/symmetry_edits.h"

#include <memory>
#include <utility>

namespace cli {

namespace {

template <int Dim>
std::optional<document::Fractal> symmetric(const document::Fractal& fractal, const io::NamedSymmetry& named) {
    const auto symmetry = io::symmetryIn<Dim>(named);
    return symmetry ? std::optional(document::withSymmetry(fractal, *symmetry)) : std::nullopt;
}

io::NamedSymmetry symmetryArgument(const std::string&, const std::string& text) {
    if (const auto symmetry = io::symmetryNamed(QString::fromStdString(text))) return *symmetry;
    throw UsageError{tr("--symmetry “%1” is not a symmetry: it must be none, mirror, c2 to c24, d2 to d24, "
                        "tetrahedral, octahedral or icosahedral, optionally followed by an angle in degrees "
                        "(mirror:30, d6:15) and a centre (c6@1,2).")
                         .arg(QString::fromStdString(text))};
}

std::vector<std::string> symmetryWords() {
    std::vector<std::string> words{"none", "mirror"};
    for (const char kind : {'c', 'd'})
        for (int order = 2; order <= 24; ++order)
            words.push_back(kind + std::to_string(order));
    for (const char* polyhedral : {"tetrahedral", "octahedral", "icosahedral"})
        words.emplace_back(polyhedral);
    return words;
}

} // namespace

void addSymmetryOptions(Command& command, SymmetryArguments& arguments) {
    const OptionGroup group = command.group("Symmetry");
    group
        .add("--symmetry", "GROUP[:DEGREES][@X,Y[,Z]]", parsed(&arguments.symmetry, symmetryArgument),
             "Make entries symmetric: none, mirror, c2 to c24 (rotation), d2 to d24 (dihedral); in space "
             "also tetrahedral, octahedral, icosahedral. mirror:30 sets the angle of a mirror, c6@1,2 the "
             "centre")
        .moreOf("Each map also acts rotated or mirrored. The centre is otherwise the origin. In space "
                "the first four leave z unchanged.")
        .completedBy(Completion::Kind::Words, symmetryWords());
    group
        .flag("--expand", &arguments.expand,
              "Write the plain maps that a symmetry or linked maps stand for, where they exist")
        .moreOf("This is for programs that support neither. Entries whose linked maps have no plain "
                "equivalent are omitted, with status 1; a warning is printed if the plain maps have "
                "other densities.");
}

std::optional<QString> changeSymmetry(document::Entry& entry, const SymmetryArguments& change) {
    if (!change.symmetry) return std::nullopt;
    const document::Fractal& fractal = *entry.fractal;
    const std::size_t order = ifs::groupOrder(change.symmetry->group, change.symmetry->order);
    if (QString reason = document::symmetryObstacle(fractal, order); !reason.isEmpty()) return reason;
    auto changed = document::space(fractal) ? symmetric<3>(fractal, *change.symmetry)
                                            : symmetric<2>(fractal, *change.symmetry);
    if (!changed)
        return tr("“%1” was omitted: it is a system in the plane, where neither the symmetries of the "
                  "polyhedra "
                  "nor centres of three coordinates exist; --lift makes a system in space of it.")
            .arg(fractal.name);
    entry.fractal = std::make_shared<const document::Fractal>(*std::move(changed));
    return std::nullopt;
}

Expansion expanded(document::Entry& entry, const SymmetryArguments& change) {
    Expansion result;
    if (!change.expand) return result;
    if (document::isSymmetric(*entry.fractal)) {
        if (const QString reason = document::expandObstacle(*entry.fractal); !reason.isEmpty())
            return {reason, {}};
        entry.fractal = std::make_shared<const document::Fractal>(document::expanded(*entry.fractal));
    }
    const document::Fractal& fractal = *entry.fractal;
    if (!document::isLinked(fractal)) return result;
    if (const QString reason = document::linkExpansionObstacle(fractal); !reason.isEmpty())
        return {reason, {}};
    if (!document::linkExpansionKeepsDensity(fractal))
        result.warning =
            tr("The plain maps of “%1” have the attractor of its linked maps, but other densities: "
               "the brightness of the picture changes.")
                .arg(fractal.name);
    entry.fractal = std::make_shared<const document::Fractal>(document::withLinksExpanded(fractal));
    return result;
}

} // namespace cli
