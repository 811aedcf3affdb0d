// SPDX-License-Identifier: MIT
#include "panels/maps/map_thumbnails.h"

#include "document/maps/map_points.h"

#include <QtMath>

#include <utility>

namespace view {

namespace {

constexpr qsizetype maxKept = 2000;
constexpr std::size_t maxAtOnce = 200;

attractor::Rgba rgbaOf(const QColor& colour) {
    const auto channel = [](int value) { return static_cast<std::uint8_t>(value); };
    return {channel(colour.red()), channel(colour.green()), channel(colour.blue()), channel(colour.alpha())};
}

} // namespace

MapThumbnails::MapThumbnails(document::Document* document, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_work([this](std::optional<Made> made) { take(std::move(made)); }) {
    m_submit.setSingleShot(true);
    m_submit.setInterval(0);
    connect(&m_submit, &QTimer::timeout, this, &MapThumbnails::submit);
    connect(document, &document::Document::changed, this, &MapThumbnails::follow);
}

void MapThumbnails::setLook(const QSize& size, qreal devicePixelRatio, const QColor& faint) {
    if (size == m_size && devicePixelRatio == m_ratio && faint == m_faint) return;
    m_size = size;
    m_ratio = devicePixelRatio;
    m_faint = faint;
    ++m_generation;
    m_points.reset();
    m_pictures.clear();
}

void MapThumbnails::follow(const document::Change& change) {
    using document::Change;
    if (change.live || !(change.parts & (Change::System | Change::Cage | Change::Appearance |
                                         Change::Current | Change::File)))
        return;
    ++m_generation;
    m_points.reset();
    m_wanted.clear();
    if (change.parts & (Change::Current | Change::File)) m_pictures.clear(); // pictures of other maps
    emit ready(); // visible ones are requested again
}

QImage MapThumbnails::picture(int row, ifs::MapId map) {
    if (m_size.isEmpty()) return {};
    if (m_pictures.size() > maxKept) m_pictures.clear();
    Picture& known = m_pictures[map];
    if (known.generation != m_generation) {
        known.generation = m_generation; // requested once
        m_wanted.push_back({row, map});
        if (!m_submit.isActive() && !m_work.isBusy()) m_submit.start();
    }
    return known.image;
}

void MapThumbnails::submit() {
    if (m_wanted.empty() || m_work.isBusy()) return;
    if (m_wanted.size() > maxAtOnce) { // those scrolled past are requested again when they come back
        const auto passed = m_wanted.end() - std::ptrdiff_t(maxAtOnce);
        for (auto wanted = m_wanted.begin(); wanted != passed; ++wanted)
            m_pictures[wanted->map].generation = -1;
        m_wanted.erase(m_wanted.begin(), passed);
    }
    const QSize pixels(qCeil(m_size.width() * m_ratio), qCeil(m_size.height() * m_ratio));
    m_work.submit([wanted = std::exchange(m_wanted, {}), known = m_points, pixels, faint = rgbaOf(m_faint),
                   fractal = m_document->sharedFractal(),
                   generation = m_generation](const std::stop_token& stop) -> std::optional<Made> {
        Made made{known, {}, generation};
        if (!made.points)
            made.points =
                std::make_shared<const document::MapPoints>(*fractal, pixels.width(), pixels.height());
        for (const Wanted& one : wanted) {
            if (stop.stop_requested()) return std::nullopt;
            made.pictures.emplace_back(one.map, made.points->picture(std::size_t(one.row), faint));
        }
        return made;
    });
}

void MapThumbnails::take(std::optional<Made> made) {
    if (made && made->generation == m_generation) {
        m_points = made->points;
        for (auto& [map, image] : made->pictures) {
            image.setDevicePixelRatio(m_ratio);
            m_pictures[map].image = image;
        }
    }
    emit ready();
    if (!m_wanted.empty()) m_submit.start();
}

} // namespace view
