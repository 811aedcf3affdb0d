// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "widgets/background/newest_work.h"

#include <QColor>
#include <QHash>
#include <QImage>
#include <QObject>
#include <QSize>
#include <QTimer>

#include <memory>
#include <vector>

namespace document {
class MapPoints;
}

namespace view {

// Small pictures of the maps that are in sight, drawn in the background: each shows the part of the attractor
// that its map makes. Those of before stay until the new ones are there, and nothing is drawn during a drag.
class MapThumbnails : public QObject {
    Q_OBJECT

public:
    MapThumbnails(document::Document* document, QObject* parent);

    // A change forgets all pictures. `faint` is the colour of the rest of the attractor.
    void setLook(const QSize& size, qreal devicePixelRatio, const QColor& faint);

    // Never waits; null while there is none. A missing picture is then drawn, and ready() follows.
    QImage picture(int row, ifs::MapId map);
    bool isBusy() const { return m_work.isBusy() || m_submit.isActive(); }

signals:
    void ready();

private:
    struct Picture {
        QImage image;
        int generation = -1; // generation of the picture; obsolete if it differs from the present one
    };
    struct Wanted {
        int row = 0;
        ifs::MapId map = ifs::MapId::None;
    };
    struct Made {
        std::shared_ptr<const document::MapPoints> points;
        std::vector<std::pair<ifs::MapId, QImage>> pictures;
        int generation = 0;
    };
    void follow(const document::Change& change);
    void submit();
    void take(std::optional<Made> made);

    document::Document* m_document;
    QSize m_size;
    qreal m_ratio = 1;
    QColor m_faint;
    int m_generation = 0;
    std::shared_ptr<const document::MapPoints> m_points; // points of this generation; null until found
    QHash<ifs::MapId, Picture> m_pictures;
    std::vector<Wanted> m_wanted;
    QTimer m_submit;
    NewestWork<Made> m_work;
};

} // namespace view
