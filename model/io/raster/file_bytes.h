// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArrayView>
#include <QtEndian>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace io {

// Reads numbers and pieces at any offset; nullopt beyond the end.
class FileBytes {
public:
    explicit FileBytes(QByteArrayView bytes, bool isBigEndian = false)
        : m_bytes(bytes), m_isBigEndian(isBigEndian) {}

    template <class Number> std::optional<Number> number(std::uint64_t at) const {
        if (!has(at, sizeof(Number))) return std::nullopt;
        const char* from = m_bytes.data() + at;
        return m_isBigEndian ? qFromBigEndian<Number>(from) : qFromLittleEndian<Number>(from);
    }
    std::optional<QByteArrayView> piece(std::uint64_t at, std::uint64_t size) const {
        if (!has(at, size)) return std::nullopt;
        return m_bytes.sliced(qsizetype(at), qsizetype(size));
    }
    // The bytes up to the next zero.
    std::optional<QByteArrayView> name(std::uint64_t at) const {
        constexpr qsizetype maxName = 256;
        if (!has(at, 1)) return std::nullopt;
        const QByteArrayView rest =
            m_bytes.sliced(qsizetype(at)).first(std::min(maxName, m_bytes.size() - qsizetype(at)));
        const qsizetype size = rest.indexOf('\0');
        if (size < 0) return std::nullopt;
        return rest.first(size);
    }

private:
    bool has(std::uint64_t at, std::uint64_t size) const {
        const auto all = std::uint64_t(m_bytes.size());
        return at <= all && size <= all - at;
    }

    QByteArrayView m_bytes;
    bool m_isBigEndian;
};

} // namespace io
