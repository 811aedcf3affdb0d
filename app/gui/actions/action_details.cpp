// SPDX-License-Identifier: MIT
#include "actions/action_details.h"

#include <QCoreApplication>

#include <algorithm>
#include <string_view>

namespace {

struct Details {
    Q_DECLARE_TR_FUNCTIONS(ActionDetails)
};

struct Detail {
    std::string_view id; // id of the action
    const char* text;
};

constexpr Detail details[] = {
    {"cage", QT_TRANSLATE_NOOP(
                 "ActionDetails",
                 "Drag an edge to move both its ends, the inside to move the whole cage. Ctrl rotates, Alt "
                 "scales, Shift keeps directions. The fractal follows at once, and each drag is one step "
                 "of the history.")},
    {"maps", QT_TRANSLATE_NOOP(
                 "ActionDetails",
                 "Each map is shown as the image of the cage in its colour. A corner changes one map; the "
                 "inside moves all selected maps. A drag stops where the attractor would be lost.")},
    {"branch",
     QT_TRANSLATE_NOOP(
         "ActionDetails",
         "Shift + wheel chooses how deep the branch is. The bar under the canvas says what the drag "
         "changes: a new map for this branch, the last map of its address, only this branch, or this branch "
         "and the same one inside it.")},
    {"animate",
     QT_TRANSLATE_NOOP("ActionDetails",
                       "Choose a motion, which needs no keys, or set keys. A change to something that has "
                       "keys sets a key at the playhead; any other change applies to the whole animation.")},
    {"define",
     QT_TRANSLATE_NOOP("ActionDetails", "The picture stays where it is and follows the new triangle from now "
                                        "on. Backspace removes the last point, Esc cancels.")},
    {"fit-simplex",
     QT_TRANSLATE_NOOP(
         "ActionDetails",
         "The picture stays where it is. Every point of the fractal then has barycentric coordinates "
         "that are not negative.")},
    {"reset", QT_TRANSLATE_NOOP(
                  "ActionDetails",
                  "The coefficients do not change. To keep the picture as it is and change the coefficients "
                  "instead, use Bake.")},
    {"bake", QT_TRANSLATE_NOOP("ActionDetails",
                               "Each map w becomes T w T⁻¹, where T is the affine map from the cage at rest "
                               "to the current cage. The cage is at "
                               "rest afterwards. A cage that is flat or bends the picture cannot be baked.")},
    {"place", QT_TRANSLATE_NOOP(
                  "ActionDetails",
                  "The table of maps keeps its numbers, and Bake writes the placement into them later.")},
    {"rewrite", QT_TRANSLATE_NOOP(
                    "ActionDetails",
                    "The table of maps shows the new numbers during the drag, and the cage is at rest again "
                    "afterwards.")},
    {"fit", QT_TRANSLATE_NOOP(
                "ActionDetails",
                "The cage is included if that needs little space. The fractal itself does not change.")},
    {"grid", QT_TRANSLATE_NOOP("ActionDetails", "The spacing of its lines follows the zoom. Vertices snap to "
                                                "it if this is chosen under View › Canvas › Snap To.")},
    {"y-axis", QT_TRANSLATE_NOOP("ActionDetails",
                                 "Only the view is flipped: coefficients and coordinates do not change.")},
    {"hide", QT_TRANSLATE_NOOP("ActionDetails",
                               "Press the key again to show the cage, handles, grid, axes and outlines.")},
    {"construction",
     QT_TRANSLATE_NOOP(
         "ActionDetails",
         "A bar appears under the canvas: choose the number of steps, or let the chaos game run "
         "point by point at any speed.")},
    {"transform", QT_TRANSLATE_NOOP(
                      "ActionDetails",
                      "As a placement, it leaves the coefficients unchanged; as code, it replaces them by "
                      "those of the transformed fractal. The canvas shows the result before you accept it.")},
    {"paste",
     QT_TRANSLATE_NOOP("ActionDetails",
                       "If a table does not name its columns, you are asked for their order. In the "
                       "Maps panel, Paste adds the copied maps, or rows of numbers, to the fractal.")},
    {"cut", QT_TRANSLATE_NOOP("ActionDetails",
                              "Acts on maps while the table of maps, or the canvas with the Maps tool, has "
                              "the focus, and on entries while the list of entries has it.")},
    {"copy",
     QT_TRANSLATE_NOOP("ActionDetails",
                       "Maps are copied with their names and as rows of numbers, entries as .ifs text "
                       "that other programs can read.")},
    {"lock",
     QT_TRANSLATE_NOOP(
         "ActionDetails",
         "A locked map cannot be edited in the table, dragged, nudged, arranged, fitted or deleted. Changes "
         "to the whole fractal, such as a cage that rewrites the code, also change its locked maps.")},
    {"solo", QT_TRANSLATE_NOOP("ActionDetails",
                               "Draws only the part of the attractor that this map makes. The file does not "
                               "change. If you select another entry, its whole attractor is shown.")},
    {"settings",
     QT_TRANSLATE_NOOP(
         "ActionDetails",
         "A new language takes effect at the next start; everything else at once, in all windows.")},
};

} // namespace

QString actionDetails(std::string_view id) {
    const auto* found = std::ranges::find(details, id, &Detail::id);
    return found == std::end(details) ? QString() : Details::tr(found->text);
}
