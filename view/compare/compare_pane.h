// SPDX-License-Identifier: MIT
#pragma once

#include "document/tops/partner_document.h"

#include <QPointer>
#include <QWidget>

#include <map>
#include <memory>

class QComboBox;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace view {

class CanvasView;
class RenderBridge;
class SolidBridge;
class SpaceView;

// Another entry of the file in a canvas of its own, beside that of the window: a drag there is a step of the
// same history. On request both show the same place at the same scale.
class ComparePane : public QWidget {
    Q_OBJECT

public:
    // `plane` and `space`: those of the window.
    ComparePane(document::Document* document, const RenderBridge* render, CanvasView* plane, SpaceView* space,
                QWidget* parent = nullptr);
    ~ComparePane() override;

    void setCompared(bool compared); // shows or hides the pane
    bool isCompared() const { return m_isCompared; }
    document::EntryId entry() const; // None: no other entry
    void setEntry(document::EntryId entry);
    bool areViewsLinked() const;
    void setViewsLinked(bool linked);
    bool cancelGesture(); // false if there was none
    // Options as in the canvases of the window:
    void setAllowsNoAttractor(bool allows);
    void setTrackball(bool on);

    // nullptr before it was shown for the first time:
    CanvasView* plane() const { return m_otherPlane; }
    SpaceView* space() const { return m_otherSpace; }

signals:
    void created(CanvasView* plane); // sent before the canvas is first shown
    void message(const QString& sentence);
    void closeRequested();

private:
    void create();
    void createHeader();
    void followTools();
    void followViews();
    void follow(const document::Change& change);
    void refresh();
    void keepTurn(document::EntryId entry, const CanvasView& canvas);
    void turn(CanvasView& canvas, const document::Document& document);
    void changeTo(document::EntryId entry);
    void showEntry();
    document::EntryId likelyEntry() const;
    bool canLink() const; // true if both entries have the same dimension
    void standAlike();    // gives both views in space the same upward axis
    // Makes the canvas at `to` follow the view of the other.
    void linkPlanes(CanvasView* from, CanvasView* to);
    void linkSpaces(SpaceView* from, SpaceView* to);

    QPointer<document::Document> m_document; // may be destroyed before the pane
    const RenderBridge* m_render;
    CanvasView* m_plane;
    SpaceView* m_space;
    bool m_isCompared = false;
    bool m_isLinking = false;
    bool m_allowsNoAttractor = false;
    bool m_isTrackball = false;
    document::EntryId m_lastCurrent = document::EntryId::None;

    // Members made when they are shown for the first time:
    std::unique_ptr<document::PartnerDocument> m_partner;
    RenderBridge* m_otherRender = nullptr;
    SolidBridge* m_otherSolid = nullptr;
    CanvasView* m_otherPlane = nullptr;
    SpaceView* m_otherSpace = nullptr;
    QComboBox* m_entries = nullptr;
    QToolButton* m_link = nullptr;
    QLabel* m_nothing = nullptr;
    QStackedWidget* m_views = nullptr;

    std::map<document::EntryId, double> m_turns; // rotations of the views of entries, in radians
};

} // namespace view
