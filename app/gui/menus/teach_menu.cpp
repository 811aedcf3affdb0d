// SPDX-License-Identifier: MIT
#include "menus/teach_menu.h"

#include "dialogs/export/handout_dialog.h"
#include "files/open_file.h"
#include "messages/written_banner.h"

#include <QFileInfo>

TeachMenu::TeachMenu(const MenuContext& context, const std::function<void(bool)>& present)
    : ActionMenu(context, tr("&Teach")) {
    m_presentation = addToggle(
        {"presentation", tr("P&resentation"), QKeySequence(tr("Shift+F11")),
         tr("Show only the canvas in full screen, for example on a projector; press Esc to return")},
        present);
}

void TeachMenu::addHandout(const OpenFile* file) {
    add({"print-handout",
         tr("Print &Handout…"),
         {},
         tr("Print entries for a class: pictures with cage, maps and formulas, or a blank worksheet")},
        [this, file] {
            auto* dialog = new view::HandoutDialog(context().document, context().window);
            if (!file->path().isEmpty()) dialog->setName(QFileInfo(file->path()).completeBaseName());
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            connect(dialog, &view::HandoutDialog::written, this, [this](const QString& path) {
                WrittenBanner::offerPrinted(context().window, *context().document, path);
            });
            dialog->open();
        });
}
