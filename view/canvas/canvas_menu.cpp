// SPDX-License-Identifier: MIT
#include "canvas/canvas_menu.h"

#include "canvas/scene/handle_text.h"
#include "canvas/tools/vertex_dialog.h"
#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/map_locks.h"
#include "document/edits/maps/maps_edits.h"
#include "document/fractal/fractal.h"
#include "document/maps/map_names.h"

#include <QAbstractScrollArea>
#include <QCoreApplication>
#include <QKeySequence>
#include <QMenu>

#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace view {

namespace {

struct Menu {
    Q_DECLARE_TR_FUNCTIONS(view::CanvasMenu)
};

using Kind = CanvasPart::Kind;

QAction* add(QMenu& menu, const QString& text, const QString& tip, std::function<void()> act) {
    QAction* action = menu.addAction(text);
    action->setStatusTip(tip);
    action->setToolTip(tip);
    QObject::connect(action, &QAction::triggered, &menu, [act = std::move(act)] { act(); });
    return action;
}

// Runs an operation on the document; why it could not be done goes to the status bar.
std::function<void()> attempt(const MenuContext& context, std::function<std::optional<QString>()> operation) {
    return [context, operation = std::move(operation)] {
        if (const std::optional<QString> failure = operation()) emit context.tools.message(*failure);
    };
}

// The key is the canvas's own, not a shortcut of the menu.
QString withKey(const QString& text, Qt::Key key) {
    return text + u'\t' + QKeySequence(key).toString(QKeySequence::NativeText);
}

void addVertexActions(QMenu& menu, const MenuContext& context, int index) {
    const ifs::ControlCage<2> cage = *context.scene.handles().cage();
    const ifs::Vector<2> position = cage.current[std::size_t(index)];
    const ifs::Vector<2> rest = cage.rest[std::size_t(index)];
    document::Document& document = context.scene.document();
    menu.addSection(Menu::tr("Vertex %1").arg(index + 1));
    add(menu, Menu::tr("&Coordinates…"), Menu::tr("Lets you type the coordinates of this vertex"),
        [context, index] {
            auto* dialog = new VertexDialog(&context.scene.document(), index, &context.view);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->open();
        });
    add(menu, Menu::tr("&Reset This Vertex"), Menu::tr("Returns this vertex to its position at rest"),
        attempt(context, [&document, index] { return resetVertex(document, index); }))
        ->setEnabled(position != rest);
    SnapTargets targets = context.scene.snapTargets({Kind::Vertex, index}, {index});
    targets.snapping = SnapTo::Grid;
    const double step = gridSpacing(targets.camera.pixelsPerUnit).minor;
    const ifs::Vector<2> onGrid(gridLabel(step, std::round(position.x() / step)).toDouble(),
                                gridLabel(step, std::round(position.y() / step)).toDouble());
    add(menu, Menu::tr("Snap to &Grid Point (%1, %2)").arg(onGrid.x()).arg(onGrid.y()),
        Menu::tr("Moves this vertex to the nearest point of the grid"),
        attempt(context, [&document, index, onGrid] { return moveVertex(document, index, onGrid); }))
        ->setEnabled(onGrid != position);
    add(menu, Menu::tr("Snap to the &x Axis"), Menu::tr("Moves this vertex straight to the x axis"),
        attempt(context,
                [&document, index, position] {
                    return moveVertex(document, index, {position.x(), 0});
                }))
        ->setEnabled(position.y() != 0);
    add(menu, Menu::tr("Snap to the &y Axis"), Menu::tr("Moves this vertex straight to the y axis"),
        attempt(context,
                [&document, index, position] {
                    return moveVertex(document, index, {0, position.y()});
                }))
        ->setEnabled(position.x() != 0);
    add(menu, withKey(Menu::tr("&Delete This Vertex"), Qt::Key_Delete),
        Menu::tr("Removes this vertex from the cage"),
        attempt(context, [&document, index] { return removeVertices(document, {std::size_t(index)}); }))
        ->setEnabled(cage.rest.size() > 3);
    add(menu, Menu::tr("Put the &Pivot Here"), Menu::tr("Rotates and scales the cage about this vertex"),
        [context, position] { context.scene.handles().setPivot(position); });
}

void addMapActions(QMenu& menu, const MenuContext& context, int index) {
    document::Document& document = context.scene.document();
    const QString number = QString::number(index + 1);
    const bool hasFace = !context.scene.handles().faces().empty();
    const QString title =
        hasFace ? mapName(context.scene.handles(), std::size_t(index))
                : Menu::tr("Map %1").arg(document::mapTitle(document.fractal(), std::size_t(index)));
    menu.addSection(QString(title).replace(QLatin1String("&"), QLatin1String("&&")));
    document::Fractal switched = document.fractal();
    bool& enabled = document::system2(switched)->maps[std::size_t(index)].enabled;
    enabled = !enabled;
    add(menu, enabled ? Menu::tr("&Switch On") : Menu::tr("&Switch Off"),
        Menu::tr("Switches this map on or off"),
        [&document, switched,
         text = (enabled ? Menu::tr("Switch on map %1") : Menu::tr("Switch off map %1")).arg(number)] {
            document.edit(text, switched);
        });
    add(menu, withKey(Menu::tr("D&uplicate"), Qt::Key_Insert), Menu::tr("Adds a copy of this map"),
        [context, index] {
            context.scene.selection().setMaps(duplicateMaps(context.scene.document(), {index}));
        });
    add(menu, withKey(Menu::tr("&Delete"), Qt::Key_Delete), Menu::tr("Removes this map from the system"),
        attempt(context, [context, index]() -> std::optional<QString> {
            document::Document& file = context.scene.document();
            const QString locked = document::lockObstacle(file.fractal(), document::Rows{index});
            if (!locked.isEmpty()) return locked;
            context.scene.selection().setMaps(deleteMaps(file, {index}));
            return std::nullopt;
        }));
    const bool isLocked = document::isLocked(document.fractal(), std::size_t(index));
    add(menu, isLocked ? Menu::tr("Un&lock") : Menu::tr("&Lock"),
        isLocked ? Menu::tr("Lets this map be edited again") : Menu::tr("Locks this map against editing"),
        [&document, index, isLocked] {
            const ifs::MapId id = document::system2(document.fractal())->maps[std::size_t(index)].id;
            document::lockMaps(document, std::span(&id, 1), !isLocked);
        });
}

void addEdgeActions(QMenu& menu, const MenuContext& context, int edge, const QPoint& global) {
    menu.addSection(Menu::tr("Edge"));
    const QPointF position = context.view.viewport()->mapFromGlobal(global);
    add(menu, withKey(Menu::tr("&Insert a Vertex Here"), Qt::Key_Insert),
        Menu::tr("Inserts a vertex on this edge; double-clicking does the same"),
        [context, edge, position] { context.tools.cageTool().insertVertexAt(edge, position); });
}

void addPivotActions(QMenu& menu, const MenuContext& context, Kind kind) {
    menu.addSection(kind == Kind::Rotate  ? Menu::tr("Rotate: hold Shift for steps of 15°")
                    : kind == Kind::Scale ? Menu::tr("Scale: hold Shift for x or y only")
                                          : Menu::tr("Pivot"));
    add(menu, Menu::tr("Put the &Pivot in the Centre"),
        Menu::tr("Rotates and scales the cage about its centre"),
        [context] { context.scene.handles().setPivot(std::nullopt); })
        ->setEnabled(context.scene.handles().hasOwnPivot());
}

void addCageActions(QMenu& menu, const MenuContext& context) {
    document::Document& document = context.scene.document();
    menu.addSection(Menu::tr("Cage"));
    add(menu, Menu::tr("Fit &Minimal Canonical Simplex"),
        Menu::tr(
            "Fits the smallest isosceles right triangle with legs parallel to the axes around the picture"),
        attempt(context, [&document] { return fitMinimalCanonicalSimplex(document); }));
    add(menu, Menu::tr("&Define Triangle"),
        Menu::tr("Defines the triangle with three clicks; the picture stays"),
        [context] { context.tools.setTool(Toolbox::Tool::DefineTriangle); });
    const std::optional<ifs::ControlCage<2>>& cage = context.scene.handles().cage();
    const bool displaced = cage && cage->current != cage->rest;
    add(menu, Menu::tr("R&eset Cage"), Menu::tr("Returns every vertex to its position at rest"),
        attempt(context, [&document] { return resetCage(document); }))
        ->setEnabled(displaced);
    add(menu, Menu::tr("Make Re&gular"), Menu::tr("Moves the vertices to the nearest regular polygon"),
        attempt(context, [&document] { return makeCageRegular(document); }));
    const QString obstacle = bakeObstacle(document);
    add(menu, Menu::tr("&Bake"),
        obstacle.isEmpty()
            ? Menu::tr("Rewrites the maps so that they draw the picture as shown, with the cage at rest")
            : obstacle,
        attempt(context, [&document] { return bakeCage(document); }))
        ->setEnabled(obstacle.isEmpty());
}

void addToggle(QMenu& menu, const QString& text, const QString& tip, bool checked,
               std::function<void(bool)> set) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(checked);
    action->setStatusTip(tip);
    QObject::connect(action, &QAction::toggled, &menu, [set = std::move(set)](bool on) { set(on); });
}

