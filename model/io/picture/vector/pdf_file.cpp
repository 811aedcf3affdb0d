// SPDX-License-Identifier: MIT
#include "io/picture/vector/pdf_file.h"

#include <array>
#include <charconv>

namespace io {

namespace {

constexpr int pageList = 1; // object number of the list of pages

} // namespace

QByteArray pdfNumber(double number) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number == 0 ? 0.0 : number,
                                   std::chars_format::fixed);
    return {buffer.data(), end.ptr - buffer.data()};
}

QByteArray pdfString(const QString& text) {
    QByteArray hex = "<FEFF";
    for (const QChar c : text)
        hex += QByteArray::number(c.unicode(), 16).rightJustified(4, '0');
    return hex + '>';
}

QByteArray pdfReference(int object) {
    return QByteArray::number(object) + " 0 R";
}

PdfFile::PdfFile() {
    m_objects.append(QByteArray());
}

int PdfFile::add(const QByteArray& content) {
    m_objects.append(content);
    return int(m_objects.size());
}

int PdfFile::addStream(const QByteArray& dictionary, const QByteArray& content) {
    constexpr int header = 4; // bytes of Qt's own header before the zlib stream
    return addCompressed(dictionary, qCompress(content, 9).mid(header));
}

int PdfFile::addCompressed(const QByteArray& dictionary, const QByteArray& content) {
    return add("<<" + dictionary + "/Filter/FlateDecode/Length " + QByteArray::number(content.size()) +
               ">>\nstream\n" + content + "\nendstream");
}

void PdfFile::addPage(const QByteArray& entries) {
    m_pages << pdfReference(add("<</Type/Page/Parent " + pdfReference(pageList) + entries + ">>"));
}

QByteArray PdfFile::bytes(const QString& title) const {
    QByteArrayList objects = m_objects;
    objects[pageList - 1] =
        "<</Type/Pages/Count " + QByteArray::number(m_pages.size()) + "/Kids[" + m_pages.join(' ') + "]>>";
    objects << "<</Type/Catalog/Pages " + pdfReference(pageList) + ">>";
    const QByteArray catalog = pdfReference(int(objects.size()));
    objects << "<</Producer(Barycage)/Title " + pdfString(title) + ">>";
    const QByteArray information = pdfReference(int(objects.size()));
    QByteArray bytes = "%PDF-1.5\n%\xe2\xe3\xcf\xd3\n";
    QByteArray table;
    for (qsizetype i = 0; i < objects.size(); ++i) {
        table += QByteArray::number(bytes.size()).rightJustified(10, '0') + " 00000 n \n";
        bytes += QByteArray::number(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
    }
    const QByteArray count = QByteArray::number(objects.size() + 1);
    const QByteArray begin = QByteArray::number(bytes.size());
    return bytes + "xref\n0 " + count + "\n0000000000 65535 f \n" + table + "trailer\n<</Size " + count +
           "/Root " + catalog + "/Info " + information + ">>\nstartxref\n" + begin + "\n%%EOF\n";
}

} // namespace io
