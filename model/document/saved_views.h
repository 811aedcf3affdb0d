// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "document/fractal/fractal.h"

#include <QString>

#include <optional>
#include <variant>
#include <vector>

// Views of an entry that have names, kept in comments "barycage: view…" of its own. docs/formats.md,
// "Barycage's comment lines".
namespace document {

struct SavedView {
    using Camera = std::variant<attractor::View, attractor::OrbitCamera>; // size is meaningless

    QString name; // must equal storableViewName(name)
    Camera camera;

    friend bool operator==(const SavedView&, const SavedView&) = default;
};

inline constexpr std::size_t maxSavedViews = 100; // views per entry; further lines are kept and ignored

// Views of the entry's dimension in their order, each name once: the first one counts. Lines that make no
// sense are passed over.
std::vector<SavedView> savedViews(const Fractal& fractal);
std::optional<SavedView> savedView(const Fractal& fractal, const QString& name);

// Replaces the view of the same name, or appends it. The fractal stays as it is if there are maxSavedViews
// already, or if the camera belongs to the other dimension.
Fractal withSavedView(Fractal fractal, const SavedView& view);
Fractal withoutSavedView(Fractal fractal, const QString& name);
// `to` must not be the name of another view.
Fractal withViewRenamed(Fractal fractal, const QString& name, const QString& to);

// The name as one line without blanks at its ends, short enough to be kept; empty for a name without letters.
QString storableViewName(const QString& name);

} // namespace document
