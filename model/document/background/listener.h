// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <utility>

namespace document {

// Receives messages from other threads for as long as it exists. They share it with its owner, which says
// when it goes.
class Listener {
public:
    // Calls it, unless the owner has gone; it does not go meanwhile.
    template <class Call> void tell(Call&& call) {
        const std::scoped_lock lock(m_mutex);
        if (m_isThere) std::forward<Call>(call)();
    }
    void leave() {
        const std::scoped_lock lock(m_mutex);
        m_isThere = false;
    }

private:
    std::mutex m_mutex;
    bool m_isThere = true;
};

} // namespace document
