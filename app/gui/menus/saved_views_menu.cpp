// SPDX-License-Identifier: MIT
#include "menus/saved_views_menu.h"

#include "bars/zoom_box.h"
#include "dialogs/saved_views_dialog.h"
#include "document/edits/cage/cage_edits.h"
#include "stage/stage.h"
#include "widgets/menus/menu_placeholder.h"
#include "widgets/text/tooltip_text.h"

#include <utility>

SavedViewsMenu::SavedViewsMenu(const MenuContext& context) : ActionMenu(context, tr("Saved &Views")) {
    QAction* save = add(
        {"save-view", tr("&Save View…"), {}, tr("Keep what the canvas shows under a name, with the fractal")},
        [this] { this->save(); });
    QAction* edit =
        add({"edit-views", tr("&Edit Views…"), {}, tr("Go to saved views, rename or delete them")},
            [this] { openDialog(); });
    disableWhen(save, &document::cageObstacle);
    disableWhen(edit, &document::cageObstacle);
    addSeparator();
    m_end = view::addPlaceholder(*this, tr("No saved views"));
    m_end->setWhatsThis(tr("Views that you save are listed here."));
    connect(context.document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        if (change.parts & (Change::System | Change::Name | Change::Current | Change::File)) refresh();
    });
    refresh();
}

void SavedViewsMenu::serve(view::ZoomBox* zoom) {
    m_zoom = zoom;
    connect(zoom, &view::ZoomBox::viewChosen, this, [this](const QString& name) { goTo(name); });
    m_views.clear();
    refresh();
}

void SavedViewsMenu::refresh() {
    std::vector<document::SavedView> views = document::savedViews(context().document->fractal());
    if (views == m_views && !m_actions.isEmpty() == !views.empty()) return;
    m_views = std::move(views);
    for (QAction* action : std::exchange(m_actions, {}))
        delete action;
    QStringList names;
    for (const document::SavedView& view : m_views) {
        names << view.name;
        auto* action = new QAction(QString(view.name).replace(u'&', QLatin1String("&&")), this);
        action->setStatusTip(tr("Show this part of the fractal again"));
        action->setToolTip(view::tooltipText(view.name));
        action->setWhatsThis(action->statusTip() + u'.');
        connect(action, &QAction::triggered, this, [this, name = view.name] { goTo(name); });
        insertAction(m_end, action);
        m_actions << action;
    }
    m_end->setVisible(m_views.empty());
    if (m_zoom) m_zoom->setViews(names);
}

void SavedViewsMenu::goTo(const QString& name) {
    if (const auto view = document::savedView(context().document->fractal(), name))
        context().stage->lookAt(view->camera);
}

void SavedViewsMenu::save() {
    const document::SavedView::Camera camera = context().stage->camera(); // camera before the question
    auto* dialog = new view::SaveViewDialog(context().document->fractal(), context().window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, camera, entry = context().document->currentId()] {
                document::Document& document = *context().document;
                if (document.currentId() != entry) return;
                const document::SavedView view{dialog->name(), camera};
                const document::Fractal& before = document.entryFractal();
                document.editEntry((document::savedView(before, view.name) ? tr("Replace the view “%1”")
                                                                           : tr("Save the view “%1”"))
                                       .arg(view.name),
                                   document::withSavedView(before, view));
            });
    dialog->open();
}

void SavedViewsMenu::openDialog() {
    auto* dialog =
        new view::SavedViewsDialog(context().document,
                                   {[stage = context().stage] { return stage->camera(); },
                                    [stage = context().stage](const auto& camera) { stage->lookAt(camera); }},
                                   context().window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}
