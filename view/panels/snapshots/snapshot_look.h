// SPDX-License-Identifier: MIT
#pragma once

#include "panels/snapshots/snapshots.h"

#include <QElapsedTimer>
#include <QTimer>

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
    // What shows pictures.
    struct Canvases {
        CanvasView* plane;
        RenderBridge* render;
        FourViews* space;
        std::function<QString()> obstacle; // why there can be no look now, as a sentence; empty: nothing
    };
    SnapshotLook(document::Document* document, Snapshots* snapshots, Canvases canvases,
                 QObject* parent = nullptr);
    ~SnapshotLook() override;

    // By this key, if it is not null: a look that it begins ends when it was held down and comes up.
    void toggle(Qt::Key key = Qt::Key_unknown);
    void end();
    bool isOn() const { return m_shown != 0; }
    const Snapshot* shown() const; // nullptr while the fractal itself is

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
    void comeUp();

    document::Document* m_document;
    Snapshots* m_snapshots;
    Canvases m_canvases;
    quint64 m_shown = 0; // the key of the snapshot; 0: none
    bool m_hadOverlays = true;
    Qt::Key m_key = Qt::Key_unknown;
    QElapsedTimer m_held;
    bool m_wasHeld = false;
    QTimer m_released; // runs until it is sure that the key is not just being repeated
};

} // namespace view
