// SPDX-License-Identifier: MIT
#include "io/text/xml_text.h"
#include "document/text/text.h"

namespace io {

namespace {

constexpr qsizetype maxFile = 64 * 1024 * 1024;
constexpr int deepest = 1000;
constexpr int maxAttributes = 1000;

// Past the next `end`, or the end of the text.
qsizetype behind(QByteArrayView xml, qsizetype from, QByteArrayView end) {
    const qsizetype found = xml.indexOf(end, from);
    return found < 0 ? xml.size() : found + end.size();
}

// Goes over the tags without understanding them, in time linear in the size.
Failure obstacle(QByteArrayView xml) {
    int depth = 0;
    for (qsizetype at = xml.indexOf('<'); at >= 0 && at < xml.size(); at = xml.indexOf('<', at)) {
        const QByteArrayView rest = xml.sliced(at);
        if (rest.startsWith("<!--")) {
            at = behind(xml, at + 4, "-->");
        } else if (rest.startsWith("<![CDATA[")) {
            at = behind(xml, at, "]]>");
        } else if (rest.startsWith("<?")) {
            at = behind(xml, at, "?>");
        } else if (rest.startsWith("<!")) {
            return std::nullopt; // document type: ends the search
        } else {
            const bool closes = rest.startsWith("</");
            int attributes = 0;
            char quote = 0;
            for (++at; at < xml.size() && (quote != 0 || xml[at] != '>'); ++at) {
                const char c = xml[at];
                if (quote != 0)
                    quote = c == quote ? char(0) : quote;
                else if (c == '"' || c == '\'')
                    quote = c;
                else if (c == '=' && ++attributes > maxAttributes)
                    return Text::tr("A tag has more than %1 attributes, which is the limit.")
                        .arg(maxAttributes);
            }
            if (closes)
                --depth;
            else if (xml[at - 1] != '/' && ++depth > deepest)
                return Text::tr("The elements are nested more than %1 levels deep, which is the limit.")
                    .arg(deepest);
        }
    }
    return std::nullopt;
}

} // namespace

XmlText xmlText(const QByteArray& bytes) {
    if (bytes.size() > maxFile)
        return {{}, Text::tr("The file is larger than 64 MB, which is the limit for XML.")};
    if (Failure failure = obstacle(bytes)) return {{}, std::move(failure)};
    return {QByteArrayView(bytes).isValidUtf8() ? QString::fromUtf8(bytes) : QString::fromLatin1(bytes), {}};
}

} // namespace io
