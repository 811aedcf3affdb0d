// SPDX-License-Identifier: MIT
#include "io/page/page_script.h"

#include "notation/page/page_text.h"

#include <QFile>
#include <QString>

namespace io {

QByteArray pagePart(const std::string& name) {
    QFile file(QStringLiteral(":/web/") + QString::fromStdString(name));
    if (!file.open(QIODevice::ReadOnly)) qFatal("the program has no part %s of web pages", name.c_str());
    return file.readAll();
}

QByteArray joinedScript(const std::vector<std::string>& modules, const QByteArray& end) {
    std::vector<std::string> texts;
    for (const std::string& module : modules)
        texts.push_back(pagePart(module).toStdString());
    return QByteArray::fromStdString(notation::joinedScript(texts, end.toStdString()));
}

} // namespace io
