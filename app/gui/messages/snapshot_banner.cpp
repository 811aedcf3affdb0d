// SPDX-License-Identifier: MIT
#include "messages/snapshot_banner.h"

#include "panels/snapshots/snapshot_look.h"

#include <QLabel>
#include <QMainWindow>
#include <QPushButton>

SnapshotBanner::SnapshotBanner(QMainWindow* host, view::SnapshotLook* look, view::Snapshots* snapshots)
    : MessageBanner(host) {
    setObjectName(QStringLiteral("snapshot"));
    setAccessibleName(tr("Snapshot on the canvas"));
    const view::Snapshot shown = *look->shown();
    QLabel* title = createTitle();
    title->setText(
        title->fontMetrics().elidedText(tr("B: %1").arg(shown.name), Qt::ElideRight, widest() - 2 * margin));
    title->setToolTip(title->text());
    auto* back = new QPushButton(tr("Back to the Fractal"), this);
    back->setWhatsThis(tr("Shows the fractal again. Nothing has changed."));
    auto* restore = new QPushButton(tr("Restore"), this);
    restore->setWhatsThis(tr("Restores the fractal to this snapshot, as one step of the history."));
    for (QPushButton* button : {back, restore})
        button->setFocusPolicy(Qt::TabFocus); // other keys still go to the canvas
    lay(title, {}, restore, back);
    connect(back, &QPushButton::clicked, look, &view::SnapshotLook::end);
    connect(restore, &QPushButton::clicked, look, [look, snapshots, key = shown.key] {
        look->end(); // first, so that what follows stays
        snapshots->restore(key);
    });
    connect(look, &view::SnapshotLook::changed, this, [this](bool isOn) {
        if (!isOn) close();
    });
    appear(tr("The canvas shows “%1”.").arg(shown.name));
}

QPoint SnapshotBanner::topLeft() {
    const QRect canvas = canvasRect();
    return {canvas.left() + (canvas.width() - width()) / 2, canvas.top() + margin};
}
