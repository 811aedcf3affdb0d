// SPDX-License-Identifier: MIT
#include "files/kept_versions.h"

#include "desktop/preferences.h"
#include "desktop/settings.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <QStringList>
#include <QWidget>

#include <memory>

namespace {

struct KeptText {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)
};

// Digests of kept versions by file, the latest last: only such a file is replaced.
const QString keptKey = QStringLiteral("kept/versions");
constexpr qsizetype maxRemembered = 200;

QByteArray digestKept(const QString& path) {
    for (const QString& line : view::stored(keptKey).toStringList())
        if (line.section(u' ', 1) == path) return QByteArray::fromHex(line.section(u' ', 0, 0).toLatin1());
    return {};
}

void rememberKept(const QString& path, const QByteArray& digest) {
    QStringList lines = view::stored(keptKey).toStringList();
    lines.removeIf([&](const QString& line) { return line.section(u' ', 1) == path; });
    lines << QString::fromLatin1(digest.toHex()) + u' ' + path;
    while (lines.size() > maxRemembered)
        lines.removeFirst();
    view::store(keptKey, lines);
}

QString absolute(const QString& path) {
    return QFileInfo(path).absoluteFilePath();
}

} // namespace

io::KeptVersion KeptVersions::Wish::fulfilled(const QString& path) const {
    return isWanted ? io::keepPreviousVersion(path, own) : io::KeptVersion();
}

KeptVersions::Wish KeptVersions::wishFor(const QString& path) const {
    const bool isWanted = view::Preferences::stored().keepPrevious && !m_seen.contains(absolute(path));
    return {isWanted, digestKept(absolute(path))};
}

void KeptVersions::note(const QString& path, const io::KeptVersion& kept, bool isSaved) {
    if (kept.outcome == io::Keeping::Kept) rememberKept(absolute(path), kept.digest);
    if (isSaved) m_seen << absolute(path);
}

QString remarkOn(io::Keeping outcome, const QString& name) {
    const QString kept = io::previousVersionOf(name);
    switch (outcome) {
    case io::Keeping::Nothing:
        break;
    case io::Keeping::Kept:
        return KeptText::tr("The previous version is %1.").arg(kept);
    case io::Keeping::Foreign:
        return KeptText::
            tr("The previous version was not kept: there is already a file %1 that Barycage did not make.")
                .arg(kept);
    case io::Keeping::Refused:
        return KeptText::tr("The previous version could not be kept as %1.").arg(kept);
    }
    return {};
}

KeepingSave saveKeeping(const QString& path, const QByteArray& bytes, QWidget* window,
                        KeptVersions& versions) {
    const QPointer<QWidget> over(window);
    const KeptVersions::Wish wish = versions.wishFor(path);
    const auto kept = std::make_shared<io::KeptVersion>();
    const view::Saving saving =
        view::saveBeside(path, bytes, window, [path, wish, kept] { *kept = wish.fulfilled(path); });
    if (saving.isCancelled || !over) return {saving, io::Keeping::Nothing};
    versions.note(path, *kept, !saving.failure);
    return {saving, kept->outcome};
}
