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
    void seek(int frame); // goes on from there if it plays, and shows it
    int position() const; // counts back and forth: beyond the length on the way back

    // A picture of this animation has come onto the screen.
    void countPicture();
    double picturesPerSecond() const; // of the last second; 0 before two of them

signals:
    void playingChanged(bool playing);

private:
    void advance();
    void restart(int frame);
    int untilNext(const document::Timing& timing) const;
    qint64
    ahead(const document::Timing& timing) const; // on the clock, when a picture asked for would be there
    int frames() const;                          // until it begins anew

    document::Document* m_document;
    QTimer m_timer;
    QElapsedTimer m_clock; // since m_from was shown
    int m_from = 0;
    QElapsedTimer m_asked;  // since a moment was set whose picture has not come yet; else invalid
    double m_toPicture = 0; // milliseconds, of late
    QElapsedTimer m_pictureClock;
    std::deque<qint64> m_pictures; // when they came, in milliseconds
};

} // namespace view
