// SPDX-License-Identifier: MIT
#include "menus/cage_menu.h"

#include "dialogs/aifs_dialog.h"
#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "stage/stage.h"

#include <QActionGroup>

CageMenu::CageMenu(const MenuContext& context) : ActionMenu(context, tr("&Cage")) {
    addTools();
    addSeparator();
    addOperations();
    addMore();
}

void CageMenu::addTools() {
    const std::pair<Tool, ActionSpec> specs[] = {
        {Tool::Cage,
         {"cage", tr("&Drag the Cage"), QKeySequence(tr("C")), tr("Drag the corners of the cage")}},
        {Tool::Maps,
         {"maps", tr("Drag t&he Maps"), QKeySequence(tr("M")),
          tr("Show each map as its image of the cage, and drag it by its corners")}},
        {Tool::Branch,
         {"branch", tr("Drag a Bra&nch"), QKeySequence(tr("B")),
          tr("Click a point of the attractor and drag the branch that contains it")}},
        {Tool::DefineTriangle,
         {"define", tr("De&fine Triangle"), QKeySequence(tr("D")),
          tr("Define the control triangle with three clicks, or in space the tetrahedron with four")}},
    };
    auto* group = new QActionGroup(this);
    QList<QAction*> tools;
    for (const auto& [tool, spec] : specs)
        tools << addTool(group, tool, spec);
    const auto nameDefinition = [define = tools.last(), stage = context().stage] {
        define->setText(stage->showsSpace() ? tr("De&fine Tetrahedron") : tr("De&fine Triangle"));
    };
    connect(context().stage, &Stage::switched, tools.last(), nameDefinition);
    nameDefinition();
    addToolBarGroup({{tools[0], tr("Cage")}, {tools[1], tr("Maps")}, {tools[2], tr("Branch")}});
}

QAction* CageMenu::addTool(QActionGroup* group, Tool tool, const ActionSpec& spec) {
    view::CanvasView* canvas = context().canvas;
    QAction* action = add(spec, [canvas, tool] { canvas->setTool(tool); });
    action->setCheckable(true);
    action->setChecked(canvas->tool() == tool);
    group->addAction(action);
    connect(canvas, &view::CanvasView::toolChanged, action,
            [action, tool](Tool now) { action->setChecked(now == tool); });
    if (tool != Tool::Cage) disableWhen(action, &document::cageObstacle);
    return action;
}

void CageMenu::addOperations() {
    QAction* reset = addOperation(
        *this, &document::resetCage,
        {"reset", tr("&Reset"), {}, tr("Return the cage to rest: the picture shows the code as it is")});
    QAction* bake = addOperation(
        *this, &document::bakeCage,
        {"bake", tr("&Bake"), QKeySequence(tr("Ctrl+B")),
         tr("Write the placement into the code: the picture stays, and the coefficients change")});
    disableWhen(reset, &document::resetObstacle);
    disableWhen(bake, &document::bakeObstacle);
}

void CageMenu::addMore() {
    auto* menu = new ActionMenu(context(), tr("M&ore"));
    addMenu(menu);
    QAction* fitSimplex = addOperation(*menu, &document::fitMinimalCanonicalSimplex,
                                       {"fit-simplex",
                                        tr("Fit &Minimal Canonical Simplex"),
                                        {},
                                        tr("Fit the smallest isosceles right triangle with legs parallel to "
                                           "the axes around the attractor")});
    QAction* regular = addOperation(
        *menu, &document::makeCageRegular,
        {"make-regular", tr("Make Re&gular"), {}, tr("Move the vertices to the nearest regular polygon")});
    QAction* unbake = addOperation(*menu, &document::unbakeCage,
                                   {"unbake",
                                    tr("&Unbake"),
                                    {},
                                    tr("Extract the placement from the code: the picture stays, and the code "
                                       "is rewritten for the triangle (0, 0), (1, 0), (0, 1)")});
    QAction* invariantForm =
        menu->add({"affine-invariant-form",
                   tr("Affine &Invariant Form…"),
                   {},
                   tr("Show every map as a matrix over the control triangle, with rows that sum to 1")},
                  [this] { showInvariantForm(); });
    disableWhen(unbake, &document::unbakeObstacle);
    disableWhen(fitSimplex, &document::cageObstacle);
    for (QAction* action : {regular, invariantForm})
        disableWhen(action, &document::planeObstacle);
    menu->addSeparator();
    addModes(*menu);
}

QAction* CageMenu::addOperation(ActionMenu& menu, Operation operation, const ActionSpec& spec) {
    return menu.add(spec, [this, operation] {
        if (const auto sentence = operation(*context().document)) context().messages->say(*sentence);
    });
}

void CageMenu::addModes(ActionMenu& menu) {
    document::Document* document = context().document;
    auto* group = new QActionGroup(this);
    const std::pair<document::CageMode, ActionSpec> modes[] = {
        {document::CageMode::Place,
         {"place", tr("&Place"), {}, tr("Moving the cage moves the picture; the code does not change")}},
        {document::CageMode::Rewrite,
         {"rewrite", tr("Re&write"), {}, tr("Moving the cage rewrites the code")}},
    };
    for (const auto& [mode, spec] : modes) {
        QAction* action = menu.add(spec, [document, mode = mode] { document->setCageMode(mode); });
        action->setCheckable(true);
        action->setChecked(document->cageMode() == mode);
        group->addAction(action);
        connect(document, &document::Document::cageModeChanged, action,
                [action, mode = mode](document::CageMode now) { action->setChecked(now == mode); });
    }
}

void CageMenu::showInvariantForm() {
    auto* dialog = new view::AifsDialog(context().document->fractal(), context().window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}
