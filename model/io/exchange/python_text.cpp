// SPDX-License-Identifier: MIT
#include "io/exchange/python_text.h"

#include "io/fractint/entry_writer.h"

namespace io {

namespace {

// What is between three quotation marks. Names and comments may hold anything.
QByteArray escapedForPython(const QByteArray& text) {
    QByteArray escaped;
    for (const char byte : text) {
        const bool isControl = (byte >= 0 && byte < ' ' && byte != '\n' && byte != '\t') || byte == '\x7f';
        if (isControl)
            escaped += "\\x" + QByteArray(1, byte).toHex();
        else if (byte == '\\' || byte == '"')
            escaped += QByteArray("\\") + byte;
        else
            escaped += byte;
    }
    return escaped;
}

} // namespace

QByteArray pythonText(const document::Fractal& fractal) {
    return "# Needs the module of Barycage: ./dev python builds it and says where it is.\n"
           "import barycage as bc\n\nentry = bc.parse(\"\"\"\n" +
           escapedForPython(writeEntry(fractal)) + "\"\"\")[0]\nentry  # a notebook shows it in its cage\n";
}

} // namespace io
