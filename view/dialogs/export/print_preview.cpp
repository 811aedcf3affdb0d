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

constexpr double paperMargin = 15; // millimetres, for printers and hole punches

void tell(const QPrinter& printer, const PrintSaid& said) {
    const QString path = printer.outputFileName();
    if (path.isEmpty()) return; // paper
    if (printer.printerState() == QPrinter::Error || QFileInfo(path).size() == 0)
        said(Text::tr("%1 could not be written. Print it to another folder.").arg(path), {});
    else
        said(Text::tr("Written to %1.").arg(path), path);
}

} // namespace

void showPrintPreview(const PrintedPages& pages, QWidget* parent, const PrintSaid& said) {
    const auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setDocName(pages.name);
    printer->setPageMargins({paperMargin, paperMargin, paperMargin, paperMargin}, QPageLayout::Millimeter);
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
    QObject::connect(preview, &QDialog::accepted, preview, [printer, said] { tell(*printer, said); });
    preview->open();
}

} // namespace view
