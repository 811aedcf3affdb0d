// SPDX-License-Identifier: MIT
#include "menus/discover_menu.h"

#include "bridges/construction.h"
#include "dialogs/variations/random_dialog.h"
#include "document/edits/cage/cage_edits.h"
#include "document/variations/variations.h"
#include "stage/stage.h"

DiscoverMenu::DiscoverMenu(const MenuContext& context, const std::function<void()>& showCollection)
    : ActionMenu(context, tr("D&iscover")) {
    add({"collection", tr("&Collection"), QKeySequence(tr("Ctrl+Shift+O")),
         tr("Search the fractals that come with the program, and your favourites")},
        showCollection);
    add({"add-random-fractal", tr("Add Ra&ndom Fractal…"), QKeySequence(tr("Ctrl+Shift+M")),
         tr("Choose from a sheet of random fractals and add one to the file")},
        [this] { addRandom(); });
    QAction* mutate = add({"mutate", tr("&Variations…"), QKeySequence(tr("Ctrl+M")),
                           tr("Breed variations of this fractal, or cross it with another one")},
                          [this] { openMutate(); });
    disableWhen(mutate, &document::variationObstacle);
    addTransformation();
}

void DiscoverMenu::addCollage(QAction* panel) {
    insertAction(m_transformation, panel);
}

void DiscoverMenu::openMutate() {
    view::MutateDialog::Descent& left = m_descents[context().document->currentId()];
    auto* dialog = new view::MutateDialog(context().document, context().window, left);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    left = {};
    QObject::connect(dialog, &QDialog::rejected, dialog, [&left, dialog] {
        if (dialog->descent().line.size() > 1) left = dialog->descent();
    });
    dialog->open();
}

void DiscoverMenu::addRandom() {
    auto* dialog = new view::RandomDialog(context().document, context().window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void DiscoverMenu::addTransformation() {
    view::TransformationView* transformation = context().stage->transformation();
    m_transformation = addToggle(
        {"fractal-transformation", tr("Fractal &Transformation"), QKeySequence(tr("Ctrl+Shift+T")),
         tr("Show another entry beside this one, and colour this one by a picture placed on the other")},
        [transformation](bool on) { transformation->setTransformationShown(on); });
    disableWhen(m_transformation, &document::planeObstacle);
    connect(transformation, &view::TransformationView::message, context().messages, &WindowMessages::say);
}

void DiscoverMenu::alternateWith(view::Construction* construction) {
    using view::Construction;
    connect(construction, &Construction::starting, m_transformation, [this] {
        if (!m_transformation->isChecked()) return;
        m_transformation->setChecked(false);
        context().messages->say(
            tr("The fractal transformation was hidden to show how the attractor is built."));
    });
    connect(m_transformation, &QAction::toggled, construction, [construction](bool on) {
        if (on) construction->setMode(Construction::Mode::Density);
    });
}
