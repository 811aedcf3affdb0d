// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"

#include <QByteArray>
#include <QString>

class QXmlStreamWriter;

// The beginning of every SVG picture.
namespace io {

const QString& svgNamespace();
const QString& xlinkNamespace();

// Pixels an inch. Those of SVG and CSS are 96; with another number, the size of the file is in millimetres.
inline constexpr double pixelsOfSvg = 96;

struct SvgHeading {
    attractor::RasterSize pixels;
    double dotsPerInch = pixelsOfSvg;
    QString title;
    QByteArray systemText; // `.ifs` text, for readSvgSystem()
};

// The root stays open, for elements in pixels, y down.
void startSvg(QXmlStreamWriter& xml, const SvgHeading& heading);

} // namespace io
