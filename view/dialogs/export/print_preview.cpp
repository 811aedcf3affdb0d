// SPDX-License-Identifier: MIT
#include "dialogs/export/print_preview.h"

#include "document/text/text.h"
#include "widgets/text/tooltip_text.h"

#include <QFileInfo>
#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QToolBar>

#include <memory>

namespace view {

namespace {

// Empty for paper.
QString sentenceOn(const QPrinter& printer) {
    const QString path = printer.outputFileName();
    if (path.isEmpty()) return {};
    return printer.printerState() == QPrinter::Error || QFileInfo(path).size() == 0
               ? Text::tr("%1 could not be written. Print it to another folder.").arg(path)
               : Text::tr("Written to %1.").arg(path);
}

} // namespace

void showPrintPreview(const PrintedPages& pages, QWidget* parent,
                      const std::function<void(const QString&)>& said) {
    const auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setDocName(pages.name);
    if (pages.margin > 0)
        printer->setPageMargins({pages.margin, pages.margin, pages.margin, pages.margin},
                                QPageLayout::Millimeter);
    auto* preview = new QPrintPreviewDialog(printer.get(), parent);
    preview->setAttribute(Qt::WA_DeleteOnClose);
    preview->setWindowTitle(titleText(pages.title));
    // Print comes last in the bar of Qt, where a small screen has no room for it.
    if (auto* bar = preview->findChild<QToolBar*>(); bar && bar->actions().size() > 1)
        bar->insertAction(bar->actions().first(), bar->actions().last());
    QObject::connect(preview, &QPrintPreviewDialog::paintRequested, preview,
                     [paint = pages.paint, printer](QPrinter* device) {
                         QPainter painter(device);
                         if (!painter.isActive()) return; // file that cannot be written
                         const QSizeF size = device->pageRect(QPrinter::DevicePixel).size();
                         paint(painter, QRectF(QPointF(0, 0), size), [device] { device->newPage(); });
                     });
    QObject::connect(preview, &QDialog::accepted, preview, [printer, said] {
        if (const QString sentence = sentenceOn(*printer); !sentence.isEmpty()) said(sentence);
    });
    preview->open();
}

} // namespace view
