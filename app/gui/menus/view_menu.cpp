// SPDX-License-Identifier: MIT
#include "menus/view_menu.h"

#include "bridges/construction.h"
#include "canvas/marks/map_numbers.h"
#include "desktop/settings.h"
#include "dialogs/go_to_dialog.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "document/text/stereo_modes.h"
#include "document/text/text.h"
#include "menus/saved_views_menu.h"
#include "stage/stage.h"
#include "widgets/icon.h"

namespace {

constexpr double zoomStep = 1.25;
constexpr double rotationStep = 15; // degrees

} // namespace

ViewMenu::ViewMenu(const MenuContext& context) : ActionMenu(context, tr("&View")) {
    addZoom();
    addSeparator();
    addOverlays();
    addCompare();
    addSeparator();
    m_panels = addMenu(tr("&Panels"));
    m_fullScreen =
        addToggle({"full-screen", tr("F&ull Screen"), QKeySequence(tr("F11")), tr("Fill the whole screen")},
                  [window = context.window](bool on) {
                      window->setWindowState(window->windowState().setFlag(Qt::WindowFullScreen, on));
                  });
}

void ViewMenu::addZoom() {
    Stage* stage = context().stage;
    QAction* fit = add({"fit", tr("&Fit"), QKeySequence(tr("F")), tr("Show the whole fractal")},
                       [stage] { stage->fit(); });
    auto* menu = new ActionMenu(context(), tr("&Navigate"));
    addMenu(menu);
    menu->add({"zoom-in", tr("Zoom &In"), QKeySequence::ZoomIn, tr("Zoom in")},
              [stage] { stage->zoomBy(zoomStep); });
    menu->add({"zoom-out", tr("Zoom &Out"), QKeySequence::ZoomOut, tr("Zoom out")},
              [stage] { stage->zoomBy(1 / zoomStep); });
    menu->add({"zoom-reset", tr("&100 %"), QKeySequence(tr("1")), tr("Show one unit as one hundred pixels")},
              [stage] { stage->resetZoom(); });
    QAction* goTo = menu->add({"go-to", tr("&Go To…"), QKeySequence(tr("Ctrl+G")),
                               tr("Show a centre and height, the point of an address, or a fixed point")},
                              [this] { openGoTo(); });
    disableWhen(goTo, &document::planeObstacle);
    menu->addSeparator();
    addRotation(*menu);
    addCamera(*menu);
    m_savedViews = new SavedViewsMenu(context());
    addMenu(m_savedViews);
    addToolBarGroup({{fit, tr("Fit")}});
}

void ViewMenu::openGoTo() {
    view::CanvasView* canvas = context().canvas;
    auto* dialog = new view::GoToDialog(context().document->sharedFractal(),
                                        attractor::viewOf(canvas->camera()), context().window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, canvas, [canvas, dialog, stage = context().stage] {
        if (const auto view = dialog->view()) stage->lookAt(*view);
    });
    dialog->open();
}

void ViewMenu::addRotation(ActionMenu& menu) {
    view::CanvasNavigation& navigation = context().canvas->navigation();
    QAction* left = menu.add({"rotate-view-left", tr("Rotate View &Left"), QKeySequence(tr("Ctrl+[")),
                              tr("Rotate the view counter-clockwise by 15°")},
                             [&navigation] { navigation.rotateBy(rotationStep); });
    QAction* right = menu.add({"rotate-view-right", tr("Rotate View &Right"), QKeySequence(tr("Ctrl+]")),
                               tr("Rotate the view clockwise by 15°")},
                              [&navigation] { navigation.rotateBy(-rotationStep); });
    QAction* reset = menu.add({"reset-rotation", tr("Re&set Rotation"), {}, tr("Return the view to upright")},
                              [&navigation] { navigation.resetRotation(); });
    for (QAction* ofThePlane : {left, right, reset})
        disableWhen(ofThePlane, &document::planeObstacle);
}

