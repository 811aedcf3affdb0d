// SPDX-License-Identifier: MIT
#include "transformation/picture_source.h"

#include "io/file/background.h"
#include "io/tops/picture_reader.h"

#include <utility>

namespace view {

PictureSource::PictureSource(QObject* parent) : QObject(parent) {
    connect(&m_work, &QFutureWatcherBase::finished, this, [this] {
        if (m_work.isCanceled()) return;
        const Outcome outcome = m_work.result();
        if (outcome.picture)
            emit ready(outcome.picture);
        else
            emit failed(outcome.failure);
    });
}

PictureSource::~PictureSource() = default;

QString PictureSource::wishFor(attractor::Pattern pattern) {
    const auto name = attractor::nameOf(pattern);
    return QString::fromLatin1(name.data(), qsizetype(name.size()));
}

void PictureSource::draw(attractor::Pattern pattern) {
    const QString wish = wishFor(pattern);
    if (std::exchange(m_wish, wish) == wish) return;
    m_work.setFuture(io::inBackground<Outcome>([pattern](QPromise<Outcome>& promise) {
        promise.addResult(
            Outcome{std::make_shared<const attractor::MipPicture>(attractor::picture(pattern)), {}});
    }));
}

void PictureSource::read(const QString& path) {
    m_wish = path;
    m_work.setFuture(io::inBackground<Outcome>([path](QPromise<Outcome>& promise) {
        io::ReadPicture read = io::readPicture(path);
        Outcome outcome;
        if (read.failure)
            outcome.failure = *read.failure;
        else
            outcome.picture = std::make_shared<const attractor::MipPicture>(std::move(read.picture));
        promise.addResult(std::move(outcome));
    }));
}

} // namespace view
