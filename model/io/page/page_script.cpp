// SPDX-License-Identifier: MIT
#include "io/page/page_script.h"

#include <QFile>
#include <QString>

#include <vector>

namespace io {

namespace {

// The script without the parts for modules and people: imports, exports, indents, and comments on lines of
// their own.
QByteArray plainScript(const QByteArray& module) {
    QByteArray script;
    bool inImport = false, inComment = false;
    for (const QByteArray& line : module.split('\n')) {
        const QByteArray text = line.trimmed();
        const bool beginsComment = text.startsWith("/**");
        inComment = inComment || beginsComment;
        inImport = inImport || line.startsWith("import ");
        if (inComment) {
            inComment = !text.endsWith("*/");
        } else if (inImport) {
            inImport = !text.endsWith("\";");
        } else if (!text.isEmpty() && !text.startsWith("//")) {
            script += (line.startsWith("export ") ? text.sliced(7) : text) + '\n';
        }
    }
    return script;
}

} // namespace

QByteArray pagePart(const char* name) {
    QFile file(QStringLiteral(":/web/") + QLatin1String(name));
    if (!file.open(QIODevice::ReadOnly)) qFatal("the program has no part %s of web pages", name);
    return file.readAll();
}

QByteArray joinedScript(const std::vector<const char*>& modules, const QByteArray& end) {
    QByteArray script = "\"use strict\";\n(() => {\n";
    for (const char* module : modules)
        script += plainScript(pagePart(module));
    return script + end + "})();\n";
}

std::vector<const char*> pageModules(const char* extra) {
    std::vector modules{"numbers.js", "geometry.js", "dom.js",          "texts.js", "camera.js", "drawing.js",
                        "table.js",   "ifs_text.js", "entry_reader.js", "link.js",  "figure.js"};
    if (extra != nullptr) modules.push_back(extra);
    modules.push_back("main.js");
    return modules;
}

std::vector<const char*> workerModules() {
    return {"engine.js", "worker.js"};
}

QByteArray pageStyle() {
    QByteArray style;
    for (const QByteArray& line : pagePart("page.css").split('\n'))
        style += line.trimmed() + '\n';
    return style;
}

} // namespace io
