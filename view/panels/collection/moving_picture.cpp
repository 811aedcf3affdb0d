// SPDX-License-Identifier: MIT
#include "panels/collection/moving_picture.h"

#include "document/moments/animated_fractal.h"
#include "io/animation/animation_export.h"
#include "widgets/thumbnails.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace view {

namespace {

constexpr int mostFrames = 96; // 10 MB for 168 pixels
constexpr double framesPerSecond = 12;

} // namespace

MovingPicture::MovingPicture(QObject* parent)
    : QObject(parent), m_drawing([this](const std::optional<QImage>& image) { take(image); }) {
    connect(&m_clock, &QTimer::timeout, this, &MovingPicture::step);
}

MovingPicture::~MovingPicture() = default;

void MovingPicture::play(const FractalPointer& fractal, int side, qreal devicePixelRatio) {
    stop();
    const auto facts = document::animationFacts(*fractal);
    if (!facts || facts->length < 2) return;
    const double seconds = double(facts->length) * facts->rate.seconds / facts->rate.frames;
    const int count = std::clamp(int(seconds * framesPerSecond), 2, std::min(mostFrames, facts->length));
    for (int i = 0; i < count; ++i)
        m_numbers << int(std::int64_t(i) * facts->length / count);
    m_side = side;
    m_ratio = devicePixelRatio;
    const int pixels = qRound(side * devicePixelRatio);
    io::AnimationExport what;
    what.entry = *fractal;
    what.last = facts->length - 1;
    m_previews = std::make_shared<io::FramePreviews>(std::move(what), QSize(pixels, pixels));
    m_clock.start(int(1000 * seconds / count));
    drawNext();
}

void MovingPicture::stop() {
    m_drawing.cancel();
    m_clock.stop();
    m_previews.reset();
    m_numbers.clear();
    m_frames.clear();
    m_next = 0;
}

void MovingPicture::drawNext() {
    m_drawing.submit([previews = m_previews, frame = m_numbers[m_frames.size()]](
                         const std::stop_token& stop) { return previews->draw(frame, stop); });
}

void MovingPicture::take(const std::optional<QImage>& image) {
    if (!isPlaying()) return;
    if (!image) return stop(); // nothing to show, or no memory
    m_frames << roundedPixmap(*image, m_ratio);
    if (m_frames.size() < m_numbers.size()) drawNext();
}

void MovingPicture::step() {
    if (m_next >= m_frames.size()) return; // still being drawn
    emit shown(m_frames[m_next]);
    m_next = (m_next + 1) % m_numbers.size();
}

} // namespace view