void addCanvasActions(QMenu& menu, const MenuContext& context) {
    CanvasNavigation& navigation = context.navigation;
    CanvasOptions& options = context.options;
    menu.addSection(Menu::tr("View"));
    add(menu, Menu::tr("&Fit\tF"), Menu::tr("Shows the whole picture and its cage"),
        [&navigation] { navigation.fit(); });
    add(menu, Menu::tr("&100 %\t1"), Menu::tr("Shows one unit of the plane as one hundred pixels"),
        [&navigation] { navigation.resetZoom(); });
    addToggle(menu, Menu::tr("&Grid"), Menu::tr("Shows or hides the grid"), options.isGridVisible(),
              [&options](bool on) { options.setGridVisible(on); });
    addToggle(menu, Menu::tr("&Axes"), Menu::tr("Shows or hides the axes and their numbers"),
              options.areAxesVisible(), [&options](bool on) { options.setAxesVisible(on); });
    addToggle(menu, Menu::tr("&Y Axis Down"), Menu::tr("Points the y axis down, as in window coordinates"),
              navigation.yAxis() == attractor::YAxis::Down, [&navigation](bool on) {
                  navigation.setYAxis(on ? attractor::YAxis::Down : attractor::YAxis::Up);
              });
    if (navigation.rotation() != 0)
        add(menu, Menu::tr("&Reset Rotation"), Menu::tr("Returns the view to upright"),
            [&navigation] { navigation.resetRotation(); });
    addToggle(menu, Menu::tr("&Only the Picture\tH"), Menu::tr("Hides the cage, the grid and the axes"),
              !options.overlaysVisible(), [&options](bool on) { options.setOverlaysVisible(!on); });
    menu.addSeparator();
    add(menu, Menu::tr("&Copy Picture"), Menu::tr("Copies the picture as shown, without the cage"),
        context.copyPicture);
}

} // namespace

void popUpCanvasMenu(const MenuContext& context, const CanvasPart& part, const QPoint& global) {
    auto* menu = new QMenu(&context.view);
    menu->setAccessibleName(Menu::tr("Canvas"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (context.scene.handles().cage()) {
        if (part.map >= 0 && context.scene.handles().target() == HandleTarget::Maps)
            addMapActions(*menu, context, part.map);
        if (part.map < 0 && part.kind == Kind::Vertex) addVertexActions(*menu, context, part.index);
        if (part.kind == Kind::Edge) addEdgeActions(*menu, context, part.index, global);
        if (part.kind == Kind::Pivot || part.kind == Kind::Rotate || part.kind == Kind::Scale)
            addPivotActions(*menu, context, part.kind);
        if (part.kind != Kind::None) addCageActions(*menu, context);
    }
    if (part.kind == Kind::None) {
        addCanvasActions(*menu, context);
        if (context.scene.handles().cage()) addCageActions(*menu, context);
    }
    menu->popup(global);
}

} // namespace view
