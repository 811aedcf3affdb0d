// SPDX-License-Identifier: MIT
#include "document/steps/step_picture.h"

#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/prepared_system.h"
#include "document/fractal/fractal_geometry.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

namespace document {

namespace {

constexpr double minDivided = 1.5;    // pixels; smaller images are drawn as one
constexpr double minOutlined = 24;    // pixels
constexpr double thin = 1;            // pixels; narrower images are drawn as lines of this width
constexpr int straightPieces = 12;    // pieces of an edge if the cage bends
constexpr int nodesPerCheck = 256;    // images between two checks of the stop token
constexpr double maxCoordinate = 1e7; // pixels; QPainter overflows beyond
const QColor grey(150, 156, 166);     // colour of B itself, visible on light and dark

class StepPainter {
public:
    explicit StepPainter(const StepJob& job)
        : m_job(job),
          m_system(attractor::prepared(*system2(*job.fractal), movedBranches(*job.fractal))),
          m_along(attractor::colourCoordinates<2>(job.fractal->appearance, *system2(*job.fractal), m_system)),
          m_placement(placement(*job.fractal)),
          m_shape(overAttractor(*job.shape, *job.fractal)) {
        m_low = m_system.centre - m_system.halfExtent;
        m_high = m_system.centre + m_system.halfExtent;
        for (const auto& contour : m_shape.contours)
            for (const ifs::Vector<2>& corner : contour) {
                m_low = m_low.cwiseMin(corner);
                m_high = m_high.cwiseMax(corner);
            }
        if (m_placement.bend()) divideEdges();
        m_path.setFillRule(Qt::OddEvenFill);
    }

    bool paint(QImage& image, const std::stop_token& stop) {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        std::vector<Node> stack = beginnings();
        for (int visits = 1; !stack.empty(); ++visits) {
            if (visits % nodesPerCheck == 0 && stop.stop_requested()) return false;
            const Node node = stack.back();
            stack.pop_back();
            const Reach reach = reachOf(node.map);
            if (!reach.isInView) continue;
            if (node.depth == m_job.iterations || reach.size < minDivided) {
                draw(painter, node, reach);
                continue;
            }
            for (std::size_t i = m_system.maps.size(); i-- > 0;)
                if (isChild(node, i)) stack.push_back(child(node, i));
        }
        return true;
    }

private:
    struct Node {
        ifs::AffineMap<2> map; // change∘w_word
        int depth = 0;
        std::size_t firstMap = 0;
        std::size_t lastMap = 0;
        attractor::PaletteInterval colours{};
    };
    struct Reach {
        bool isInView = false;
        double size = 0; // pixels
        QPointF middle;
    };

    Node child(const Node& node, std::size_t i) const {
        return {node.map * m_system.maps[i], node.depth + 1, node.depth == 0 ? i : node.firstMap, i,
                m_along.child(node.colours, i)};
    }
    bool isChild(const Node& node, std::size_t i) const {
        return m_system.links.empty() || node.depth == 0 ||
               m_system.links[i * m_system.maps.size() + node.lastMap] > 0;
    }

    std::vector<Node> beginnings() const {
        std::vector<Node> nodes;
        const auto pieces =
            ifs::pieces<2>(m_system.moved, m_system.maps.size(), std::size_t(m_job.iterations));
        for (const auto& [word, change] : pieces) {
            Node node{change};
            bool isAdmissible = true;
            for (const int symbol : word) {
                isAdmissible = isAdmissible && isChild(node, std::size_t(symbol));
                node = child(node, std::size_t(symbol));
            }
            if (isAdmissible) nodes.push_back(node);
        }
        std::ranges::reverse(nodes);
        return nodes;
    }

    void divideEdges() {
        for (auto& contour : m_shape.contours) {
            if (contour.size() > 40) continue; // curves
            std::vector<ifs::Vector<2>> divided;
            for (std::size_t j = 0; j < contour.size(); ++j) {
                const ifs::Vector<2> edge = contour[(j + 1) % contour.size()] - contour[j];
                for (int k = 0; k < straightPieces; ++k)
                    divided.push_back(contour[j] + edge * (double(k) / straightPieces));
            }
            contour = std::move(divided);
        }
    }

    QPointF shown(const ifs::Vector<2>& code) const {
        const ifs::Vector<2> pixel = toPixel(m_job.camera, m_placement(code));
        return {pixel.x(), pixel.y()};
    }

