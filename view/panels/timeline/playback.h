// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edits/timeline/animation_edits.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <deque>

namespace view {

// Time that runs: sets the moment of the document by the clock, as much earlier as a picture takes to be
// drawn. Where drawing cannot keep up, frames are left out; time is never late. What is edited meanwhile is
// seen at once.
class Playback : public QObject {
    Q_OBJECT

public:
    explicit Playback(document::Document* document, QObject* parent = nullptr);

    bool isPlaying() const { return m_timer.isActive(); }
    // Plays from the playhead; from the beginning if it is at the end of an animation without a loop.
    void setPlaying(bool playing);
    void seek(int frame); // shows the frame; playback continues from there
    int position() const; // counts both ways: beyond the length on the way back

    // A picture of this animation has come onto the screen.
    void countPicture();
    double picturesPerSecond() const; // average over the last second; 0 before two pictures

signals:
    void playingChanged(bool playing);

private:
    void advance();
    void restart(int frame);
    int untilNext(const document::Timing& timing) const;
    qint64
    // Milliseconds on the clock at which a picture requested now would appear.
    ahead(const document::Timing& timing) const;
    int frames() const; // number of frames in a round

    document::Document* m_document;
    QTimer m_timer;
    QElapsedTimer m_clock; // time since m_from was shown
    int m_from = 0;
    QElapsedTimer m_asked;  // time since the moment whose picture is still missing; else invalid
    double m_toPicture = 0; // recent milliseconds from request to picture
    QElapsedTimer m_pictureClock;
    std::deque<qint64> m_pictures; // times of recent pictures in milliseconds
};

} // namespace view
