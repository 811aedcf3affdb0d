// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "widgets/background/newest_work.h"

#include <QElapsedTimer>
#include <QImage>
#include <QList>
#include <QObject>
#include <QPixmap>
#include <QTimer>

#include <memory>

namespace io {
class FramePreviews;
}

namespace view {

// A small picture of an entry with an animation, which plays again and again. Its frames are drawn in the
// background and kept while it plays; where drawing is too slow, it plays slower.
class MovingPicture : public QObject {
    Q_OBJECT

public:
    using FractalPointer = std::shared_ptr<const document::Fractal>;

    explicit MovingPicture(QObject* parent = nullptr);
    ~MovingPicture() override;

    // Plays from the beginning, in device-independent pixels. An entry without an animation stops it.
    void play(const FractalPointer& fractal, int side, qreal devicePixelRatio);
    void stop();
    bool isPlaying() const { return m_previews != nullptr; }

signals:
    void shown(const QPixmap& frame); // square picture with rounded corners

private:
    void drawNext();
    void take(const std::optional<QImage>& image);
    void step();

    std::shared_ptr<io::FramePreviews> m_previews; // null: not playing
    int m_side = 0;
    qreal m_ratio = 1;
    QList<int> m_numbers;    // numbers of the frames to show
    QList<QPixmap> m_frames; // frames drawn so far, from the first on
    qsizetype m_next = 0;    // index of the next frame to show
    QTimer m_clock;
    NewestWork<QImage> m_drawing;
};

} // namespace view
