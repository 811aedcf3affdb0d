// SPDX-License-Identifier: MIT
#include "messages/flame_banner.h"

#include "document/edits/entries_edits.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>

void FlameBanner::offer(QMainWindow* window, document::Document& document,
                        const QList<document::EntryId>& flames) {
    for (FlameBanner* old : window->findChildren<FlameBanner*>(Qt::FindDirectChildrenOnly))
        delete old;
    auto* banner = new FlameBanner(window, document, flames);
    banner->appear(banner->findChild<QCheckBox*>()->text());
}

FlameBanner::FlameBanner(QMainWindow* host, document::Document& document,
                         const QList<document::EntryId>& flames)
    : MessageBanner(host) {
    setObjectName(QStringLiteral("flame"));
    setAccessibleName(tr("Flames"));
    QLabel* title = createTitle();
    title->setText(tr("%n flames", nullptr, int(flames.size())));
    auto* text = new QLabel(tr("In flame files, y points down. The flames were flipped so that they look the "
                               "same here as in flame programs."),
                            this);
    text->setWordWrap(true);
    auto* written = new QCheckBox(tr("Keep &y As Written"), this);
    written->setWhatsThis(tr("Uses the numbers as they are in the file. The picture is then upside down."));
    auto* close = new QPushButton(tr("Close"), this);
    QBoxLayout* buttons = createButtons();
    buttons->addWidget(written);
    buttons->addStretch();
    buttons->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin - 2, margin, margin - 2);
    layout->addWidget(title);
    layout->addWidget(text);
    layout->addLayout(buttons);

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
