// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "document/fractal/fractal.h"

#include <QCache>
#include <QHash>
#include <QImage>
#include <QList>
#include <QObject>
#include <QPixmap>
#include <QTimer>

#include <cstdint>
#include <memory>

namespace attractor {
class RenderQueue;
}
namespace io {
class ImpatientCache;
class ThumbnailCache;
} // namespace io

namespace view {

// The picture of a fractal in a list, or why there is none.
struct Thumbnail {
    enum class State {
        Pending,     // requested; the pixmap may show an earlier value
        Ready,       // the pixmap shows the fractal
        NoAttractor, // nothing to draw
        Unreadable,  // the entry could not be read
    };
    State state = State::Pending;
    QPixmap pixmap; // square with rounded corners; null if there is none
};

// Small square pictures of fractals, drawn one after the other by a render queue and kept until newer ones
// need the room. What was asked for last is drawn first, so that the rows in sight come before those scrolled
// past.
class Thumbnails : public QObject {
    Q_OBJECT

public:
    using Key = quint64; // chosen by the caller; one picture is kept for each key
    using FractalPointer = std::shared_ptr<const document::Fractal>;

    static constexpr qreal cornerRadius = 4; // device-independent pixels

    explicit Thumbnails(QObject* parent = nullptr);
    ~Thumbnails() override;

    // Side of the pictures in device-independent pixels. A change forgets all pictures.
    void setSize(int side, qreal devicePixelRatio);
    int side() const { return m_side; }

    // Pictures are looked for there before they are drawn, and kept there.
    void setCache(std::unique_ptr<io::ThumbnailCache> cache);

    // Never waits. If the picture of `fractal` is missing it is requested, and ready(key) follows.
    Thumbnail thumbnail(Key key, const FractalPointer& fractal);
    void clear(); // drops pictures and requests, for instance when keys change their meaning

    std::uint64_t drawn() const { return m_drawn; } // number of pictures that were not found in the cache
    int pending() const { return static_cast<int>(m_wanted.size() + m_running.size()); }

signals:
    void ready(quint64 key);

private:
    struct Wanted {
        Key key = 0;
        FractalPointer fractal;
    };
    struct Picture {
        FractalPointer fractal;
        Thumbnail thumbnail;
    };

    bool isUnderway(Key key, const FractalPointer& fractal) const;
    void want(Key key, const FractalPointer& fractal);
    void submitNext();
    void take(std::uint64_t job, const QImage& picture);
    Thumbnail toThumbnail(const QImage& picture) const;
    int pixels() const; // side of a picture

    int m_side = 48;
    qreal m_ratio = 1;
    QCache<Key, Picture> m_pictures; // cost in bytes
    QList<Wanted> m_wanted;          // newest last
    QHash<std::uint64_t, Wanted> m_running;
    std::uint64_t m_lastJob = 0;
    std::uint64_t m_drawn = 0;
    QTimer m_submitTimer;
    std::shared_ptr<io::ImpatientCache> m_cache;     // may be null; used in the thread of the queue
    std::unique_ptr<attractor::RenderQueue> m_queue; // last member: its thread uses the others
};

// The picture with rounded corners, as thumbnails are shown.
QPixmap roundedPixmap(const QImage& picture, qreal devicePixelRatio);

} // namespace view
