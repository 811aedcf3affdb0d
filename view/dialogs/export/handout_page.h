// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QImage>
#include <QRectF>
#include <QStringList>

#include <functional>
#include <memory>
#include <span>

class QPainter;

namespace view {

struct HandoutOptions {
    enum class Kind {
        Handout,   // picture with cage and maps, and the formulas
        TaskSheet, // cage on a grid, and an empty table of maps
    };
    Kind kind = Kind::Handout;
    int perPage = 2;          // 1, 2, 4 or 6
    bool showsMaps = true;    // handouts only: numbered images of the cage in the picture
    bool hasFormulas = true;  // handouts only
    bool hasNameLine = false; // line for the pupil's name
};

struct HandoutItem {
    std::shared_ptr<const document::Fractal> fractal; // system in the plane or in space
    QImage picture;                                   // handouts only
};

// The entries from the top of `page` down, as many on each page as the options say: `newPage` begins another
// one.
void paintHandout(QPainter& painter, const QRectF& page, std::span<const HandoutItem> items,
                  const HandoutOptions& options, const std::function<void()>& newPage);

// "w₁(x, y) = (0.5x + 0.25, 0.5y)", to four digits, without what is 0. Number counts from 1.
template <int Dim> QString formulaText(const ifs::AffineMap<Dim>& map, std::size_t number);
// The formula on as many lines as it takes for each to fit, where that is possible: broken behind a comma or
// in front of a sign or of the probability, never in the middle of a number. Further lines are indented.
QStringList onLines(const QString& formula, const std::function<bool(const QString&)>& fits);
// "v₁ = (0, 0, 1)   v₂ = (1, 0, 0)": where the corners are now, to four digits, two on a line.
QStringList cornerTexts(const ifs::ControlCage<3>& cage);

} // namespace view
