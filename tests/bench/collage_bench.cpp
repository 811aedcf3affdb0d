// SPDX-License-Identifier: MIT
#include "bench/collage_bench.h"

#include "bridges/render_bridge.h"
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_part.h"
#include "canvas/scene/canvas_scene.h"
#include "collage/fit/collage_fit.h"
#include "collage/random_start.h"
#include "document/document.h"
#include "panels/collage/collage_panel.h"
#include "panels/collage/target_box.h"

#include <QApplication>
#include <QImage>
#include <QMouseEvent>
#include <QTemporaryDir>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

using namespace collage;

namespace collage_bench {

namespace {

using Maps = std::vector<ifs::AffineMap<2>>;
using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// A leaf with a notched edge and a stalk.
GreyPicture leaf(int side) {
    GreyPicture picture{side, side, {}, {}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double x = 2 * (column + 0.5) / side - 1, y = 1 - 2 * (row + 0.5) / side;
            const double edge = 0.55 * (1 - y * y) * (1 + 0.15 * std::sin(14 * y));
            const bool isInside = std::abs(y) < 0.9 && (std::abs(x) < edge || (y < 0 && std::abs(x) < 0.03));
            picture.grey.push_back(isInside ? 30 : 245);
            picture.opacity.push_back(255);
        }
    return picture;
}

// One iteration of the plain fit: every image outside to its nearest cell of the target, every cell of the
// target to its nearest image, both from whole feature transforms.
void improvePlainly(const Target& target, Maps& maps, double norm) {
    const int width = target.grid.width, height = target.grid.height;
    Mask images = emptyMask(width, height);
    std::vector<std::pair<int, int>> source(images.cells.size(), {-1, -1});
    std::vector<PairSums> sums(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const ifs::Matrix<2>& a = maps[i].linear;
        const double weight = std::max(std::abs(ifs::determinant<2>(a)), 0.02);
        for (std::size_t k = 0; k < target.cells.size(); ++k) {
            const double px = target.columns[k], py = target.rows[k];
            const double x = a(0, 0) * px + a(0, 1) * py + maps[i].translation.x();
            const double y = a(1, 0) * px + a(1, 1) * py + maps[i].translation.y();
            const int column = std::clamp(int(std::floor(x)), 0, width - 1);
            const int row = std::clamp(int(std::floor(y)), 0, height - 1);
            const std::size_t cell = images.index(column, row);
            images.cells[cell] = 1;
            source[cell] = {int(i), int(k)};
            sums[i].add(px, py, x, y, 0.1 * weight); // damping
            if (target.mask.cells[cell] != 0) continue;
            const int goal = target.features.nearest[cell];
            sums[i].add(px, py, goal % width + 0.5, goal / width + 0.5, weight);
        }
    }
    const FeatureTransform nearest = featureTransform(images);
    for (const std::int32_t cell : target.cells) {
        if (images.cells[std::size_t(cell)] != 0) continue;
        const auto [map, point] = source[std::size_t(nearest.nearest[std::size_t(cell)])];
        sums[std::size_t(map)].add(target.columns[std::size_t(point)], target.rows[std::size_t(point)],
                                   cell % width + 0.5, cell / width + 0.5, 1);
    }
    for (std::size_t i = 0; i < maps.size(); ++i)
        maps[i] = withNormAtMost(norm, leastSquaresMap(sums[i], MapClass::Affine, maps[i]), target.mean);
}

// The window with a target and three rough copies of it, whose second map is held by a corner.
class Window {
public:
    explicit Window(WithTarget with)
        : m_bridge(&m_document), m_canvas(&m_document, &m_bridge), m_panel(&m_document, &m_canvas) {
        document::Fractal fractal = m_document.fractal();
        document::Shape<2> shape;
        for (const double y : {-0.25, 0.0, 0.25})
            ifs::append<2>(shape.system, ifs::affineMap(0.5, 0.1, -0.1, 0.5, 0.05 * y, y), 0.3);
        fractal.shape = std::move(shape);
        m_document.setFile(document::fileOf(fractal));
        m_bridge.fixLiveSamples(1'000'000);
        m_canvas.setFixedSize(1920, 1080);
        m_canvas.show();
        m_panel.resize(360, 1000);
        m_panel.show();
        m_canvas.setTool(view::CanvasView::Tool::Maps);
        if (with == WithTarget::Yes) {
            const GreyPicture picture = leaf(512);
            const QImage image(picture.grey.data(), 512, 512, 512, QImage::Format_Grayscale8);
            const QString path = m_folder.filePath(QStringLiteral("leaf.png"));
            if (image.save(path)) m_panel.target()->read(path);
        }
        m_canvas.viewport()->installEventFilter(&m_watch);
        m_watch.bridge = &m_bridge;
        awaitNumbers();
        awaitPicture();
    }

