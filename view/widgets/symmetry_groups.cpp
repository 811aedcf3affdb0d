// SPDX-License-Identifier: MIT
#include "widgets/symmetry_groups.h"
#include "document/text/text.h"
#include "widgets/choices.h"

#include <QComboBox>
#include <QSignalBlocker>

namespace view {

namespace {

using enum ifs::SymmetryGroup;

} // namespace

bool hasOrder(ifs::SymmetryGroup group) {
    return group == Rotation || group == Dihedral;
}

bool hasMirrors(ifs::SymmetryGroup group) {
    return group == Mirror || group == Dihedral;
}

void fillSymmetryGroups(QComboBox* box, int dimension) {
    const QSignalBlocker quiet(box);
    box->clear();
    const auto add = [box](const QString& text, ifs::SymmetryGroup group) { addChoice(box, text, group); };
    add(Text::tr("None"), None);
    add(Text::tr("Mirror"), Mirror);
    add(Text::tr("Rotation"), Rotation);
    add(Text::tr("Dihedral"), Dihedral);
    if (dimension != 3) return;
    add(Text::tr("Tetrahedral"), Tetrahedral);
    add(Text::tr("Octahedral"), Octahedral);
    add(Text::tr("Icosahedral"), Icosahedral);
}

ifs::SymmetryGroup chosenSymmetryGroup(const QComboBox* box) {
    return chosenValue<ifs::SymmetryGroup>(box);
}

} // namespace view
