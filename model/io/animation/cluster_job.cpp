// SPDX-License-Identifier: MIT
#include "io/animation/cluster_job.h"

#include "document/text/file_names.h"
#include "document/text/text.h"
#include "document/text/unique_names.h"
#include "io/fractint/entry_writer.h"

#include <QDir>
#include <QFile>

#include <algorithm>
#include <new>

namespace io {

namespace {

constexpr const char* entryFile = "entry.ifs";
constexpr QFile::Permissions runnable = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner |
                                        QFile::ReadGroup | QFile::ExeGroup | QFile::ReadOther |
                                        QFile::ExeOther;

QString outputName(const ClusterJob& job) {
    if (!job.animation.format) return QStringLiteral("frames/######.png");
    return QStringLiteral("animation.") + videoSuffix(*job.animation.format);
}

QByteArray submitText(const ClusterJob& job) {
    const int frames = job.animation.last - job.animation.first + 1;
    return QStringLiteral(
               "#!/usr/bin/env bash\n"
               "# Submits the animation to Slurm. Run it again to finish work that was interrupted.\n"
               "set -euo pipefail\n"
               "here=$(readlink -f -- \"${BASH_SOURCE[0]}\")\n"
               "cd \"${here%/*}/\"\n"
               "exec ./submit-animation.sh %1 '#1' '%2' %3 %4\n")
        .arg(QLatin1String(entryFile), outputName(job), QString::number(std::clamp(job.tasks, 1, frames)),
             options(job.animation).join(u' '))
        .toUtf8();
}

// A name as Markdown shows it: what would be a mark of Markdown, or part of one, is escaped.
QString literal(const QString& name) {
    QString text;
    for (const QChar c : document::oneLine(name)) {
        if (c.unicode() < 128 && (c.isPunct() || c.isSymbol())) text += u'\\';
        text += c;
    }
    return text;
}

QByteArray readmeText(const ClusterJob& job) {
    const QString frames = QString::number(job.animation.last - job.animation.first + 1);
    const QString size =
        QStringLiteral("%1x%2").arg(job.animation.size.width()).arg(job.animation.size.height());
    return QStringLiteral(
               "# %1 on a cluster\n\n"
               "This folder draws its frames (%2 of %3 pixels) with Slurm. Put it where all machines can "
               "read and write it; they need `barycage-cli` %4. Then run:\n\n"
               "    ./submit.sh\n\n"
               "The result is `%5`. Frames that are complete are not drawn again: after an "
               "interruption, run `./submit.sh` once more. Options of `sbatch` go into its "
               "variables, such as `SBATCH_PARTITION=long ./submit.sh`, and `BARYCAGE_CLI` names "
               "the program where it is not in the path.\n\n"
               "* `entry.ifs`: the animation\n"
               "* `submit.sh`: size, frames and quality; it calls `submit-animation.sh`\n"
               "* `animate.sh`, `encode.sh`: what Slurm runs\n")
        .arg(literal(job.animation.entry.name), frames, size, QLatin1String(BARYCAGE_VERSION),
             outputName(job))
        .toUtf8();
}

Failure writeScript(const QDir& folder, const QString& name, const QByteArray& text) {
    const QString path = folder.filePath(name);
    if (const Failure failure = saveFile(path, text)) return failure;
    QFile::setPermissions(path,
                          runnable); // fallback: bash can also read files without this flag
    return std::nullopt;
}

Failure fill(const QDir& folder, const ClusterJob& job) {
    const QByteArray entry = writeEntry(job.animation.entry) + '\n';
    if (const Failure failure = saveFile(folder.filePath(QLatin1String(entryFile)), entry)) return failure;
    if (const Failure failure = saveFile(folder.filePath(QStringLiteral("README.md")), readmeText(job)))
        return failure;
    for (const char* name :
         {"submit-animation.sh", "animation-options.sh", "names.sh", "animate.sh", "encode.sh"}) {
        QFile script(QStringLiteral(":/slurm/") + QLatin1String(name));
        if (!script.open(QIODevice::ReadOnly)) return script.errorString();
        if (const Failure failure = writeScript(folder, QLatin1String(name), script.readAll()))
            return failure;
    }
    return writeScript(folder, QLatin1String(submitScript), submitText(job));
}

} // namespace

WrittenJob writeClusterJob(const QString& parent, const ClusterJob& job) {
    const QString name = document::fileNamePart(document::UniqueNames().give(job.animation.entry.name)) +
                         QStringLiteral("-cluster");
    const QDir folder(parent);
    QString unused = name;
    for (int number = 2; folder.exists(unused); ++number)
        unused = name + u'-' + QString::number(number);
    const QString path = folder.filePath(unused);
    QDir made(path);
    const WrittenJob failed{{}, Text::tr("The folder %1 cannot be created.").arg(path)};
    if (!folder.mkdir(unused)) return failed;
    try {
        if (made.exists()) {
            WrittenJob written{path, fill(made, job)};
            if (written.failure) made.removeRecursively();
            return written;
        }
        folder.rmdir(unused);
        return failed;
    } catch (const std::bad_alloc&) {
        made.removeRecursively();
        throw;
    }
}

} // namespace io
