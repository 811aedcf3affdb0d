// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/background_threads.h"

#include <chrono>
#include <functional>
#include <memory>

namespace document {

// Pieces of work that are done one after another, in the order in which they come, in threads of a lane. They
// go on when this object is gone, perhaps beyond the end of the program, so they hold nothing but values.
class WorkInOrder {
public:
    explicit WorkInOrder(Lane lane);

    void start(std::function<void()> piece);
    // Waits until all that came before is done, but no longer than that; whether it is.
    bool finishes(std::chrono::milliseconds patience) const;

private:
    struct Queue;
    std::shared_ptr<Queue> m_queue;
};

} // namespace document
