// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/timeline/animation_edits.h"
#include "panels/timeline/playback.h"

#include <QColor>
#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace view {

class Timeline;

// Commands for keys of a timeline: the selected ones, or one at the playhead. Every edit is one step of the
// history.
class KeyCommands {
public:
    explicit KeyCommands(Timeline* timeline) : m_timeline(timeline) {}

    void set();           // sets a key in the current track at the playhead
    void setInAll();      // sets keys in all tracks that have keys; if none has, in all tracks
    void toggle(int row); // toggles a key at the playhead
    void remove();        // removes the selected keys, or the current motion
    void move(int by, document::KeyMove how);
    void setEase(const animation::Ease& ease);
    animation::Ease ease() const; // ease of the first selected key
    void copy();
    bool canPaste() const { return !m_copied.empty(); }
    void paste();

private:
    void edit(const QString& text, document::Fractal entry);
    const document::Fractal& entry() const;

    Timeline* m_timeline;
    std::vector<document::CopiedKey> m_copied;
};

// The animation of the current entry as the panel shows it, with its commands. Every edit is one step of the
// history.
class Timeline : public QObject {
    Q_OBJECT

public:
    explicit Timeline(document::Document* document, QObject* parent = nullptr);

    document::Document& document() const { return *m_document; }
    Playback& playback() { return m_playback; }
    // The camera that a new key holds: that of the present view.
    void setCameraSource(std::function<document::SeenCamera()> source) { m_camera = std::move(source); }
    document::SeenCamera camera() const { return m_camera ? m_camera() : std::nullopt; }

    // The axis that is vertical in the view of a system in space.
    void setVerticalSource(std::function<ifs::Vector<3>()> source) { m_vertical = std::move(source); }
    ifs::Vector<3> vertical() const { return m_vertical ? m_vertical() : ifs::Vector<3>::UnitY(); }

    // Rows: all tracks, then all motions.
    const std::vector<document::TrackKeys>& tracks() const { return m_tracks; }
    const std::vector<QString>& motions() const { return m_motions; } // names of the motions
    int rowCount() const { return int(m_tracks.size() + m_motions.size()); }
    bool isTrack(int row) const { return row >= 0 && row < int(m_tracks.size()); }
    QString rowName(int row) const;
    std::optional<QColor> rowColour(int row) const; // colour of a map's row
    bool hasKey(int row, int frame) const;
    bool isEmpty() const; // true if nothing moves
    const document::Timing& timing() const { return m_timing; }
    void setTiming(const QString& text, const document::Timing& timing);

    int row() const { return m_row; }
    void setRow(int row);
    // The playhead, 0 … lastFrame().
    int frame() const;
    int lastFrame() const; // in a cycle the frame before the length, which would repeat frame 0
    void setFrame(int frame);
    void stepToKey(int way); // −1 or +1: previous or next frame with a key in any track

    const std::vector<document::KeyAt>& selected() const { return m_selected; }
    bool isSelected(int row, int frame) const;
    void select(std::vector<document::KeyAt> keys);
    void selectAll();

    KeyCommands& keys() { return m_keys; }

signals:
    void changed();          // sent for rows, keys and timing
    void frameChanged();     // sent for the frame of the playhead
    void selectionChanged(); // sent for selected keys and the current row
    void message(const QString& sentence);

private:
    void follow(const document::Change& change);
    void read();
    void keepSelection();
    QString trackName(const document::Track& track) const;

    document::Document* m_document;
    Playback m_playback;
    std::function<document::SeenCamera()> m_camera;
    std::function<ifs::Vector<3>()> m_vertical;
    std::shared_ptr<const document::Fractal> m_read; // entry of the values that follow
    std::vector<ifs::MapId> m_maps;                  // ids in the order of the entry
    std::vector<document::TrackKeys> m_tracks;
    std::vector<QString> m_motions;
    document::Timing m_timing;
    int m_row = 0;
    int m_wantedRow = 0; // row chosen last, which may be gone and come back with undo
    std::vector<document::KeyAt> m_selected;
    KeyCommands m_keys{this};
};

} // namespace view
