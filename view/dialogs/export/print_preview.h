// SPDX-License-Identifier: MIT
#pragma once

#include <QRectF>
#include <QString>

#include <functional>

class QPainter;
class QWidget;

namespace view {

struct PrintedPages {
    QString title;     // of the preview
    QString name;      // of the document; print dialogs take it for that of the file that they write
    double margin = 0; // in millimetres; 0: what the printer needs
    std::function<void(QPainter& painter, const QRectF& page, const std::function<void()>& newPage)> paint;
};

// Shows a print preview of the pages, and prints them from there. Where paper is a file, `said` gets the
// sentence that names it, or that says that it could not be written.
void showPrintPreview(const PrintedPages& pages, QWidget* parent,
                      const std::function<void(const QString& sentence)>& said);

} // namespace view
