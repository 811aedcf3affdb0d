// SPDX-License-Identifier: MIT
#include "io/file/export_work.h"

#include "document/background/background_threads.h"

#include <chrono>
#include <utility>

namespace io {

ExportWork::ExportWork(Work work) {
    const auto ended = std::make_shared<std::promise<void>>();
    m_ended = ended->get_future();
    document::startInLane(document::Lane::Exporting, [work = std::move(work), stop = m_stop,
                                                      listener = m_listener, ended]() mutable {
        const std::stop_callback atTheEnd(document::endOfProgram(), [&stop] { stop.request_stop(); });
        work(stop.get_token(), *listener);
        ended->set_value();
    });
}

ExportWork::~ExportWork() {
    constexpr std::chrono::seconds patience(1);
    stop();
    m_ended.wait_for(patience);
    m_listener->leave();
}

} // namespace io
