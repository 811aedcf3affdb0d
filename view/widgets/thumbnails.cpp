// SPDX-License-Identifier: MIT
#include "widgets/thumbnails.h"

#include "attractor/light/solid_light.h"
#include "attractor/render/render_queue.h"
#include "attractor/render/solid_rendering.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "io/picture/thumbnail_cache.h"

#include <QPainter>

#include <algorithm>
#include <optional>
#include <utility>

namespace view {
namespace {

constexpr int cacheBytes = 24 * 1024 * 1024;
constexpr int maxWanted = 512; // more rows than any screen shows; older requests are dropped
constexpr int maxRunning = 2;  // one being drawn and one waiting, so that the order stays ours
constexpr int samplesPerPixel = 24;
constexpr double shareOfMargin = 0.07;
constexpr double defaultAzimuth = 30; // degrees; first view of a solid
constexpr double defaultElevation = 20;

bool looksTheSame(const document::Fractal& a, const document::Fractal& b) {
    return a.shape == b.shape && a.appearance == b.appearance;
}

// The box of the picture; nullopt when there is nothing to draw. If no box is certified, the corners of the
// cage hold the picture as a rule.
std::optional<document::Box> boxToShow(const document::Fractal& fractal) {
    if (auto box = document::boxWithShadow(fractal, attractor::YAxis::Up)) return box;
    const ifs::ControlCage<2>* cage = document::cage2(fractal);
    if (!cage || cage->current.empty()) return std::nullopt;
    document::Box box{cage->current.front(), cage->current.front()};
    for (const auto& corner : cage->current) {
        box.min = box.min.cwiseMin(corner);
        box.max = box.max.cwiseMax(corner);
    }
    return box;
}

QImage pictureOf(const attractor::Frame& frame) {
    return QImage(reinterpret_cast<const uchar*>(frame.pixels.data()), frame.camera.width,
                  frame.camera.height, QImage::Format_ARGB32_Premultiplied)
        .copy();
}

// The picture by which the cache knows that there is nothing.
QImage nothing() {
    QImage image(1, 1, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    return image;
}

// A solid is drawn at once: there is nothing to refine.
QImage pictureInSpace(const document::Fractal& fractal, int side) {
    attractor::OrbitCamera camera;
    camera.orientation = attractor::orbit(defaultAzimuth, defaultElevation);
    camera.size.width = camera.size.height = side;
    if (!document::spaceSupport(fractal)) return nothing();
    camera = document::fittedToPicture(fractal, camera, shareOfMargin);
    attractor::SolidRendering rendering(document::spaceRequest(fractal, camera));
    rendering.draw();
    attractor::Workers alone(1);
    const auto pixels = attractor::lit(rendering.raster(), document::solidAppearance(fractal),
                                       attractor::solidView(camera, camera.target.y() - camera.height / 2,
                                                            camera.target.y() + camera.height / 2),
                                       alone);
    return QImage(reinterpret_cast<const uchar*>(pixels.data()), side, side,
                  QImage::Format_ARGB32_Premultiplied)
        .copy();
}

// A picture on its way, on the thread of the queue: finding out what is to be drawn, and looking for it on
// the disk, would hold up the thread of the window.
struct Drawing {
    Thumbnails::FractalPointer fractal;
    int side = 0; // pixels
    std::shared_ptr<io::ImpatientCache> cache;
    QImage picture;

    // Returns nullopt if there is a picture already, even an empty one.
    std::optional<attractor::RenderRequest> request() {
        if (cache) picture = cache->find(fractal, side);
        if (!picture.isNull()) return std::nullopt;
        if (document::space(*fractal)) {
            keep(pictureInSpace(*fractal, side));
            return std::nullopt;
        }
        const auto box = boxToShow(*fractal);
        if (!box) {
            keep(nothing());
            return std::nullopt;
        }
        attractor::Camera camera;
        camera.width = camera.height = side;
        camera = attractor::fitted(camera, box->min, box->max, shareOfMargin);
        attractor::RenderRequest drawn = document::renderRequest(*fractal, camera);
        drawn.samples = static_cast<std::uint64_t>(side) * side * samplesPerPixel;
        drawn.threads = 1;
        return drawn;
    }

    void keep(const QImage& made) {
        picture = made;
        if (cache) cache->keep(fractal, side, picture);
    }

    void finish(const attractor::Frame& frame) {
        using enum attractor::RenderNote;
        const bool showsNothing = frame.note == NoMaps || frame.note == NoAttractor;
        keep(showsNothing ? nothing() : pictureOf(frame));
    }
};

} // namespace

Thumbnails::Thumbnails(QObject* parent) : QObject(parent), m_pictures(cacheBytes) {
    m_submitTimer.setSingleShot(true);
    m_submitTimer.setInterval(0);
    connect(&m_submitTimer, &QTimer::timeout, this, &Thumbnails::submitNext);
    m_queue = std::make_unique<attractor::RenderQueue>();
}

Thumbnails::~Thumbnails() = default;

void Thumbnails::setSize(int side, qreal devicePixelRatio) {
    if (side == m_side && devicePixelRatio == m_ratio) return;
    m_side = side;
    m_ratio = devicePixelRatio;
    clear();
}

void Thumbnails::setCache(std::unique_ptr<io::ThumbnailCache> cache) {
    m_cache = std::make_shared<io::ImpatientCache>(std::move(cache));
}

int Thumbnails::pixels() const {
    return qRound(m_side * m_ratio);
}

Thumbnail Thumbnails::thumbnail(Key key, const FractalPointer& fractal) {
    if (document::dimension(*fractal) == 0) return {Thumbnail::State::Unreadable, {}};
    Picture* known = m_pictures.object(key);
    if (known && known->fractal != fractal && looksTheSame(*known->fractal, *fractal))
        known->fractal = fractal;
    if (known && known->fractal == fractal) return known->thumbnail;
    if (!isUnderway(key, fractal)) want(key, fractal);
    return {Thumbnail::State::Pending, known ? known->thumbnail.pixmap : QPixmap()};
}

void Thumbnails::clear() {
    for (auto job = m_running.keyBegin(); job != m_running.keyEnd(); ++job)
        m_queue->cancel(*job);
    m_running.clear();
    m_wanted.clear();
    m_pictures.clear();
}

bool Thumbnails::isUnderway(Key key, const FractalPointer& fractal) const {
    return std::any_of(m_running.begin(), m_running.end(), [&](const Wanted& wanted) {
        return wanted.key == key && looksTheSame(*wanted.fractal, *fractal);
    });
}

void Thumbnails::want(Key key, const FractalPointer& fractal) {
    const auto same = std::find_if(m_wanted.begin(), m_wanted.end(),
                                   [key](const Wanted& wanted) { return wanted.key == key; });
    if (same != m_wanted.end())
        m_wanted.erase(same);
    else if (m_wanted.size() >= maxWanted)
        m_wanted.removeFirst();
    m_wanted.append({key, fractal});
    m_submitTimer.start();
}

// Submits the next, the newest first, when everything in sight has been asked for.
void Thumbnails::submitNext() {
    while (!m_wanted.isEmpty() && m_running.size() < maxRunning) {
        const Wanted wanted = m_wanted.takeLast();
        const std::uint64_t job = ++m_lastJob;
        m_running.insert(job, wanted);
        const auto drawing = std::make_shared<Drawing>(Drawing{wanted.fractal, pixels(), m_cache, {}});
        const auto done = [this, job, drawing](const std::shared_ptr<const attractor::Frame>& frame) {
            if (frame) drawing->finish(*frame);
            QMetaObject::invokeMethod(
                this,
                [this, job, drawing, isDrawn = frame != nullptr] {
                    m_drawn += isDrawn ? 1 : 0;
                    take(job, drawing->picture);
                },
                Qt::QueuedConnection);
        };
        m_queue->submit(job, {[drawing] { return drawing->request(); }, done});
    }
}

void Thumbnails::take(std::uint64_t job, const QImage& picture) {
    if (!m_running.contains(job)) return;
    const Wanted wanted = m_running.take(job);
    m_submitTimer.start();
    const Thumbnail thumbnail = toThumbnail(picture);
    const auto bytes = qsizetype{4} * thumbnail.pixmap.width() * thumbnail.pixmap.height() + 256;
    m_pictures.insert(wanted.key, new Picture{wanted.fractal, thumbnail}, bytes);
    emit ready(wanted.key);
}

Thumbnail Thumbnails::toThumbnail(const QImage& picture) const {
    if (picture.width() <= 1) return {Thumbnail::State::NoAttractor, {}};
    return {Thumbnail::State::Ready, roundedPixmap(picture, m_ratio)};
}

QPixmap roundedPixmap(const QImage& picture, qreal devicePixelRatio) {
    QImage rounded(picture.size(), QImage::Format_ARGB32_Premultiplied);
    rounded.fill(Qt::transparent);
    QPainter painter(&rounded);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(picture);
    const double radius = Thumbnails::cornerRadius * devicePixelRatio;
    painter.drawRoundedRect(rounded.rect(), radius, radius);
    painter.end();
    QPixmap pixmap = QPixmap::fromImage(std::move(rounded));
    pixmap.setDevicePixelRatio(devicePixelRatio);
    return pixmap;
}

} // namespace view
