// SPDX-License-Identifier: MIT
#include "io/animation/request_text.h"

#include "io/fractint/entry_writer.h"

#include <QCryptographicHash>

namespace io {

FrameRequestText::FrameRequestText(int pixels) {
    add("pixels", QByteArray::number(pixels));
}

void FrameRequestText::add(const char* name, const QByteArray& value) {
    m_text += QByteArray(name) + ' ' + value + '\n';
}

void FrameRequestText::addCount(const char* name, std::uint64_t value) {
    add(name, QByteArray::number(qulonglong(value)));
}

void FrameRequestText::addFrame(std::optional<int> frame) {
    if (frame) addCount("frame", std::uint64_t(*frame));
}

QByteArray FrameRequestText::hash(const document::Fractal& entry) const {
    const QByteArray text = m_text + "entry " + writeEntry(entry) + '\n';
    return QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex();
}

} // namespace io
