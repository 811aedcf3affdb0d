// SPDX-License-Identifier: MIT
#include "dialogs/variations/sheet_maker.h"

#include "io/file/background.h"

#include <utility>

namespace view {

SheetMaker::SheetMaker(int count, QObject* parent)
    : QObject(parent), m_count(count), m_thumbnails(new Thumbnails(this)) {
    connect(m_thumbnails, &Thumbnails::ready, this, [this](quint64 ready) {
        if (ready / quint64(m_count) == m_sheet) emit drawn(int(ready % quint64(m_count)));
    });
    connect(&m_making, &QFutureWatcherBase::resultReadyAt, this, &SheetMaker::take);
}

SheetMaker::~SheetMaker() {
    clear();
}

void SheetMaker::setSide(int side, qreal devicePixelRatio) {
    m_thumbnails->setSize(side, devicePixelRatio);
}

void SheetMaker::clear() {
    m_stop.request_stop();
    m_making.cancel();
    m_thumbnails->clear();
    io::freeInBackground(std::exchange(m_fractals, {}));
    ++m_sheet;
}

void SheetMaker::make(const std::function<Make()>& prepare, std::uint64_t firstSeed) {
    clear();
    m_stop = std::stop_source();
    m_making.setFuture(
        io::inBackground<FractalPointer>([prepare, first = firstSeed, count = m_count,
                                          stop = m_stop.get_token()](QPromise<FractalPointer>& made) {
            const Make make = stop.stop_requested() ? Make() : prepare();
            for (std::uint64_t seed = first; make && seed < first + std::uint64_t(count); ++seed) {
                auto fractal = std::make_shared<const document::Fractal>(make(seed, stop));
                if (stop.stop_requested()) return;
                made.addResult(std::move(fractal));
            }
        }));
}

void SheetMaker::take(int index) {
    m_fractals.push_back(m_making.resultAt(index));
    emit made(index);
}

SheetMaker::FractalPointer SheetMaker::fractal(int index) const {
    return index >= 0 && index < int(m_fractals.size()) ? m_fractals[std::size_t(index)] : nullptr;
}

Thumbnail SheetMaker::picture(int index) {
    const FractalPointer shown = fractal(index);
    return shown ? m_thumbnails->thumbnail(key(index), shown) : Thumbnail{};
}

} // namespace view
