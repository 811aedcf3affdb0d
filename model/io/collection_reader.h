// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>
#include <QString>

namespace io {

// What a file of any kind that can be opened holds. Only a Fractint collection may be written back in place.
struct Collection {
    QString format; // "fractint", "flame", "png", "svg"
    document::FractalFile file;
};

// Tells the format from the content: a Fractint collection, flames, or a picture that carries one.
// `path` names the entry of a file of bare rows.
Collection readCollection(const QByteArray& bytes, const QString& path = {});

} // namespace io
