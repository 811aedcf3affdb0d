// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/names.h"

#include <QString>
#include <Qt>

#include <array>
#include <cstddef>

class QDockWidget;

// Panels in the order in which a window makes them.
enum class Panel {
    Entries,
    Collection,
    Maps,
    Cage,
    Appearance,
    Analysis,
    History,
    Collage,
    Links,
    Exports,
    Problems,
    Timeline,
    Lesson,
    Snapshots,
};

// The object names of the panels, which stored layouts and lessons hold.
template <>
inline constexpr auto ifs::names<Panel> = std::to_array<ifs::Named<Panel>>({
    {Panel::Entries, "entries"},
    {Panel::Collection, "collection"},
    {Panel::Maps, "maps"},
    {Panel::Cage, "cage"},
    {Panel::Appearance, "appearance"},
    {Panel::Analysis, "analysis"},
    {Panel::History, "history"},
    {Panel::Collage, "collage"},
    {Panel::Links, "links"},
    {Panel::Exports, "exports"},
    {Panel::Problems, "problems"},
    {Panel::Timeline, "timeline"},
    {Panel::Lesson, "lesson"},
    {Panel::Snapshots, "snapshots"},
});

// Facts about a panel that a window needs besides its content.
struct PanelFacts {
    Qt::DockWidgetArea area;
    QString title;
    QString whatsThis;
};
PanelFacts factsOf(Panel panel);

// The panels of a window.
class Panels {
public:
    void add(Panel panel, QDockWidget* dock) { m_docks[std::size_t(panel)] = dock; }
    QDockWidget* dock(Panel panel) const { return m_docks[std::size_t(panel)]; } // null before it is made
    void show(Panel panel) const; // brings the panel to the front of its tabs

private:
    std::array<QDockWidget*, ifs::names<Panel>.size()> m_docks{};
};
