// SPDX-License-Identifier: MIT
#pragma once

#include <QRectF>
#include <QString>

#include <functional>

class QPainter;
class QWidget;

namespace view {

struct PrintedPages {
    QString title;     // title of the preview
    QString name;      // name of the document, which print dialogs suggest as the name of a file
    double margin = 0; // millimetres; 0: least margin of the printer
    std::function<void(QPainter& painter, const QRectF& page, const std::function<void()>& newPage)> paint;
};

// Shows a print preview of the pages, and prints them from there. Where paper is a file, `said` gets the
// sentence that names it, or that says that it could not be written.
void showPrintPreview(const PrintedPages& pages, QWidget* parent,
                      const std::function<void(const QString& sentence)>& said);

} // namespace view
