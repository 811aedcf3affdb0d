// SPDX-License-Identifier: MIT
#include "process/heading.h"

#include <QFileInfo>

namespace cli {

QString headingOf(const QString& fileName) {
    QString title = QFileInfo(fileName).completeBaseName();
    title.replace(u'_', u' ').replace(u'-', u' ');
    if (!title.isEmpty()) title[0] = title[0].toUpper();
    return title;
}

} // namespace cli
