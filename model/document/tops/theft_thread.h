// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/frame.h"
#include "attractor/tops/mip_picture.h"
#include "document/edits/coupled_entries.h"
#include "document/tops/kept_theft.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace document {

// Drawing job for a fractal transformation from F to G: F with the colours it steals, and G with the picture
// on it.
struct TheftJob {
    struct Side {
        std::shared_ptr<const Fractal> fractal;
        attractor::Camera camera; // no pixels: not drawn
        std::uint64_t revision = 0;
        friend bool operator==(const Side&, const Side&) = default;
    };
    Side from, to;
    std::vector<std::size_t> order; // same meaning as in KeptTheft
    TheftMode mode = TheftMode::StealColours;
    std::optional<attractor::View> view;                  // same meaning as in KeptTheft
    std::shared_ptr<const attractor::MipPicture> picture; // never null
    double overlay = 0;                                   // opacity of G over F in the picture of F
    bool isLive = false;                                  // true: similar jobs will follow
    std::uint64_t number = 0;                             // number copied to its frames

    friend bool operator==(const TheftJob&, const TheftJob&) = default;
};

struct StolenFrames {
    std::shared_ptr<const attractor::Frame> from, to; // null if not drawn, or if there is a flaw
    std::optional<CouplingOutcome> flaw;              // reason why there is no transformation
    std::uint64_t number = 0;                         // number of the job
};

// A worker thread around DeferredTheft: the newest job wins, an older one is abandoned within milliseconds.
// While jobs come from a hand that moves, each has as many points as keep it fluid; at rest there are more
// and more. While only G or the picture moves, the keys of F stay.
class TheftThread {
public:
    // `ready` is called on the worker thread, never again before newest() has been called since.
    explicit TheftThread(int threads, std::function<void()> ready);
    ~TheftThread(); // stops and joins

    TheftThread(const TheftThread&) = delete;
    TheftThread& operator=(const TheftThread&) = delete;

    void submit(TheftJob job); // thread-safe
    void cancel();             // drops the present job; the newest frames stay

    // Thread-safe; nullptr before the first.
    std::shared_ptr<const StolenFrames> newest();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace document
