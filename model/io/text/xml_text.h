// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/save_file.h"

#include <QByteArray>
#include <QString>

namespace io {

// The text of an XML file, fit to be given to a QXmlStreamReader: UTF-8 where it is valid, else Latin-1,
// whatever encoding it claims to have. Refused with a sentence: more than 64 MB; elements more than 1000
// deep; more than 1000 attributes in one tag, which the parser compares each with each. The rest, document
// types included, is the caller's to judge.
struct XmlText {
    QString text;
    Failure failure;
};
XmlText xmlText(const QByteArray& bytes);

} // namespace io
