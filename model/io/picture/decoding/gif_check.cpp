// SPDX-License-Identifier: MIT
#include "io/picture/decoding/gif_check.h"

#include <QtEndian>

#include <algorithm>
#include <array>
#include <cstdint>

namespace io {

namespace {

constexpr std::uint64_t slack = 1 << 20; // pixels
constexpr qsizetype headerSize = 13;     // bytes, including the screen descriptor
constexpr qsizetype descriptorSize = 9;

qsizetype paletteSize(char flags) {
    return (flags & 0x80) != 0 ? qsizetype{3} << ((flags & 7) + 1) : 0;
}

// Behind the blocks at this place, the last of which is empty.
qsizetype behindBlocks(const QByteArray& bytes, qsizetype at) {
    while (at < bytes.size() && bytes[at] != 0)
        at += 1 + std::uint8_t(bytes[at]);
    return at + 1;
}

// Offset of the descriptor of the first picture; beyond the end if there is none.
qsizetype firstPicture(const QByteArray& bytes) {
    constexpr char extension = 0x21, picture = 0x2c;
    if (bytes.size() <= headerSize) return bytes.size();
    qsizetype at = headerSize + paletteSize(bytes[10]);
    while (at < bytes.size() && bytes[at] == extension)
        at = behindBlocks(bytes, at + 2);
    return at < bytes.size() && bytes[at] == picture ? at + 1 : bytes.size();
}

// The codes of a picture, one after the other, and how many pixels they stand for.
class Codes {
public:
    explicit Codes(int bits) : m_clear(1 << bits), m_first(bits + 1) { clear(); }

    void take(std::uint8_t byte) {
        m_bits |= std::uint32_t(byte) << m_count;
        m_count += 8;
        while (m_count >= m_size && !m_isOver) {
            const int code = int(m_bits & ((1U << m_size) - 1));
            m_bits >>= m_size;
            m_count -= m_size;
            follow(code); // may increase the width of codes
        }
    }
    std::uint64_t pixels() const { return m_pixels; }
    bool isOver() const { return m_isOver; }

private:
    static constexpr int most = 4096;

    void clear() {
        m_size = m_first;
        m_next = m_clear + 2;
        m_before = 0;
        std::fill_n(m_lengths.begin(), m_clear, 1U);
    }
    void follow(int code) {
        if (code == m_clear) return clear();
        if (code == m_clear + 1) {
            m_isOver = true;
            return;
        }
        const std::uint32_t length = code < m_next ? m_lengths[std::size_t(code)] : m_before + 1;
        m_pixels += length;
        if (m_before > 0 && m_next < most) {
            m_lengths[std::size_t(m_next)] = m_before + 1;
            ++m_next;
            if (m_next == 1 << m_size && m_size < 12) ++m_size;
        }
        m_before = length;
    }

    std::array<std::uint32_t, most> m_lengths{};
    int m_clear, m_first; // clear code; initial bits of a code
    int m_size = 0, m_next = 0;
    std::uint32_t m_before = 0; // length of the previous code; 0: none
    std::uint32_t m_bits = 0;
    int m_count = 0; // number of pending bits
    std::uint64_t m_pixels = 0;
    bool m_isOver = false;
};

} // namespace

bool isSwollenGif(const QByteArray& bytes) {
    const qsizetype descriptor = firstPicture(bytes);
    if (descriptor + descriptorSize >= bytes.size()) return false;
    const auto side = [&](qsizetype at) {
        return std::uint64_t(qFromLittleEndian<quint16>(bytes.constData() + descriptor + at));
    };
    const std::uint64_t allowed = 2 * side(4) * side(6) + slack;
    qsizetype at = descriptor + descriptorSize + paletteSize(bytes[descriptor + 8]);
    if (at >= bytes.size() || bytes[at] < 1 || bytes[at] > 8) return false;
    Codes codes(bytes[at]);
    for (++at; at < bytes.size() && bytes[at] != 0;) {
        const qsizetype end = std::min(at + 1 + std::uint8_t(bytes[at]), bytes.size());
        for (++at; at < end && !codes.isOver(); ++at)
            codes.take(std::uint8_t(bytes[at]));
        if (codes.pixels() > allowed) return true;
        at = end;
    }
    return false;
}

} // namespace io
