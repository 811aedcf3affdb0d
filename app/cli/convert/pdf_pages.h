// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QByteArray>
#include <QList>
#include <QString>

#include <memory>
#include <stop_token>

namespace cli {

struct PdfPages {
    QByteArray bytes; // contents of the file
    qsizetype count = 0;
};

// A square page for each system that has an attractor: its shapes, or the picture of a solid. What is left
// out is reported. None when stopped.
PdfPages pdfPages(const QList<std::shared_ptr<const document::Fractal>>& systems, const QString& inputName,
                  const std::stop_token& stop);

} // namespace cli
