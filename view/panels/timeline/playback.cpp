// SPDX-License-Identifier: MIT
#include "panels/timeline/playback.h"

#include <algorithm>

namespace view {

namespace {

constexpr qint64 shortestTick = 1, longestTick = 1000; // milliseconds
constexpr qint64 second = 1000;
constexpr double ofTheLatest = 0.25; // weight of the newest picture in the average

} // namespace

Playback::Playback(document::Document* document, QObject* parent) : QObject(parent), m_document(document) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_pictureClock.start();
    connect(&m_timer, &QTimer::timeout, this, &Playback::advance);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        if (!isPlaying()) return;
        const bool isMovedOtherwise = change.parts & Change::Animation;
        const bool stands = isMovedOtherwise && !document::animationFacts(m_document->entryFractal());
        if (stands || change.parts & (Change::Current | Change::File))
            setPlaying(false);
        else if (isMovedOtherwise)
            restart(position()); // possibly at another rate
    });
}

int Playback::position() const {
    const animation::Moment& moment = m_document->moment();
    return int(moment.numerator / moment.denominator);
}

int Playback::frames() const {
    const document::Timing timing = document::timingOf(m_document->entryFractal());
    return animation::frameCount(timing.loop, timing.length);
}

void Playback::setPlaying(bool playing) {
    if (playing == isPlaying()) return;
    if (playing) {
        m_pictures.clear();
        restart(position() >= frames() - 1 ? 0 : position());
    } else {
        m_timer.stop();
        m_document->setMoment(m_document->moment()); // full refinement
    }
    emit playingChanged(playing);
}

void Playback::seek(int frame) {
    if (isPlaying())
        restart(frame);
    else
        m_document->setMoment(animation::moment(frame));
}

void Playback::restart(int frame) {
    const document::Timing timing = document::timingOf(m_document->entryFractal());
    m_from = frame;
    m_asked.invalidate();
    m_clock.start();
    m_timer.start(untilNext(timing));
    m_document->setMoment(animation::moment(frame), document::Document::Pace::Running);
}

void Playback::advance() {
    const document::Timing timing = document::timingOf(m_document->entryFractal());
    const qint64 passed = ahead(timing) * timing.rate.frames / (second * timing.rate.seconds); // frames
    const qint64 count = frames();
    const qint64 frame = m_from + passed;
    if (timing.loop == animation::Loop::Off && frame >= count - 1) {
        m_timer.stop();
        m_document->setMoment(animation::moment(count - 1), document::Document::Pace::Rest);
        emit playingChanged(false);
        return;
    }
    const animation::Moment moment = animation::moment(frame % count);
    if (!(moment == m_document->moment())) m_asked.start();
    m_document->setMoment(moment, document::Document::Pace::Running);
    m_timer.setInterval(untilNext(timing)); // does not start a stopped timer
}

// Milliseconds; again before it is due where that is long from now.
int Playback::untilNext(const document::Timing& timing) const {
    const qint64 now = ahead(timing), period = second * timing.rate.seconds;
    const qint64 next = now * timing.rate.frames / period + 1;
    const qint64 due = (next * period + timing.rate.frames - 1) / timing.rate.frames;
    return int(std::clamp(due - now, shortestTick, longestTick));
}

// Lead of at most half a frame, so that a frame that takes long does not make the next come far too early.
qint64 Playback::ahead(const document::Timing& timing) const {
    const double most = 0.5 * double(second * timing.rate.seconds) / timing.rate.frames;
    return m_clock.elapsed() + qint64(std::min(m_toPicture, most));
}

void Playback::countPicture() {
    if (!isPlaying()) return;
    if (m_asked.isValid()) {
        m_toPicture += ofTheLatest * (double(m_asked.elapsed()) - m_toPicture);
        m_asked.invalidate();
    }
    const qint64 now = m_pictureClock.elapsed();
    m_pictures.push_back(now);
    while (now - m_pictures.front() > second)
        m_pictures.pop_front();
}

double Playback::picturesPerSecond() const {
    if (m_pictures.size() < 2) return 0;
    const qint64 span = m_pictures.back() - m_pictures.front();
    return span > 0 ? double(second) * double(m_pictures.size() - 1) / double(span) : 0;
}

} // namespace view
