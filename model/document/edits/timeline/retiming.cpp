// SPDX-License-Identifier: MIT
#include "document/edits/timeline/retiming.h"

#include <cmath>
#include <utility>

namespace document {

namespace {

int retimed(int frame, const Stretch& stretch) {
    if (frame <= stretch.from) return frame;
    if (frame > stretch.to) return frame + stretch.end - stretch.to;
    const double ratio = double(stretch.end - stretch.from) / (stretch.to - stretch.from);
    return stretch.from + int(std::lround((frame - stretch.from) * ratio));
}

template <int Dim, class Use> void visitTracks(animation::Animation<Dim>& animation, Use use) {
    use(animation.cage);
    use(animation.look);
    use(animation.camera);
    for (auto& track : animation.maps)
        use(track.keys);
    for (auto& track : animation.branches)
        use(track.keys);
}

template <int Dim> bool stretchKeys(Shape<Dim>* shape, const Stretch& stretch) {
    if (!shape || !shape->animation) return false;
    auto& animation = *shape->animation;
    bool isPossible = true;
    visitTracks<Dim>(animation, [&](auto& keys) {
        for (std::size_t i = 0; i < keys.size(); ++i) {
            keys[i].frame = retimed(keys[i].frame, stretch);
            if (i > 0 && keys[i].frame <= keys[i - 1].frame) isPossible = false;
        }
    });
    animation.length += stretch.end - stretch.to;
    return isPossible && animation.length <= animation::maxLength;
}

} // namespace

std::optional<Fractal> withKeysStretched(Fractal entry, const Stretch& stretch) {
    if (stretch.from < 0 || stretch.to <= stretch.from || stretch.end <= stretch.from) return std::nullopt;
    const bool isDone = stretchKeys<2>(plane(entry), stretch) || stretchKeys<3>(space(entry), stretch);
    return isDone ? std::optional(std::move(entry)) : std::nullopt;
}

} // namespace document
