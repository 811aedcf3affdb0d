// SPDX-License-Identifier: MIT
#pragma once

#include "panels/snapshots/snapshots.h"

#include <QElapsedTimer>

#include <functional>

namespace view {

class CanvasView;
class FourViews;
class RenderBridge;

// A look at the marked snapshot in place of the fractal, at the same part of the plane or of space: only the
// picture changes. Nothing of the document does, so there is nothing to undo, to save or to recover; whatever
// edits the document ends the look. docs/decisions/0022-snapshots-are-looks-and-views-are-lines.md.
class SnapshotLook : public QObject {
    Q_OBJECT

public:
    // The canvases that show pictures.
    struct Canvases {
        CanvasView* plane;
        RenderBridge* render;
        FourViews* space;
        std::function<QString()> obstacle; // reason why there can be no look now, as a sentence; empty: none
    };
    SnapshotLook(document::Document* document, Snapshots* snapshots, Canvases canvases,
                 QObject* parent = nullptr);
    ~SnapshotLook() override;

    // Begins or ends a look. If `key` is not null and begins the look, releasing it after it was held down
    // ends it.
    void toggle(Qt::Key key = Qt::Key_unknown);
    void end();
    bool isOn() const { return m_shown != 0; }
    const Snapshot* shown() const; // nullptr while the fractal itself is shown

signals:
    void changed(bool isOn);
    void message(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QString obstacle() const;
    void begin();
    void show();
    void follow(const document::Change& change);

    document::Document* m_document;
    Snapshots* m_snapshots;
    Canvases m_canvases;
    quint64 m_shown = 0; // key of the snapshot; 0: none
    bool m_hadOverlays = true;
    Qt::Key m_key = Qt::Key_unknown;
    QElapsedTimer m_held;     // time since the key was pressed
    QElapsedTimer m_released; // time since the key was released
};

} // namespace view