void ViewMenu::addCamera(ActionMenu& navigation) {
    auto* menu = new ActionMenu(context(), tr("Ca&mera"));
    navigation.addMenu(menu);
    view::SpaceNavigation& space = context().stage->space()->navigation();
    const struct {
        const char* id;
        QString text;
        QString tip;
        attractor::Direction direction;
    } views[] = {
        {"look-from-front", tr("&Front"), tr("Look from the front (1 on the keypad)"),
         view::directions::front},
        {"look-from-back", tr("&Back"), tr("Look from behind (Ctrl+1 on the keypad)"),
         view::directions::back},
        {"look-from-right", tr("&Right"), tr("Look from the right (3 on the keypad)"),
         view::directions::right},
        {"look-from-left", tr("&Left"), tr("Look from the left (Ctrl+3 on the keypad)"),
         view::directions::left},
        {"look-from-top", tr("&Top"), tr("Look down (7 on the keypad)"), view::directions::top},
        {"look-from-bottom", tr("B&ottom"), tr("Look up (Ctrl+7 on the keypad)"), view::directions::bottom},
        {"look-from-isometric", tr("&Isometric"), tr("Look from a corner (Home)"),
         view::directions::isometric},
    };
    for (const auto& view : views)
        disableWhen(menu->add({view.id, view.text, {}, view.tip},
                              [&space, to = view.direction] { space.lookFrom(to); }),
                    &document::spaceObstacle);
    menu->addSeparator();
    addPerspective(*menu);
    view::FourViews* solid = context().stage->views();
    QAction* four =
        menu->addToggle({"four-views",
                         tr("Four &Views"),
                         {},
                         tr("Show the solid from the top, the front and the right, and in perspective"),
                         "space/fourViews",
                         false},
                        [solid](bool on) { solid->showFour(on); });
    disableWhen(four, &document::spaceObstacle);
    QAction* zUp = menu->addToggle(
        {"z-up",
         tr("&Z Up"),
         {},
         tr("Point the z axis up, as in CAD programs; the fractal stays as it is"),
         "space/zUp",
         false},
        [solid](bool on) { solid->setUpAxis(on ? attractor::UpAxis::Z : attractor::UpAxis::Y); });
    disableWhen(zUp, &document::spaceObstacle);
    addStereo(*menu);
}

// Checked while the view is in perspective. What is stored is the choice, whatever views along an axis and
// Four Views show for a while.
void ViewMenu::addPerspective(ActionMenu& menu) {
    const QString setting = QStringLiteral("space/perspective");
    view::SpaceNavigation& space = context().stage->space()->navigation();
    QAction* perspective = menu.addToggle(
        {"perspective", tr("&Perspective"), {}, tr("Make distant parts look smaller (5 on the keypad)")},
        [&space, setting](bool on) {
            space.setPerspective(on);
            view::store(setting, space.isPerspectiveChosen());
        });
    connect(&space, &view::SpaceNavigation::perspectiveChanged, perspective, &QAction::setChecked);
    perspective->setChecked(view::stored(setting, false).toBool());
    disableWhen(perspective, &document::spaceObstacle);
}

// Adds the kinds of stereo, of which one or none is on.
void ViewMenu::addStereo(ActionMenu& menu) {
    view::FourViews* views = context().stage->views();
    menu.addSeparator();
    QList<QAction*> modes;
    for (const document::StereoMode& mode : document::stereoModes()) {
        if (mode.command == nullptr) continue;
        QAction* action = menu.addToggle({mode.command, Text::tr(mode.item), {}, Text::tr(mode.tip)},
                                         [views, stereo = mode.value](bool on) {
                                             if (on || views->stereo() == stereo)
                                                 views->setStereo(on ? stereo : attractor::Stereo::None);
                                         });
        disableWhen(action, &document::spaceObstacle);
        modes << action;
    }
    for (const QAction* action : modes)
        connect(action, &QAction::toggled, &menu, [action, modes](bool on) {
            for (QAction* other : modes)
                if (on && other != action) other->setChecked(false);
        });
}

