// SPDX-License-Identifier: MIT
#include "welcome.h"

#include "canvas/canvas_view.h"
#include "files/recent_files.h"
#include "main_window.h"
#include "widgets/icon.h"
#include "widgets/text/tooltip_text.h"

#include <QAction>
#include <QCommandLinkButton>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>

namespace {

constexpr qsizetype maxFiles = 4;

QString folderOf(const QString& path) {
    QString folder = QFileInfo(path).absolutePath();
    if (const QString home = QDir::homePath(); folder == home || folder.startsWith(home + u'/'))
        folder.replace(0, home.size(), u'~');
    return QDir::toNativeSeparators(folder);
}

} // namespace

void Welcome::offer(MainWindow* window) {
    auto* banner = new Welcome(window);
    banner->appear(recent_files::list().isEmpty() ? tr("A file or the collection.")
                                                  : tr("Recent files and the collection."));
}

Welcome::Welcome(MainWindow* host) : MessageBanner(host) {
    setObjectName(QStringLiteral("welcome"));
    setAccessibleName(tr("Welcome"));
    QLabel* title = createTitle();
    title->setText(recent_files::list().isEmpty() ? tr("Start with") : tr("Continue with"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin - 2, margin, margin - 2);
    layout->setSpacing(0);
    layout->addWidget(title);
    layout->addSpacing(4);
    constexpr int besideText = 2 * margin + 48;
    for (const QString& path : recent_files::list().mid(0, maxFiles)) {
        const QString folder =
            fontMetrics().elidedText(folderOf(path), Qt::ElideMiddle, widest() - besideText);
        auto* file = new QCommandLinkButton(QFileInfo(path).fileName().replace(u'&', QStringLiteral("&&")),
                                            folder, this);
        file->setIcon(view::icon(QStringLiteral("open")));
        file->setToolTip(view::tooltipText(QDir::toNativeSeparators(path)));
        file->setAccessibleDescription(QDir::toNativeSeparators(path)); // in place of the tool tip
        connect(file, &QPushButton::clicked, host, [host, path] { host->openRecent(path); });
        layout->addWidget(file);
    }
    auto* close = new QPushButton(tr("Close"), this);
    auto* collection = new QPushButton(tr("Co&llection"), this);
    collection->setObjectName(QStringLiteral("collection"));
    auto* open = new QPushButton(tr("&Open…"), this);
    QBoxLayout* buttons = createButtons();
    buttons->setSpacing(margin / 2);
    buttons->addWidget(close);
    buttons->addStretch();
    buttons->addWidget(collection);
    buttons->addWidget(open);
    layout->addSpacing(8);
    layout->addLayout(buttons);

    connect(close, &QPushButton::clicked, this, &QWidget::close);
    connect(open, &QPushButton::clicked, host, &MainWindow::chooseAndOpen);
    connect(collection, &QPushButton::clicked, this, [this, host] {
        host->showCollection();
        this->close();
    });
    connect(&host->document(), &document::Document::changed, this, &QWidget::close);
    for (const QAction* action : host->findChildren<QAction*>())
        connect(action, &QAction::triggered, this, &QWidget::close);
    for (const QTabBar* panels : host->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        connect(panels, &QTabBar::tabBarClicked, this, &QWidget::close);
    if (auto* canvas = host->findChild<view::CanvasView*>()) {
        connect(canvas, &view::CanvasView::toolChanged, this, &QWidget::close);
        follow(canvas->viewport());
    }
}

bool Welcome::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) close();
    return MessageBanner::eventFilter(watched, event);
}
