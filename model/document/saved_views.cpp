// SPDX-License-Identifier: MIT
#include "document/saved_views.h"

#include <QLocale>
#include <QSet>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace document {

namespace {

const QString nameKey = QStringLiteral("barycage: view ");
const QString cameraKey = QStringLiteral("barycage: view-camera ");
constexpr qsizetype maxLine = 69;       // bytes
constexpr qsizetype maxViewName = 48;   // bytes
constexpr std::size_t planeNumbers = 4; // numbers without the optional rotation
constexpr std::size_t spaceNumbers = 10;
constexpr double maxDistance = 1e30; // limit of positions and heights, as of the zoom

// The lines of one view.
struct Block {
    QString name;
    QList<qsizetype> lines;
    std::vector<double> numbers; // empty: invalid
    bool isWrong = false;
};

void readNumbers(const QString& values, Block& block) {
    for (const QString& text : values.split(u' ', Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const double number = text.toDouble(&isNumber);
        block.isWrong |=
            !isNumber || !(std::abs(number) <= maxDistance) || block.numbers.size() >= spaceNumbers;
        if (block.isWrong) return;
        block.numbers.push_back(number);
    }
}

std::vector<Block> blocksIn(const QStringList& comments) {
    std::vector<Block> blocks;
    for (qsizetype i = 0; i < comments.size(); ++i) {
        const QString& comment = comments[i];
        if (comment.startsWith(nameKey)) {
            blocks.push_back({storableViewName(comment.mid(nameKey.size())), {i}, {}});
        } else if (comment.startsWith(cameraKey) && !blocks.empty()) {
            readNumbers(comment.mid(cameraKey.size()), blocks.back());
            blocks.back().lines << i;
        }
    }
    return blocks;
}

std::optional<attractor::View> planeView(const std::vector<double>& n) {
    const bool isTurned = n.size() == planeNumbers + 1;
    if ((n.size() != planeNumbers && !isTurned) || !(n[2] >= 1 / maxDistance) || std::abs(n[3]) != 1)
        return std::nullopt;
    return attractor::View{{n[0], n[1]},
                           n[2],
                           n[3] > 0 ? attractor::YAxis::Up : attractor::YAxis::Down,
                           isTurned ? attractor::rotationOf(n[4]) : 0};
}

std::optional<attractor::OrbitCamera> spaceView(const std::vector<double>& n) {
    if (n.size() != spaceNumbers) return std::nullopt;
    const attractor::Orientation orientation(n[3], n[4], n[5], n[6]);
    if (std::abs(orientation.norm() - 1) > 1e-3 || !(n[7] >= 1 / maxDistance)) return std::nullopt;
    if (!(n[8] > 0 && n[8] < 180) || (n[9] != 0 && n[9] != 1)) return std::nullopt;
    attractor::OrbitCamera camera;
    camera.target = {n[0], n[1], n[2]};
    camera.orientation = orientation;
    // Keeps the bits of a stored orientation.
    if (std::abs(orientation.norm() - 1) > 1e-12) camera.orientation.normalize();
    camera.height = n[7];
    camera.fieldOfView = n[8];
    using enum attractor::OrbitCamera::Projection;
    camera.projection = n[9] == 1 ? Perspective : Orthographic;
    return camera;
}

std::optional<SavedView::Camera> cameraOf(const Block& block, int dimension) {
    if (block.isWrong || block.name.isEmpty()) return std::nullopt;
    if (dimension == 2)
        if (const auto view = planeView(block.numbers)) return *view;
    if (dimension == 3)
        if (const auto view = spaceView(block.numbers)) return *view;
    return std::nullopt;
}

int dimensionOf(const SavedView::Camera& camera) {
    return std::holds_alternative<attractor::View>(camera) ? 2 : 3;
}

std::vector<double> numbersOf(const SavedView::Camera& camera) {
    if (const auto* view = std::get_if<attractor::View>(&camera)) {
        std::vector<double> numbers{view->centre.x(), view->centre.y(), view->height,
                                    view->yAxis == attractor::YAxis::Up ? 1.0 : -1.0};
        if (view->rotation != 0) numbers.push_back(attractor::degreesOf(view->rotation));
        return numbers;
    }
    const auto& orbit = std::get<attractor::OrbitCamera>(camera);
    const attractor::Orientation& q = orbit.orientation;
    const bool isPerspective = orbit.projection == attractor::OrbitCamera::Projection::Perspective;
    return {orbit.target.x(), orbit.target.y(),  orbit.target.z(),         q.w(), q.x(), q.y(), q.z(),
            orbit.height,     orbit.fieldOfView, isPerspective ? 1.0 : 0.0};
}

QStringList linesOf(const SavedView& view) {
    QStringList lines{nameKey + view.name};
    QString line = cameraKey.trimmed();
    for (const double number : numbersOf(view.camera)) {
        const QString text = QString::number(number, 'g', QLocale::FloatingPointShortest);
        if (line.size() + 1 + text.size() > maxLine) lines << std::exchange(line, cameraKey.trimmed());
        line += u' ' + text;
    }
    return lines << line;
}

// The block of a view of the entry's dimension.
std::optional<Block> blockNamed(const Fractal& fractal, const QString& name) {
    for (Block& block : blocksIn(fractal.comments))
        if (block.name == name && cameraOf(block, dimension(fractal))) return std::move(block);
    return std::nullopt;
}

void removeLines(QStringList& comments, const QList<qsizetype>& lines) {
    for (auto line = lines.crbegin(); line != lines.crend(); ++line)
        comments.removeAt(*line);
}

} // namespace

std::vector<SavedView> savedViews(const Fractal& fractal) {
    std::vector<SavedView> views;
    QSet<QString> names;
    for (const Block& block : blocksIn(fractal.comments)) {
        if (views.size() == maxSavedViews) break;
        const auto camera = cameraOf(block, dimension(fractal));
        if (!camera || names.contains(block.name)) continue;
        names.insert(block.name);
        views.push_back({block.name, *camera});
    }
    return views;
}

std::optional<SavedView> savedView(const Fractal& fractal, const QString& name) {
    for (SavedView& view : savedViews(fractal))
        if (view.name == name) return std::move(view);
    return std::nullopt;
}

Fractal withSavedView(Fractal fractal, const SavedView& view) {
    if (dimensionOf(view.camera) != dimension(fractal) || view.name.isEmpty()) return fractal;
    if (const auto before = savedView(fractal, view.name); before && before->camera == view.camera)
        return fractal;
    const QStringList lines = linesOf(view);
    const std::optional<Block> block = blockNamed(fractal, view.name);
    if (!block) {
        if (savedViews(fractal).size() < maxSavedViews) fractal.comments << lines;
        return fractal;
    }
    removeLines(fractal.comments, block->lines);
    for (qsizetype i = 0; i < lines.size(); ++i)
        fractal.comments.insert(block->lines.front() + i, lines[i]);
    return fractal;
}

Fractal withoutSavedView(Fractal fractal, const QString& name) {
    // A removed block may reveal another one.
    while (const std::optional<Block> block = blockNamed(fractal, name))
        removeLines(fractal.comments, block->lines);
    return fractal;
}

Fractal withViewRenamed(Fractal fractal, const QString& name, const QString& to) {
    const QString stored = storableViewName(to);
    const std::optional<Block> block = blockNamed(fractal, name);
    if (block && !stored.isEmpty() && !savedView(fractal, stored))
        fractal.comments[block->lines.front()] = nameKey + stored;
    return fractal;
}

QString storableViewName(const QString& name) {
    QString stored;
    for (const QChar& letter : name.simplified())
        if (letter.isPrint() || letter.isSurrogate()) stored += letter;
    while (stored.toUtf8().size() > maxViewName)
        stored.chop(stored.size() > 1 && stored.back().isLowSurrogate() ? 2 : 1);
    return stored.simplified();
}

} // namespace document
