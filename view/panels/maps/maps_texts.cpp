// SPDX-License-Identifier: MIT
#include "panels/maps/maps_texts.h"

#include "panels/maps/maps_model.h"
#include "panels/maps/maps_panel.h"

namespace view {

QString kindText(ifs::MapKind kind) {
    switch (kind) {
    case ifs::MapKind::Similarity:
        return MapsModel::tr("similarity");
    case ifs::MapKind::ReflectedSimilarity:
        return MapsModel::tr("reflected similarity");
    case ifs::MapKind::Affine:
        return MapsModel::tr("affine");
    case ifs::MapKind::Singular:
        return MapsModel::tr("singular");
    case ifs::MapKind::Constant:
        return MapsModel::tr("constant");
    }
    return {};
}

QString kindTip(ifs::MapKind kind, int dimension) {
    const bool plane = dimension == 2;
    switch (kind) {
    case ifs::MapKind::Similarity:
        return MapsModel::tr("A similarity keeps shapes: it turns, scales and shifts.");
    case ifs::MapKind::ReflectedSimilarity:
        return MapsModel::tr(
            "A reflected similarity keeps shapes but mirrors them; it also turns, scales and shifts them.");
    case ifs::MapKind::Affine:
        return MapsModel::tr("An affine map keeps lines and parallels but not angles.");
    case ifs::MapKind::Singular:
        return plane ? MapsModel::tr("A singular map takes the whole plane to a line.")
                     : MapsModel::tr("A singular map takes the whole of space to a plane or a line.");
    case ifs::MapKind::Constant:
        return plane ? MapsModel::tr("A constant map takes the whole plane to one point.")
                     : MapsModel::tr("A constant map takes the whole of space to one point.");
    }
    return {};
}

QString coefficientTip(int dimension) {
    return dimension == 2
               ? MapsModel::tr("The map takes (x, y) to (a x + b y + e, c x + d y + f).")
               : MapsModel::tr("The map takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, "
                               "g x + h y + i z + l).");
}

QString tableWhatsThis(int dimension) {
    return dimension == 2
               ? MapsPanel::tr(
                     "Each row is a map: it takes (x, y) to (a x + b y + e, c x + d y + f) and is used in "
                     "proportion to its weight p. Double-click a number or start typing to change it; the "
                     "picture follows every keystroke. Drag the number of a row to move it.")
               : MapsPanel::tr(
                     "Each row is a map: it takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, "
                     "g x + h y + i z + l) and is used in proportion to its weight p. Double-click a number "
                     "or "
                     "start typing to change it; the picture follows every keystroke. Drag the number of a "
                     "row "
                     "to move it.");
}

} // namespace view
