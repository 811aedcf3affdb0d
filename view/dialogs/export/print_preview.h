// SPDX-License-Identifier: MIT
#pragma once

#include <QRectF>
#include <QString>

#include <functional>

class QPainter;
class QWidget;

namespace view {

struct PrintedPages {
    QString title; // title of the preview
    QString name;  // name of the document, which print dialogs suggest as the name of a file
    std::function<void(QPainter& painter, const QRectF& page, const std::function<void()>& newPage)> paint;
};

// Where paper is a file: the sentence that names it, or that says that it could not be written, and its path
// if it was.
using PrintSaid = std::function<void(const QString& sentence, const QString& written)>;

// Shows a print preview of the pages, and prints them from there.
void showPrintPreview(const PrintedPages& pages, QWidget* parent, const PrintSaid& said);

} // namespace view
