// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace io {

// What a report is about.
struct InfoSubject {
    QString fileName; // as the user gave it
    QString format;   // "fractint", "png", "svg" …
    QList<document::Entry> entries;
    document::Problems problems;
    std::optional<double> hullTolerance;
};

// One object with everything that is known; null for what is not. docs: the manual page of barycage-cli.
QByteArray infoJson(const InfoSubject& subject);

// The same to be read by people, six digits.
QString infoText(const InfoSubject& subject);

} // namespace io
