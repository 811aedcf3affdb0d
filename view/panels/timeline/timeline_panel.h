// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/attractor_watch.h"
#include "panels/timeline/timeline.h"

#include <QWidget>

#include <functional>
#include <stop_token>

class QMenu;
class QLabel;
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
    void showTracks(); // even while nothing moves

signals:
    void message(const QString& sentence);

private:
    using Make =
        std::function<std::optional<document::Fractal>(const document::Fractal&, const std::stop_token&)>;

    void createMotions();
    QAction* addMotion(const char* icon, const QString& name, const QString& tip);
    void addWinds();
    void listEntries();
    std::optional<document::Fractal> morphToNext() const;
    void apply(const QString& text, const Make& make, const QString& failure);
    void zoomEndlessly();
    void morphTo(document::EntryId id);
    void choosePairs();
    void addMorph(document::Fractal morph, const QString& name);
    void follow();

    document::Document* m_document;
    void watch(const document::Change& change);
    void showLost();
    Timeline m_timeline;
    QList<QAction*> m_actions;
    std::vector<Make> m_makes; // of each of them
    AttractorWatch m_watch;
    QMenu* m_motions;
    QMenu* m_winds;
    QMenu* m_entries;
    TransportBar* m_transport = nullptr;
    TrackView* m_tracks = nullptr;
    MotionPage* m_page = nullptr;
    QStackedWidget* m_pages = nullptr;
    bool m_wantsTracks = false;
    QLabel* m_lost = nullptr; // says when the attractor is
};

} // namespace view
