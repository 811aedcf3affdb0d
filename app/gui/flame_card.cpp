// SPDX-License-Identifier: MIT
#include "flame_card.h"

#include "main_window.h"
#include "panels/entries_edits.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

void FlameCard::offer(MainWindow* window, const QList<document::EntryId>& flames) {
    for (FlameCard* old : window->findChildren<FlameCard*>(Qt::FindDirectChildrenOnly))
        delete old;
    auto* card = new FlameCard(window, flames);
    card->appear(card->findChild<QCheckBox*>()->text());
}

FlameCard::FlameCard(MainWindow* host, const QList<document::EntryId>& flames) : Card(host) {
    setObjectName(QStringLiteral("flame"));
    setAccessibleName(tr("Flames"));
    QLabel* title = createTitle();
    title->setText(tr("%n flames", nullptr, int(flames.size())));
    auto* text =
        new QLabel(tr("In flames y grows downwards. They were turned over, so that they look here as "
                      "they do in flame programs."),
                   this);
    text->setWordWrap(true);
    auto* written = new QCheckBox(tr("Leave &y as it is written"), this);
    written->setWhatsThis(tr("Takes the numbers of the flames as they are in the text. The picture is then "
                             "upside down."));
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

    document::Document* document = &host->document();
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    connect(written, &QCheckBox::toggled, this, [this, document, flames](bool asWritten) {
        m_isTurning = true;
        document->editFile(asWritten ? tr("Leave y as it is written") : tr("Turn the flames over"),
                           view::turnedOver(document->file(), flames), document->currentId());
        m_isTurning = false;
    });
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        if (!m_isTurning && change.parts != document::Change::Parts(document::Change::Current)) this->close();
    });
}
