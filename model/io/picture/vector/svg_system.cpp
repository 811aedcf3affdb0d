// SPDX-License-Identifier: MIT
#include "io/picture/vector/svg_system.h"

#include "io/text/xml_text.h"

#include <QCoreApplication>
#include <QXmlStreamReader>

namespace io {

namespace {

constexpr qsizetype maxSystemText = 8 * 1024 * 1024;

EmbeddedSystem refusal(const char* sentence) {
    return {{}, QCoreApplication::translate("SvgSystem", sentence)};
}

EmbeddedSystem textOf(QXmlStreamReader& xml) {
    QString text;
    while (xml.readNext() == QXmlStreamReader::Characters || xml.isComment()) {
        if (xml.isCharacters()) text += xml.text();
        if (text.size() > maxSystemText)
            return refusal(QT_TRANSLATE_NOOP("SvgSystem", "The system in the picture is larger than 8 MB."));
    }
    if (!xml.isEndElement())
        return refusal(QT_TRANSLATE_NOOP("SvgSystem", "The system in the picture is damaged."));
    return {text.toUtf8(), {}};
}

} // namespace

QString svgSystemNamespace() {
    return QStringLiteral("urn:barycage:system:1");
}

bool looksLikeSvg(const QByteArray& bytes) {
    QByteArray start = bytes.left(4096);
    if (start.startsWith("\xef\xbb\xbf")) start.remove(0, 3);
    start = start.trimmed();
    return (start.startsWith("<?xml") || start.startsWith("<!--") || start.startsWith("<svg")) &&
           start.contains("<svg");
}

EmbeddedSystem readSvgSystem(const QByteArray& bytes) {
    const XmlText svg = xmlText(bytes);
    if (svg.failure) return {{}, svg.failure};
    QXmlStreamReader xml(svg.text);
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isDTD())
            return refusal(QT_TRANSLATE_NOOP("SvgSystem", "The picture contains a document type declaration, "
                                                          "which Barycage neither writes nor reads."));
        if (xml.isStartElement() && xml.name() == u"system" && xml.namespaceUri() == svgSystemNamespace())
            return textOf(xml);
    }
    if (xml.hasError())
        return refusal(QT_TRANSLATE_NOOP("SvgSystem", "The file is not an SVG picture, or it is damaged."));
    return refusal(QT_TRANSLATE_NOOP(
        "SvgSystem",
        "The picture contains no system: it was not written by Barycage, or another program removed it."));
}

} // namespace io
