// SPDX-License-Identifier: MIT
#pragma once

#include "process/input.h"

#include "attractor/request/render_request.h"

#include <map>
#include <set>
#include <vector>

namespace cli {

// Collects notes on the frames of an animation: one warning for all frames to which it applies.
class FrameNotes {
public:
    // Says at once which of the frames have no attractor; where none of them lacks it, the first moment of
    // the animation that does.
    FrameNotes(const Input& input, const document::Fractal& entry, const std::vector<int>& frames);

    void add(int frame, attractor::RenderNote note);
    void report(const QString& fileName) const; // prints notes that have not been printed yet

private:
    bool m_isInSpace;
    std::set<int> m_lost; // frames already reported to have no attractor
    std::map<attractor::RenderNote, std::vector<int>> m_frames;
};

// "3–5, 9" of ascending numbers.
QString rangesText(const std::vector<int>& numbers);

} // namespace cli
