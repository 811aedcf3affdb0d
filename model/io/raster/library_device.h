// SPDX-License-Identifier: MIT
#pragma once

#include <QIODevice>

#include <exception>
#include <utility>

namespace io {

// A device as a library in C writes to it. Nothing is thrown through the library, and what failed is
// remembered, because libraries do not pass on every error.
class LibraryDevice {
public:
    explicit LibraryDevice(QIODevice& device) : m_device(device) {}

    bool write(const void* bytes, qint64 size) noexcept {
        return succeeds([&] { return m_device.write(static_cast<const char*>(bytes), size) == size; });
    }
    bool seek(qint64 position) noexcept {
        return succeeds([&] { return m_device.seek(position); });
    }
    qint64 position() const { return m_device.pos(); }

    // Failures of the library itself.
    void fail() noexcept { m_isFailed = true; }
    bool isFailed() const { return m_isFailed; }

    QString errorString() const { return m_device.errorString(); }

    // Rethrows the exception of the device, once; to be called when the library has returned.
    void rethrow() {
        if (m_thrown) std::rethrow_exception(std::exchange(m_thrown, nullptr));
    }

private:
    template <class Call> bool succeeds(Call call) noexcept {
        try {
            if (call()) return true;
        } catch (...) {
            if (!m_thrown) m_thrown = std::current_exception();
        }
        m_isFailed = true;
        return false;
    }

    QIODevice& m_device;
    std::exception_ptr m_thrown;
    bool m_isFailed = false;
};

} // namespace io
