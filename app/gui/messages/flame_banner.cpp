// SPDX-License-Identifier: MIT
#include "messages/flame_banner.h"

#include "document/edits/entries_edits.h"

#include <QCheckBox>
#include <QMainWindow>
#include <QPushButton>

void FlameBanner::offer(QMainWindow* window, document::Document& document,
                        const QList<document::EntryId>& flames) {
    closeOthers<FlameBanner>(window);
    auto* banner = new FlameBanner(window, document, flames);
    banner->appear(banner->findChild<QCheckBox*>()->text());
}

FlameBanner::FlameBanner(QMainWindow* host, document::Document& document,
                         const QList<document::EntryId>& flames)
    : MessageBanner(host) {
    setObjectName(QStringLiteral("flame"));
    setAccessibleName(tr("Flames"));
    auto* written = new QCheckBox(tr("Keep &y As Written"), this);
    written->setWhatsThis(tr("Uses the numbers as they are in the file. The picture is then upside down."));
    auto* close = new QPushButton(tr("Close"), this);
    lay(createTitle(tr("%n flames", nullptr, int(flames.size()))),
        tr("In flame files, y points down. The flames were flipped so that they look the same here as in "
           "flame programs."),
        written, close);

    connect(close, &QPushButton::clicked, this, &QWidget::close);
    connect(written, &QCheckBox::toggled, this, [this, &document, flames](bool asWritten) {
        m_isTurning = true;
        document.editFile(asWritten ? tr("Keep y as written") : tr("Flip the flames"),
                          document::turnedOver(document.file(), flames), document.currentId());
        m_isTurning = false;
    });
    connect(&document, &document::Document::changed, this, [this](const document::Change& change) {
        if (!m_isTurning && change.parts != document::Change::Parts(document::Change::Current)) this->close();
    });
}
