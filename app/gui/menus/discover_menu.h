// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"
#include "dialogs/variations/mutate_dialog.h"

#include <map>

namespace view {
class Construction;
}

// Sources of fractals, and combinations of two of them.
class DiscoverMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    // `showCollection` lets the user search the collection.
    DiscoverMenu(const MenuContext& context, const std::function<void()>& showCollection);

    void addRandom(); // adds a fractal chosen by the user among many
    void addCollage(QAction* panel);
    // No effect if the entry does not allow it.
    void showTransformation() { m_transformation->setChecked(true); }
    // Makes a transformation and a construction end each other, since both draw on the canvas of the plane.
    void alternateWith(view::Construction* construction);

private:
    void addTransformation();
    void openMutate();

    std::map<document::EntryId, view::MutateDialog::Descent> m_descents; // descents closed without a choice
    QAction* m_transformation = nullptr;
};
