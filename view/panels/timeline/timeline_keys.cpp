// SPDX-License-Identifier: MIT
#include "panels/timeline/timeline.h"

#include <algorithm>
#include <utility>

namespace view {

using document::KeyAt;
using document::Track;

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
    edit(Timeline::tr("Key of %1 (frame %2)").arg(m_timeline->rowName(row)).arg(at),
         document::withKey(entry(), track, at, m_timeline->view()));
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
        after = document::withKey(std::move(after), one.track, at, m_timeline->view());
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
    edit(Timeline::tr("Ease of keys"), document::withEase(entry(), m_timeline->selected(), ease));
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
    edit(Timeline::tr("Paste keys"), std::move(pasted.fractal));
    m_timeline->select(std::move(pasted.keys));
}

} // namespace view
