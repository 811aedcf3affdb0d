// SPDX-License-Identifier: MIT
#include "panels/timeline/timeline.h"

#include "attractor/request/appearance.h"
#include "document/fractal/recurring_branches.h"
#include "document/moments/animated_fractal.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

namespace view {

using document::KeyAt;
using document::Track;

namespace {

constexpr std::size_t manyMaps = 500; // more rows than anybody looks through

struct MotionName {
    QString operator()(const auto& motion) const { return name(motion); }

    template <int Dim> static QString name(const animation::Sway<Dim>&) { return Timeline::tr("Wind"); }
    template <int Dim> static QString name(const animation::Turn<Dim>&) { return Timeline::tr("Turn"); }
    template <int Dim> static QString name(const animation::Orbit<Dim>&) { return Timeline::tr("Orbit"); }
    template <int Dim> static QString name(const animation::Breathe<Dim>&) { return Timeline::tr("Breathe"); }
    static QString name(const animation::PaletteCycle&) { return Timeline::tr("Palette Cycle"); }
};

template <int Dim> std::vector<QString> motionNames(const document::Shape<Dim>* shape) {
    std::vector<QString> names;
    if (shape && shape->animation)
        for (const auto& motion : shape->animation->motions)
            names.push_back(std::visit(MotionName(), motion));
    return names;
}

std::vector<ifs::MapId> mapIds(const document::Fractal& fractal) {
    std::vector<ifs::MapId> ids;
    const auto add = [&](const auto* system) {
        if (system)
            for (const auto& map : system->maps)
                ids.push_back(map.id);
    };
    add(document::system2(fractal));
    add(document::system3(fractal));
    return ids;
}

} // namespace

Timeline::Timeline(document::Document* document, QObject* parent)
    : QObject(parent), m_document(document), m_playback(document) {
    connect(document, &document::Document::changed, this, &Timeline::follow);
    read();
}

void Timeline::follow(const document::Change& change) {
    using document::Change;
    const bool isAnother = change.parts & (Change::Current | Change::File);
    if (isAnother) {
        m_row = m_wantedRow = 0;
        m_selected.clear();
    }
    // Only keys can change the rows during a drag or playback.
    const bool movesOnly = change.live || change.parts & Change::Time;
    if (isAnother || change.parts & (Change::Animation | Change::Entries) ||
        (!movesOnly && change.parts & (Change::System | Change::Cage | Change::Appearance))) {
        read();
        emit changed();
    }
    if (isAnother || change.parts & (Change::Time | Change::Animation)) emit frameChanged();
}

void Timeline::read() {
    const auto before = std::exchange(m_read, m_document->currentEntry().fractal);
    const document::Fractal& entry = *m_read;
    if (before && document::areTracksAlike(*before, entry)) return; // avoids a slow new list for 50 000 maps
    m_maps = mapIds(entry);
    m_tracks = document::tracksOf(entry);
    if (m_tracks.size() > manyMaps)
        std::erase_if(m_tracks, [](const document::TrackKeys& one) {
            return one.track.kind == Track::Kind::Map && one.keys.empty();
        });
    m_motions = motionNames(document::plane(entry));
    if (m_motions.empty()) m_motions = motionNames(document::space(entry));
    m_timing = document::timingOf(entry);
    m_row = std::clamp(m_wantedRow, 0, std::max(0, rowCount() - 1));
    keepSelection();
}

void Timeline::keepSelection() {
    std::erase_if(m_selected, [this](const KeyAt& key) {
        const auto track = std::ranges::find(m_tracks, key.track, &document::TrackKeys::track);
        return track == m_tracks.end() ||
               std::ranges::find(track->keys, key.frame, &document::TrackKeys::Key::frame) ==
                   track->keys.end();
    });
}

QString Timeline::trackName(const Track& track) const {
    const auto number = [this](ifs::MapId id) {
        return QString::number(std::ranges::find(m_maps, id) - m_maps.begin() + 1);
    };
    switch (track.kind) {
    case Track::Kind::Cage:
        return tr("Cage");
    case Track::Kind::Map:
        return tr("Map %1").arg(number(track.maps.front()));
    case Track::Kind::Branch: {
        QStringList numbers;
        for (const ifs::MapId id : std::span(track.maps).subspan(document::recurs(track.maps) ? 1 : 0))
            numbers << number(id);
        return (document::recurs(track.maps) ? tr("Branch %1, inside itself") : tr("Branch %1"))
            .arg(numbers.join(u' '));
    }
    case Track::Kind::Look:
        return tr("Appearance");
    case Track::Kind::Camera:
        break;
    }
    return tr("Camera");
}

QString Timeline::rowName(int row) const {
    return isTrack(row) ? trackName(m_tracks[std::size_t(row)].track)
                        : m_motions[std::size_t(row) - m_tracks.size()];
}

std::optional<QColor> Timeline::rowColour(int row) const {
    if (!isTrack(row) || m_tracks[std::size_t(row)].track.kind != Track::Kind::Map) return std::nullopt;
    const ifs::MapId id = m_tracks[std::size_t(row)].track.maps.front();
    const auto colour = attractor::mapColour(m_document->entryFractal().appearance, id,
                                             std::size_t(std::ranges::find(m_maps, id) - m_maps.begin()));
    return QColor(colour.red, colour.green, colour.blue);
}

bool Timeline::hasKey(int row, int frame) const {
    return isTrack(row) && std::ranges::any_of(m_tracks[std::size_t(row)].keys,
                                               [&](const auto& key) { return key.frame == frame; });
}

bool Timeline::isEmpty() const {
    return m_motions.empty() &&
           std::ranges::all_of(m_tracks, [](const auto& one) { return one.keys.empty(); });
}

void Timeline::setTiming(const QString& text, const document::Timing& timing) {
    if (timing == m_timing || rowCount() == 0) return;
    const auto keyCount = [this] {
        std::size_t count = 0;
        for (const document::TrackKeys& one : m_tracks)
            count += one.keys.size();
        return count;
    };
    const int before = frame();
    const std::size_t keysBefore = keyCount();
    m_document->editEntry(text, document::withTiming(m_document->entryFractal(), timing));
    if (before > lastFrame()) setFrame(lastFrame());
    if (const std::size_t keysLeft = keyCount(); keysLeft < keysBefore)
        emit message(tr("%n key(s) beyond the new end deleted. Undo brings them back.", nullptr,
                        int(keysBefore - keysLeft)));
}

void Timeline::setRow(int row) {
    row = std::clamp(row, 0, std::max(0, rowCount() - 1));
    m_wantedRow = row;
    if (row == m_row) return;
    m_row = row;
    emit selectionChanged();
}

int Timeline::frame() const {
    const animation::Moment at = animation::folded(m_document->moment(), m_timing.loop, m_timing.length);
    return int(at.numerator / at.denominator);
}

int Timeline::lastFrame() const {
    return m_timing.loop == animation::Loop::Cycle ? std::max(0, m_timing.length - 1) : m_timing.length;
}

void Timeline::setFrame(int frame) {
    m_playback.seek(std::clamp(frame, 0, lastFrame()));
}

void Timeline::stepToKey(int way) {
    std::set<int> frames{0, lastFrame()};
    for (const auto& track : m_tracks)
        for (const auto& key : track.keys)
            if (key.frame <= lastFrame()) frames.insert(key.frame);
    const auto next = way > 0 ? frames.upper_bound(frame()) : frames.lower_bound(frame());
    if (way > 0 && next != frames.end()) setFrame(*next);
    if (way < 0 && next != frames.begin()) setFrame(*std::prev(next));
}

bool Timeline::isSelected(int row, int frame) const {
    return isTrack(row) &&
           std::ranges::find(m_selected, KeyAt{m_tracks[std::size_t(row)].track, frame}) != m_selected.end();
}

void Timeline::select(std::vector<KeyAt> keys) {
    if (keys == m_selected) return;
    m_selected = std::move(keys);
    keepSelection();
    emit selectionChanged();
}

void Timeline::selectAll() {
    std::vector<KeyAt> all;
    for (const auto& one : m_tracks)
        for (const auto& key : one.keys)
            all.push_back({one.track, key.frame});
    select(std::move(all));
}

void KeyCommands::edit(const QString& text, document::Fractal entry) {
    m_timeline->document().editEntry(text, std::move(entry));
}

const document::Fractal& KeyCommands::entry() const {
    return m_timeline->document().entryFractal();
}

void KeyCommands::set() {
    const int row = m_timeline->row();
    if (!m_timeline->isTrack(row))
        return emit m_timeline->message(Timeline::tr("Motions need no keys. Select a track first."));
    const Track track = m_timeline->tracks()[std::size_t(row)].track;
    const int at = m_timeline->frame();
    edit(Timeline::tr("Key of %1 (frame %2)").arg(m_timeline->rowName(row), QString::number(at)),
         document::withKey(entry(), track, at, m_timeline->camera()));
    m_timeline->select({{track, at}});
}

void KeyCommands::setInAll() {
    const auto& tracks = m_timeline->tracks();
    const bool none = std::ranges::all_of(tracks, [](const auto& one) { return one.keys.empty(); });
    document::Fractal after = entry();
    const int at = m_timeline->frame();
    std::vector<KeyAt> made;
    for (const auto& one : tracks) {
        if (one.keys.empty() && !none) continue;
        after = document::withKey(std::move(after), one.track, at, m_timeline->camera());
        made.push_back({one.track, at});
    }
    if (made.empty()) return;
    edit(Timeline::tr("Keys of all tracks (frame %1)").arg(at), std::move(after));
    m_timeline->select(std::move(made));
}

void KeyCommands::toggle(int row) {
    m_timeline->setRow(row);
    const int at = m_timeline->frame();
    if (!m_timeline->hasKey(row, at)) return set();
    m_timeline->select({{m_timeline->tracks()[std::size_t(row)].track, at}});
    remove();
}

void KeyCommands::remove() {
    const int row = m_timeline->row();
    if (!m_timeline->selected().empty())
        edit(Timeline::tr("Delete keys"), document::withoutKeys(entry(), m_timeline->selected()));
    else if (row < m_timeline->rowCount() && !m_timeline->isTrack(row))
        edit(Timeline::tr("Delete the motion “%1”").arg(m_timeline->rowName(row)),
             document::withoutMotion(entry(), std::size_t(row) - m_timeline->tracks().size()));
}

void KeyCommands::move(int by, document::KeyMove how) {
    std::vector<KeyAt> moved = m_timeline->selected();
    by = document::possibleMove(entry(), moved, by, how);
    if (by == 0) return;
    const QString text = how == document::KeyMove::Copy     ? Timeline::tr("Copy keys")
                         : how == document::KeyMove::Ripple ? Timeline::tr("Move keys and all later ones")
                                                            : Timeline::tr("Move keys");
    document::Fractal after = document::withKeysMoved(entry(), moved, by, how);
    for (KeyAt& key : moved)
        key.frame += by;
    edit(text, std::move(after));
    m_timeline->select(std::move(moved));
}

void KeyCommands::setEase(const animation::Ease& ease) {
    const std::vector<KeyAt>& keys = m_timeline->selected();
    if (keys.empty()) return;
    const auto [first, last] = std::ranges::minmax(keys, {}, &KeyAt::frame);
    const QString text = first.frame == last.frame
                             ? Timeline::tr("Ease of keys (frame %1)").arg(first.frame)
                             : Timeline::tr("Ease of keys (frames %1–%2)").arg(first.frame).arg(last.frame);
    edit(text, document::withEase(entry(), keys, ease));
}

animation::Ease KeyCommands::ease() const {
    for (const document::TrackKeys& one : m_timeline->tracks())
        for (const auto& key : one.keys)
            if (std::ranges::find(m_timeline->selected(), KeyAt{one.track, key.frame}) !=
                m_timeline->selected().end())
                return key.ease;
    return {};
}

void KeyCommands::copy() {
    if (!m_timeline->selected().empty()) m_copied = document::copiedKeys(entry(), m_timeline->selected());
}

void KeyCommands::paste() {
    if (!canPaste()) return;
    document::Pasted pasted = document::withKeysPasted(entry(), m_copied, m_timeline->frame());
    if (pasted.keys.empty())
        return emit m_timeline->message(Timeline::tr("None of these keys fits this fractal."));
    const int leftOut = int(m_copied.size() - pasted.keys.size());
    edit(Timeline::tr("Paste keys"), std::move(pasted.fractal));
    m_timeline->select(std::move(pasted.keys));
    if (leftOut > 0)
        emit m_timeline->message(
            Timeline::tr("%n key(s) not pasted: beyond the end of the animation, or of a "
                         "part that this fractal does not have.",
                         nullptr, leftOut));
}

} // namespace view