    Drag drag(int events) {
        const QPointF start = m_canvas.canvas().positionOf({view::CanvasPart::Kind::Vertex, 1, 1});
        send(QEvent::MouseButtonPress, start);
        Drag drag;
        for (int event = 1; event <= events; ++event) {
            const auto begin = Clock::now();
            send(QEvent::MouseMove, start + QPointF(40 * std::sin(0.1 * event), 25 * std::sin(0.17 * event)));
            awaitPicture();
            drag.picture.push_back(millisecondsSince(begin));
            // Every tenth time the hand rests until the numbers have come.
            if (event % 10 != 0) continue;
            awaitNumbers();
            drag.numbers.push_back(millisecondsSince(begin));
        }
        send(QEvent::MouseButtonRelease, start);
        return drag;
    }

private:
    struct Watch : QObject {
        const view::RenderBridge* bridge = nullptr;
        std::uint64_t painted = 0;
        bool eventFilter(QObject*, QEvent* event) override {
            if (event->type() == QEvent::Paint && bridge->frame()) painted = bridge->frame()->revision;
            return false;
        }
    };

    void awaitPicture() {
        while (!(m_bridge.isCurrent() && m_watch.painted == m_bridge.frame()->revision))
            QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }
    void awaitNumbers() {
        while (!m_panel.isSettled())
            QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }
    void send(QEvent::Type type, const QPointF& at) {
        const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, m_canvas.viewport()->mapToGlobal(at), button, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(m_canvas.viewport(), &event);
    }

    QTemporaryDir m_folder;
    document::Document m_document;
    view::RenderBridge m_bridge;
    view::CanvasView m_canvas;
    view::CollagePanel m_panel;
    Watch m_watch;
};

} // namespace

double startsRatio(int repetitions) {
    const GreyPicture picture = leaf(128);
    const Target target = collage::target(targetMask(picture, 127, Polarity::Shape), 1, 0.25);
    CollageFit fit(target);
    double engine = std::numeric_limits<double>::infinity(), plain = engine;
    double bestOfEngine = engine, bestOfPlain = engine;
    for (int k = 0; k < repetitions; ++k) {
        Maps maps = randomStart(target, 4, {}, 1, std::uint64_t(k));
        Maps others = maps;
        auto begin = Clock::now();
        fit.improve(maps, {});
        engine = std::min(engine, millisecondsSince(begin));
        begin = Clock::now();
        for (int iteration = 0; iteration < 40; ++iteration)
            improvePlainly(target, others, iteration < 15 ? 0.75 : 0.9);
        plain = std::min(plain, millisecondsSince(begin));
        bestOfEngine = std::min(bestOfEngine, fit.error(maps));
        bestOfPlain = std::min(bestOfPlain, fit.error(others));
    }
    const bool isFair = std::abs(bestOfEngine - bestOfPlain) < 0.25; // cells
    return isFair ? plain / engine : std::nan("");
}

Drag drag(WithTarget target, int events) {
    return Window(target).drag(events);
}

} // namespace collage_bench
