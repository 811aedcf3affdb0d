// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/listener.h"

#include <functional>
#include <future>
#include <memory>
#include <stop_token>

namespace io {

// Work that writes what is exported, in a thread of its own. Destroying it tells the work to stop and waits,
// but not long: work that waits for a drive that does not answer goes on alone, and cleans up if it gets that
// far. The sudden end of the program tells it, too.
class ExportWork {
public:
    // Called in that thread. It holds nothing but values and what it tells the listener.
    using Work = std::function<void(const std::stop_token& stop, document::Listener& listener)>;
    explicit ExportWork(Work work);
    ~ExportWork();
    ExportWork(const ExportWork&) = delete;
    ExportWork& operator=(const ExportWork&) = delete;

    void stop() { m_stop.request_stop(); }

private:
    std::stop_source m_stop;
    std::shared_ptr<document::Listener> m_listener = std::make_shared<document::Listener>();
    std::future<void> m_ended;
};

} // namespace io
