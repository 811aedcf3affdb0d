// SPDX-License-Identifier: MIT
#include "transformation/picture_source.h"

#include "io/file/background.h"
#include "io/file/named_path.h"

#include <QCryptographicHash>
#include <QDir>

#include <utility>

namespace view {

PictureSource::PictureSource(QObject* parent) : QObject(parent) {
    connect(&m_work, &QFutureWatcherBase::finished, this, [this] {
        if (m_work.isCanceled()) return;
        const Outcome outcome = m_work.result();
        if (outcome.isForeign)
            emit foreign();
        else if (outcome.picture)
            emit ready(outcome.picture);
        else
            emit failed(outcome.failure);
    });
}

PictureSource::~PictureSource() {
    m_stop.request_stop();
}

QString PictureSource::wishFor(attractor::Pattern pattern) {
    return QString::fromLatin1(ifs::nameOf(pattern));
}

void PictureSource::draw(attractor::Pattern pattern) {
    const QString wish = wishFor(pattern);
    if (std::exchange(m_wish, wish) == wish) return;
    m_stop.request_stop();
    m_work.setFuture(io::inBackground<Outcome>([pattern](QPromise<Outcome>& promise) {
        promise.addResult(
            Outcome{std::make_shared<const attractor::MipPicture>(attractor::picture(pattern)), {}});
    }));
}

void PictureSource::forget() {
    m_wish.clear();
    m_stop.request_stop();
    m_work.setFuture({});
}

QString PictureSource::wishFor(const QByteArray& file) {
    return QString::fromLatin1(QCryptographicHash::hash(file, QCryptographicHash::Sha256).toHex());
}

void PictureSource::read(const QString& path) {
    m_wish = path;
    wait(io::Lane::Reading, [path](const std::stop_token& stop) { return io::readPicture(path, stop); });
}

void PictureSource::readNamed(const QString& folder, const QString& path) {
    m_wish = absolutePath(folder, path);
    wait(
        io::Lane::Reading,
        [path = m_wish](const std::stop_token& stop) { return io::readPicture(path, stop); },
        [folder, path] { return isForeign(folder, path); });
}

bool PictureSource::isForeign(const QString& folder, const QString& path) {
    return folder.isEmpty() || !io::liesInside(folder, path);
}

QString PictureSource::absolutePath(const QString& folder, const QString& path) {
    return QDir::cleanPath(QDir(folder).absoluteFilePath(path));
}

void PictureSource::decode(const QByteArray& file) {
    m_wish = wishFor(file);
    wait(io::Lane::Computing, [file](const std::stop_token& stop) { return io::decodePicture(file, stop); });
}

void PictureSource::wait(io::Lane lane, Reader reader, std::function<bool()> isForeign) {
    m_stop.request_stop();
    m_stop = {};
    m_work.setFuture(
        io::inBackground<Outcome>(lane, [reader = std::move(reader), isForeign = std::move(isForeign),
                                         stop = m_stop.get_token()](QPromise<Outcome>& promise) {
            if (isForeign && isForeign()) {
                promise.addResult(Outcome{nullptr, {}, true});
                return;
            }
            io::ReadPicture read = reader(stop);
            Outcome outcome;
            if (read.failure)
                outcome.failure = *read.failure;
            else
                outcome.picture = std::make_shared<const attractor::MipPicture>(std::move(read.picture));
            promise.addResult(std::move(outcome));
        }));
}

} // namespace view