void ViewMenu::addOverlays() {
    auto* menu = new ActionMenu(context(), tr("&Canvas"));
    addMenu(menu);
    view::CanvasView* canvas = context().canvas;
    QAction* grid = menu->addToggle(
        {"grid", tr("&Grid"), QKeySequence(tr("G")), tr("Show the grid"), "canvas/grid", true},
        [canvas](bool on) { canvas->options().setGridVisible(on); });
    connect(&canvas->options(), &view::CanvasOptions::gridVisibleChanged, grid, &QAction::setChecked);
    QAction* axes = menu->addToggle(
        {"axes", tr("&Axes"), QKeySequence(tr("A")), tr("Show the axes"), "canvas/axes", true},
        [canvas](bool on) { canvas->options().setAxesVisible(on); });
    connect(&canvas->options(), &view::CanvasOptions::axesVisibleChanged, axes, &QAction::setChecked);
    QAction* downwards =
        menu->addToggle({"y-axis", tr("&Y Axis Down"), QKeySequence(tr("Y")),
                         tr("Point the y axis down, as in window coordinates")},
                        [canvas](bool on) {
                            canvas->navigation().setYAxis(on ? attractor::YAxis::Down : attractor::YAxis::Up);
                        });
    connect(&canvas->navigation(), &view::CanvasNavigation::cameraChanged, downwards, [canvas, downwards] {
        // Saved views change it.
        downwards->setChecked(canvas->navigation().yAxis() == attractor::YAxis::Down);
    });
    auto* marks = new view::MapNumbers; // owned by the scene
    canvas->scene()->addItem(marks);
    connect(&canvas->options(), &view::CanvasOptions::mapNumbersVisibleChanged, canvas,
            [marks](bool on) { marks->setVisible(on); });
    m_numbers =
        menu->addToggle({"numbers-of-maps", tr("&Numbers of Maps"), QKeySequence(tr("N")),
                         tr("Show the number and the fixed point of each map"), "canvas/numbers", false},
                        [canvas](bool on) { canvas->options().setMapNumbersVisible(on); });
    connect(&canvas->options(), &view::CanvasOptions::mapNumbersVisibleChanged, m_numbers,
            &QAction::setChecked);
    for (QAction* ofThePlane : {grid, axes, downwards, m_numbers})
        disableWhen(ofThePlane, &document::planeObstacle);
    QAction* hide = menu->addToggle({"hide", tr("Only the Pi&cture"), QKeySequence(tr("H")),
                                     tr("Hide everything on the canvas except the picture")},
                                    [canvas](bool on) { canvas->options().setOverlaysVisible(!on); });
    connect(&canvas->options(), &view::CanvasOptions::overlaysVisibleChanged, hide,
            [hide](bool on) { hide->setChecked(!on); });
    addSnapping(*menu);
}

void ViewMenu::addSnapping(ActionMenu& canvas) {
    auto* menu = new ActionMenu(context(), tr("&Snap To"));
    menu->setIcon(view::icon(QStringLiteral("snap")));
    canvas.addMenu(menu);
    const std::tuple<view::SnapTo, const char*, QString, const char*> targets[] = {
        {view::SnapTo::Grid, "snap-to-grid", tr("&Grid"), "canvas/snap/grid"},
        {view::SnapTo::Vertices, "snap-to-vertices", tr("&Vertices"), "canvas/snap/vertices"},
        {view::SnapTo::Axes, "snap-to-axes", tr("&Axes"), "canvas/snap/axes"},
    };
    for (const auto& [target, id, text, setting] : targets)
        menu->addToggle({id, text, {}, tr("Make dragged vertices snap to this"), setting},
                        [canvas = context().canvas, target = target](bool on) {
                            canvas->options().setSnapping(canvas->options().snapping().setFlag(target, on));
                        });
}

void ViewMenu::addCompare() {
    Stage* stage = context().stage;
    const view::ComparePane* pane = stage->compare();
    QAction* compare = addToggle({"side-by-side", tr("Side &by Side"), QKeySequence(tr("Ctrl+Shift+B")),
                                  tr("Show another entry beside this one, to compare and edit both")},
                                 [stage](bool on) { stage->setCompared(on); });
    connect(pane, &view::ComparePane::closeRequested, compare, [compare] { compare->setChecked(false); });
    connect(pane, &view::ComparePane::message, context().messages, &WindowMessages::say);
}
