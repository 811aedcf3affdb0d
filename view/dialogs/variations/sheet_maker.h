// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/thumbnails.h"

#include <QFutureWatcher>
#include <QObject>

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

namespace view {

// Milliseconds after the last change of a size before the sheet is drawn anew.
inline constexpr int resizePause = 150;

// Makes a sheet of fractals from successive seeds, and their pictures, in the background. A new sheet takes
// the place of the last one at once.
class SheetMaker : public QObject {
    Q_OBJECT

public:
    using FractalPointer = Thumbnails::FractalPointer;
    using Make = std::function<document::Fractal(std::uint64_t seed, const std::stop_token& stop)>;

    explicit SheetMaker(int count, QObject* parent = nullptr);
    ~SheetMaker() override;

    int count() const { return m_count; }
    void setSide(int side, qreal devicePixelRatio); // size of the pictures; made() requests them anew

    // `prepare` is called once, in the background too.
    void make(const std::function<Make()>& prepare, std::uint64_t firstSeed);
    void clear(); // empties the sheet

    FractalPointer fractal(int index) const; // null until it has been made
    Thumbnail picture(int index);            // requests a missing picture

signals:
    void made(int index);  // sent for each fractal
    void drawn(int index); // sent for each picture

private:
    quint64 key(int index) const { return m_sheet * quint64(m_count) + quint64(index); }
    void take(int index);

    const int m_count;
    quint64 m_sheet = 0; // number of the sheet, which distinguishes the pictures of all sheets
    std::vector<FractalPointer> m_fractals;
    std::stop_source m_stop;
    QFutureWatcher<FractalPointer> m_making;
    Thumbnails* m_thumbnails;
};

} // namespace view
