// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QByteArrayList>
#include <QString>

// Building blocks of a PDF file.
namespace io {

QByteArray pdfNumber(double number);       // decimal notation, since PDF has no exponents
QByteArray pdfString(const QString& text); // Unicode string
QByteArray pdfReference(int object);

// Numbered objects. The first is the list of the pages.
class PdfFile {
public:
    PdfFile();

    int add(const QByteArray& content); // returns the number of the object
    int addStream(const QByteArray& dictionary, const QByteArray& content); // compresses the content
    // Content compressed with deflate.
    int addCompressed(const QByteArray& dictionary, const QByteArray& content);
    // `entries`: of the page’s dictionary, but for its kind and its parent.
    void addPage(const QByteArray& entries);

    QByteArray bytes(const QString& title) const;

private:
    QByteArrayList m_objects;
    QByteArrayList m_pages;
};

} // namespace io
