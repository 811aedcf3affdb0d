// SPDX-License-Identifier: MIT
#include "io/solid/openscad.h"

#include "attractor/samples/prepared_space.h"
#include "document/fractal/fractal_geometry.h"
#include "document/text/file_names.h"
#include "document/text/text.h"
#include "ifs/extent/extent.h"
#include "io/solid/printable_solid.h"
#include "io/text/number.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace io {

namespace {

constexpr double usualParts = 1000;

QByteArray vectorText(const ifs::Vector<3>& v) {
    return '[' + formatNumber(v.x()) + ", " + formatNumber(v.y()) + ", " + formatNumber(v.z()) + ']';
}

QByteArray matrixText(const ifs::AffineMap<3>& map) {
    QByteArray text = "multmatrix([";
    for (int row = 0; row < 3; ++row) {
        text += '[';
        for (int column = 0; column < 3; ++column)
            text += formatNumber(map.linear(row, column)) + ", ";
        text += formatNumber(map.translation[row]) + "], ";
    }
    return text + "[0, 0, 0, 1]])";
}

// The largest diagonal of the images of the box by words of one length: no part is larger. Walks the words
// that are larger than `enough`, at most maxParts of them; infinite beyond.
double largestPart(const std::vector<ifs::AffineMap<3>>& maps, const ifs::Matrix<3>& box, int depth) {
    std::vector<ifs::Matrix<3>> words{box};
    for (int level = 0; level < depth; ++level) {
        if (double(words.size()) * double(maps.size()) > double(OpenScad::maxParts)) return HUGE_VAL;
        std::vector<ifs::Matrix<3>> longer;
        longer.reserve(words.size() * maps.size());
        for (const ifs::AffineMap<3>& map : maps)
            for (const ifs::Matrix<3>& word : words)
                longer.push_back(map.linear * word);
        words = std::move(longer);
    }
    double largest = 0;
    for (const ifs::Matrix<3>& word : words)
        largest = std::max(largest, word.cwiseAbs().rowwise().sum().norm());
    return 2 * largest;
}

int usualDepth(std::size_t maps) {
    constexpr int deepest = 12;
    int depth = 1;
    for (double parts = double(maps); depth < deepest && parts * double(maps) <= usualParts; ++depth)
        parts *= double(maps);
    return depth;
}

QByteArray programText(const document::Fractal& fractal, const attractor::PreparedSpace& system,
                       const ifs::BoundingBox<3>& box, int depth) {
    const ifs::Vector<3> error = ifs::Vector<3>::Constant(box.error);
    const QString name = document::oneLine(fractal.name.simplified());
    QByteArray text = "// " + name.toUtf8() + ", written by Barycage\n";
    text += "// Every level multiplies the number of parts by " +
            QByteArray::number(int(system.maps.size())) + ".\ndepth = " + QByteArray::number(depth) +
            ";\n\nmodule part(level) {\n";
    text += "  if (level == 0)\n    translate(" + vectorText(box.min - error) + ") cube(" +
            vectorText(box.max - box.min + 2 * error) + ");\n  else {\n";
    for (const ifs::AffineMap<3>& map : system.maps)
        text += "    " + matrixText(map) + " part(level - 1);\n";
    text += "  }\n}\n\n";
    const document::Shape<3>& shape = *document::space(fractal);
    const ifs::AffineMap<3> placement = shape.cage ? ifs::displayMap(*shape.cage) : ifs::AffineMap<3>();
    for (const auto& [word, change] : ifs::pieces<3>(system.moved, system.maps.size())) {
        const ifs::AffineMap<3> shown = placement * change * ifs::composed<3>(system.maps, word);
        if (!(shown == ifs::AffineMap<3>())) text += matrixText(shown) + ' ';
        text += word.empty() ? QByteArray("part(depth);\n")
                             : "part(max(0, depth - " + QByteArray::number(int(word.size())) + "));\n";
    }
    return text;
}

// Largest stretch of a part on its way to where it is shown, and the longest word of a piece.
struct Pieces {
    double stretch = 0;
    int longest = 0;
};
Pieces piecesOf(const attractor::PreparedSpace& system, const ifs::Matrix<3>& placed) {
    Pieces result;
    for (const auto& [word, change] : ifs::pieces<3>(system.moved, system.maps.size())) {
        result.stretch = std::max(result.stretch, ifs::spectralNorm<3>(placed * change.linear));
        result.longest = std::max(result.longest, int(word.size()));
    }
    return result;
}

} // namespace

OpenScad openScad(const document::Fractal& fractal, double detail) {
    OpenScad result;
    result.failure = obstacleToSolid(fractal);
    if (result.failure) return result;
    const document::Shape<3>* shape = document::space(fractal);
    const attractor::PreparedSpace system =
        attractor::preparedSpace(shape->system, document::movedBranches(*shape));
    const auto support = system.isCertified ? ifs::SupportFunction<3>::of(system.maps) : std::nullopt;
    if (!support) {
        result.failure = Text::tr("“%1” has no certified attractor, so it has no solid.").arg(fractal.name);
        return result;
    }
    const ifs::BoundingBox<3> box = ifs::boundingBox(*support, 1e-6 * support->radius());
    const ifs::Matrix<3> placed =
        shape->cage ? ifs::displayMap(*shape->cage).linear : ifs::Matrix<3>::Identity();
    const ifs::Matrix<3> half = ((box.max - box.min) / 2 + ifs::Vector<3>::Constant(box.error)).asDiagonal();
    const auto [stretch, longest] = piecesOf(system, placed);
    result.depth = std::max(longest, detail > 0 ? 0 : usualDepth(system.maps.size()));
    result.bound = stretch * largestPart(system.maps, half, result.depth);
    while (detail > 0 && result.bound > detail && result.bound < HUGE_VAL)
        result.bound = stretch * largestPart(system.maps, half, ++result.depth);
    if (!(result.bound < HUGE_VAL)) {
        result.failure = Text::tr("“%1” would need more than %2 parts in OpenSCAD. Choose larger voxels.")
                             .arg(fractal.name, QString::number(OpenScad::maxParts));
        return result;
    }
    result.text = programText(fractal, system, box, result.depth);
    return result;
}

} // namespace io
