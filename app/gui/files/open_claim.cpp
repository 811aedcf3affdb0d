// SPDX-License-Identifier: MIT
#include "files/open_claim.h"

#include "io/file/background.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <chrono>
#include <thread>
#include <utility>

namespace {

using namespace std::chrono_literals;

// A window that has just been closed gives its file up a moment later.
constexpr int tries = 5;
constexpr auto betweenTries = 150ms;

const QString claimEnding = QStringLiteral(".open");

QString claimFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/open");
}

// Locks of processes that were killed.
void removeLeft(const QString& folder) {
    const QDir dir(folder);
    for (const QString& name : dir.entryList({u'*' + document::lockFileOf(claimEnding)}, QDir::Files))
        document::processLock(dir.filePath(name.chopped(document::lockFileOf({}).size())));
}

} // namespace

QString claimOf(const QString& path) {
    const QFileInfo file(path);
    const QString canonical = file.canonicalFilePath();
    const QByteArray name = (canonical.isEmpty() ? file.absoluteFilePath() : canonical).toUtf8();
    const QByteArray hash = QCryptographicHash::hash(name, QCryptographicHash::Sha256).toHex();
    return claimFolder() + u'/' + QString::fromLatin1(hash) + claimEnding;
}

QFuture<OpenClaim> claimBeside(const QString& path, ClaimLock former) {
    return io::inBackground<OpenClaim>(
        io::Lane::Asking, [path, former = std::move(former)](QPromise<OpenClaim>& promise) mutable {
            former.reset();
            const QString claim = claimOf(path);
            document::makePrivateFolder(claimFolder());
            removeLeft(claimFolder());
            OpenClaim result;
            for (int i = 0; i < tries && !result.lock; ++i) {
                if (i > 0) std::this_thread::sleep_for(betweenTries);
                result.lock = document::processLock(claim);
            }
            result.isElsewhere = !result.lock && QFileInfo::exists(document::lockFileOf(claim));
            promise.addResult(std::move(result));
        });
}
