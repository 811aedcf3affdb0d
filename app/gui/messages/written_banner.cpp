// SPDX-License-Identifier: MIT
#include "messages/written_banner.h"

#include "desktop/show_in_folder.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>

void WrittenBanner::offer(QMainWindow* window, const document::Document& document, const QString& path,
                          const QString& title, const QString& sentence) {
    closeOthers<WrittenBanner>(window);
    new WrittenBanner(window, document, path, title, sentence);
}

WrittenBanner::WrittenBanner(QMainWindow* host, const document::Document& document, const QString& path,
                             const QString& title, const QString& sentence)
    : MessageBanner(host) {
    setObjectName(QStringLiteral("written"));
    setAccessibleName(title);
    auto* folder = new QPushButton(tr("Show in Folder"), this);
    folder->setObjectName(QStringLiteral("show-in-folder"));
    folder->setWhatsThis(tr("Shows the folder of the written file in the file manager."));
    auto* closeNow = new QPushButton(tr("Close"), this);
    const QString name = QFileInfo(path).fileName();
    // Elided, because a name is a single word, which is never broken.
    const QString shown = fontMetrics().elidedText(name, Qt::ElideMiddle, widest() - 3 * margin);
    lay(createTitle(title), sentence.arg(shown), folder, closeNow);
    connect(folder, &QPushButton::clicked, this, [path] { view::showInFolder(path); });
    connect(closeNow, &QPushButton::clicked, this, &QWidget::close);
    connect(&document, &document::Document::changed, this, [this](const document::Change& change) {
        if (change.parts != document::Change::Parts(document::Change::Current)) this->close();
    });
    appear(sentence.arg(name));
}

void WrittenBanner::offerPrinted(QMainWindow* window, const document::Document& document,
                                 const QString& path) {
    if (!path.isEmpty()) offer(window, document, path, tr("Printed to a file"), tr("%1 was written."));
}
