// SPDX-License-Identifier: MIT
#include "canvas/scene/cylinder_choice.h"

#include "canvas/geometry/canvas_geometry.h"
#include "ifs/extent/polygon.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace view {

void CylinderChoice::setShapes(const std::vector<document::OutlineShape>& shapes,
                               std::vector<document::OutlineShape> outer) {
    m_shapes = std::move(outer);
    m_first = m_shapes.size();
    std::ranges::copy_if(shapes, std::back_inserter(m_shapes), [](const document::OutlineShape& shape) {
        return shape.kind == document::Outline::Cylinders;
    });
    const bool isThere = std::any_of(m_shapes.begin() + std::ptrdiff_t(m_first), m_shapes.end(),
                                     [&](const auto& shape) { return shape.word == m_word; });
    if (!isThere) m_word.clear();
}

bool CylinderChoice::chooseAt(const attractor::Camera& camera, const QPointF& position) {
    ifs::Word word;
    double smallest = 0;
    for (std::size_t k = m_first; k < m_shapes.size(); ++k) {
        const document::OutlineShape& shape = m_shapes[k];
        if (!pixelsOf(camera, shape.points).containsPoint(position, Qt::OddEvenFill)) continue;
        const double area = std::abs(ifs::area(shape.points));
        if (!word.empty() && area >= smallest) continue;
        word = shape.word;
        smallest = area;
    }
    return std::exchange(m_word, word) != word;
}

std::vector<const document::OutlineShape*> CylinderChoice::walk() const {
    std::vector<const document::OutlineShape*> walk;
    for (std::size_t length = 1; length <= m_word.size(); ++length)
        if (const auto* shape = find({m_word.begin(), m_word.begin() + std::ptrdiff_t(length)}))
            walk.push_back(shape);
    return walk;
}

const document::OutlineShape* CylinderChoice::find(const ifs::Word& word) const {
    const auto found = std::ranges::find(m_shapes, word, &document::OutlineShape::word);
    return found == m_shapes.end() ? nullptr : &*found;
}

} // namespace view
