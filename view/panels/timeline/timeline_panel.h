// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/attractor_watch.h"
#include "panels/timeline/timeline.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <stop_token>

class QLabel;
class QMenu;
class QStackedWidget;

namespace view {

class MotionPage;
class TrackView;
class TransportBar;

// The animation of the current entry: transport, and below it the tracks or, while nothing moves, motions to
// choose from.
class TimelinePanel : public QWidget {
    Q_OBJECT

public:
    explicit TimelinePanel(document::Document* document, QWidget* parent = nullptr);

    Timeline& timeline() { return m_timeline; }
    TrackView* trackView() const { return m_tracks; }
    TransportBar* transport() const { return m_transport; }
    const QList<QAction*>& motions() const { return m_actions; }
    QMenu* motionMenu() const { return m_motions; }
    bool showsTracks() const;
    void showTracks(); // shows the tracks even if nothing moves

signals:
    void motionAdded();
    void message(const QString& sentence);

private:
    using Make =
        std::function<std::optional<document::Fractal>(const document::Fractal&, const std::stop_token&)>;

    void createMotions();
    QAction* addMotion(const char* icon, const QString& name, const QString& tip);
    void addWinds();
    void listEntries();
    std::optional<document::Fractal> morphToNext() const;
    std::optional<document::Fractal> zoomOfEntry();
    void apply(const QString& text, const Make& make, const QString& failure);
    void orbit();
    void zoomEndlessly();
    void takeZoom(std::optional<document::Fractal> zoom);
    void offerZoom();
    void morphTo(document::EntryId id);
    void choosePairs();
    void addMorph(document::Fractal morph, const QString& name);
    void follow();
    void watch(const document::Change& change);
    void showLost();

    document::Document* m_document;
    Timeline m_timeline;
    AttractorWatch m_watch;
    QList<QAction*> m_actions;
    std::vector<Make> m_makes; // one for each action
    QAction* m_zoomAction = nullptr;
    QMenu* m_motions;
    QMenu* m_winds;
    QMenu* m_entries;
    TransportBar* m_transport = nullptr;
    TrackView* m_tracks = nullptr;
    MotionPage* m_page = nullptr;
    QLabel* m_lost = nullptr; // message with the frame that has no attractor
    QStackedWidget* m_pages = nullptr;
    bool m_wantsTracks = false;
    std::shared_ptr<const document::Fractal> m_zoomed; // entry for which the endless zoom is searched
    std::optional<document::Fractal> m_zoom;           // zoom, once found
    bool m_cannotZoom = false;                         // true if the search found none
    NewestWork<document::Fractal> m_zooming;           // last member: its thread uses the others
};

} // namespace view
