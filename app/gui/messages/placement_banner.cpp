// SPDX-License-Identifier: MIT
#include "messages/placement_banner.h"

#include "document/edits/cage/placements.h"
#include "messages/window_messages.h"

#include <QMainWindow>
#include <QPushButton>

bool PlacementBanner::offer(QMainWindow* window, document::Document& document, WindowMessages& messages) {
    const QStringList names = document::placedEntries(document.file());
    if (names.isEmpty()) return false;
    closeOthers<PlacementBanner>(window);
    new PlacementBanner(window, document, messages, names);
    return true;
}

PlacementBanner::PlacementBanner(QMainWindow* host, document::Document& document, WindowMessages& messages,
                                 const QStringList& names)
    : MessageBanner(host) {
    setObjectName(QStringLiteral("placement"));
    setAccessibleName(tr("Saved with dragged corners"));
    const QString text =
        names.size() == 1
            ? tr("Other programs will show “%1” without your dragged corners, which are saved as comments. "
                 "Bake puts them into the numbers that every program reads.")
                  .arg(names.first())
            : tr("Other programs will show %n entries without your dragged corners, which are saved as "
                 "comments. Bake puts them into the numbers that every program reads.",
                 nullptr, int(names.size()));
    auto* bakeNow = new QPushButton(tr("&Bake"), this);
    bakeNow->setWhatsThis(tr("Writes the placements into the code, as one step of the history."));
    // Disabled if entries would be left: the picture of a bent or flat cage has no code.
    bakeNow->setEnabled(document::withPlacementsBaked(document.file()).left.size() < names.size());
    if (!bakeNow->isEnabled())
        bakeNow->setToolTip(
            tr("This cage cannot be baked: it bends or flattens the picture, or keys move it."));
    auto* closeNow = new QPushButton(tr("Close"), this);
    lay(createTitle(accessibleName()), text, bakeNow, closeNow);
    connect(closeNow, &QPushButton::clicked, this, &QWidget::close);
    connect(bakeNow, &QPushButton::clicked, this, [this, &document, &messages] { bake(document, messages); });
    connect(&document, &document::Document::changed, this, [this](const document::Change& change) {
        if (change.parts & document::Change::File) this->close();
    });
    appear(text);
}

void PlacementBanner::bake(document::Document& document, WindowMessages& messages) {
    document::BakedFile baked = document::withPlacementsBaked(document.file());
    document.editFile(tr("Bake the placements into the code"), std::move(baked.file), document.currentId());
    if (!baked.left.isEmpty())
        messages.say(tr("Not baked, because no code has this picture or keys move it: %1.")
                         .arg(baked.left.join(QStringLiteral(", "))));
    close();
}