    Reach reachOf(const ifs::AffineMap<2>& map) const {
        const ifs::Vector<2> halfBox = (m_high - m_low) / 2;
        ifs::Matrix<2> spread = m_placement.affine().linear * map.linear;
        spread.col(0) *= halfBox.x();
        spread.col(1) *= halfBox.y();
        if (const attractor::Camera& camera = m_job.camera; camera.rotation != 0)
            spread = (worldToPixel(camera).linear / camera.pixelsPerUnit * spread).eval();
        const ifs::Vector<2> half = spread.cwiseAbs().rowwise().sum() * m_job.camera.pixelsPerUnit;
        const QPointF middle = shown(map((m_low + m_high) / 2));
        // Margin for bends, which may carry parts farther than the affine fit does.
        const double room = m_placement.bend() ? 3 * half.maxCoeff() : 0;
        const bool isInView =
            middle.x() + half.x() + room >= 0 && middle.x() - half.x() - room <= m_job.camera.width &&
            middle.y() + half.y() + room >= 0 && middle.y() - half.y() - room <= m_job.camera.height;
        return {isInView, 2 * half.maxCoeff(), middle};
    }

    QColor colourOf(const Node& node) const {
        const attractor::Appearance& look = m_job.fractal->appearance;
        if (node.depth == 0) return grey;
        attractor::Rgba colour;
        if (look.colourBy == attractor::ColourBy::Address || look.colourBy == attractor::ColourBy::Blend) {
            colour = colourAt(look.palette, m_along.middle(node.colours));
        } else {
            const std::size_t index = m_system.index[node.firstMap];
            colour = mapColour(look, system2(*m_job.fractal)->maps[index].id, index);
        }
        return {colour.red, colour.green, colour.blue};
    }

    void draw(QPainter& painter, const Node& node, const Reach& reach) {
        const QColor colour = colourOf(node);
        if (reach.size < minDivided) {
            painter.fillRect(QRectF(reach.middle - QPointF(0.5, 0.5), QSizeF(1, 1)), colour);
            return;
        }
        m_path.clear();
        for (const auto& contour : m_shape.contours) {
            QPolygonF polygon;
            for (const ifs::Vector<2>& corner : contour) {
                const QPointF point = shown(node.map(corner));
                if (!(std::abs(point.x()) < maxCoordinate && std::abs(point.y()) < maxCoordinate)) return;
                polygon << point;
            }
            m_path.addPolygon(polygon);
            m_path.closeSubpath();
        }
        const ifs::Vector<2> stretch = ifs::singularValues<2>(m_placement.affine().linear * node.map.linear) *
                                       (m_high - m_low).maxCoeff() * m_job.camera.pixelsPerUnit;
        const bool isThin = stretch[1] < thin;
        painter.setBrush(colour);
        if (isThin)
            painter.setPen(QPen(colour, thin));
        else if (reach.size >= minOutlined)
            painter.setPen(QPen(colour.darker(150), 1));
        else
            painter.setPen(Qt::NoPen);
        painter.drawPath(m_path);
    }

    const StepJob& m_job;
    attractor::PreparedSystem m_system;
    attractor::ColourCoordinates m_along; // palette coordinates
    ifs::Placement m_placement;
    StartShape m_shape; // coordinates of the code
    ifs::Vector<2> m_low, m_high;
    QPainterPath m_path;
};

} // namespace

std::optional<attractor::Frame> stepPicture(const StepJob& job, const std::stop_token& stop) {
    const auto begin = std::chrono::steady_clock::now();
    attractor::Frame frame;
    frame.revision = job.revision;
    frame.camera = job.camera;
    frame.iterations = job.iterations;
    frame.measure = 1;
    frame.passes = 1;
    const attractor::Rgba& background = job.fractal->appearance.background;
    frame.opaque = background.alpha == 255;
    frame.pixels.resize(std::size_t(job.camera.width) * std::size_t(job.camera.height));
    QImage image(reinterpret_cast<uchar*>(frame.pixels.data()), job.camera.width, job.camera.height,
                 qsizetype(job.camera.width) * 4, QImage::Format_ARGB32_Premultiplied);
    image.fill(QColor(background.red, background.green, background.blue, background.alpha));
    if (!StepPainter(job).paint(image, stop)) return std::nullopt;
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    frame.milliseconds = time.count();
    return frame;
}

} // namespace document
