// SPDX-License-Identifier: MIT
#include "transformation/picture_source.h"

#include "io/file/background.h"

#include <QCryptographicHash>

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

QString PictureSource::wishFor(const QByteArray& file) {
    return QString::fromLatin1(QCryptographicHash::hash(file, QCryptographicHash::Sha256).toHex());
}

void PictureSource::read(const QString& path) {
    m_wish = path;
    wait(io::Lane::Reading, [path] { return io::readPicture(path); });
}

void PictureSource::decode(const QByteArray& file) {
    m_wish = wishFor(file);
    wait(io::Lane::Computing, [file] { return io::decodePicture(file); });
}

void PictureSource::wait(io::Lane lane, std::function<io::ReadPicture()> reader) {
    m_work.setFuture(
        io::inBackground<Outcome>(lane, [reader = std::move(reader)](QPromise<Outcome>& promise) {
            io::ReadPicture read = reader();
            Outcome outcome;
            if (read.failure)
                outcome.failure = *read.failure;
            else
                outcome.picture = std::make_shared<const attractor::MipPicture>(std::move(read.picture));
            promise.addResult(std::move(outcome));
        }));
}

} // namespace view
