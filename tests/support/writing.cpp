// SPDX-License-Identifier: MIT
// Writes a file of the kind that its first argument names in the folder that the second one names, first an
// old version and, from begin() on, a new one. Ends with status 3 when it says that
// this did not work.
#include "document/disk/journal.h"
#include "document/fractal/fractal.h"
#include "document/moments/animated_fractal.h"
#include "io/animation/cluster_job.h"
#include "io/exports/task_folder.h"
#include "io/file/previous_version.h"
#include "io/file/save_file.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/lesson/lesson_writer.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>

#include <dlfcn.h>
#include <new>
#include <unistd.h>

namespace {

// From now on, calls and allocations are counted (failing_calls.cpp, failing_allocations.cpp).
void begin() {
    if (::access("/barycage/begin", F_OK) == 0) qFatal("There is no such file.");
    if (auto* const begins = reinterpret_cast<void (*)()>(::dlsym(RTLD_DEFAULT, "barycageBeginToFail")))
        begins();
}

document::Snapshot snapshot(const QByteArray& bytes) {
    document::Snapshot made;
    made.title = QStringLiteral("a.ifs");
    made.when = QDateTime::fromMSecsSinceEpoch(1'700'000'000'000, Qt::UTC);
    made.bytes = bytes;
    return made;
}

bool writesRecovery(const QString& folder) {
    document::Journal journal(folder);
    if (!journal.write(snapshot("old"))) qFatal("It cannot be written.");
    begin();
    return journal.write(snapshot("new"));
}

bool writesTask(const QString& folder) {
    io::ExportTask task;
    task.path = QStringLiteral("/somewhere/old.png");
    io::PixelRecipe recipe;
    recipe.camera.width = 96;
    recipe.camera.height = 64;
    task.recipe = recipe;
    task.entry = io::writeEntry(document::sierpinskiTriangle());
    io::TaskFolder tasks(folder);
    const QString id = io::TaskFolder::newId();
    if (!tasks.write(id, task)) qFatal("It cannot be written.");
    task.path = QStringLiteral("/somewhere/new.png");
    begin();
    const bool isWritten = tasks.write(id, task);
    tasks.letGo();
    return isWritten;
}

bool writesLesson(const QString& folder) {
    document::Lesson lesson;
    lesson.title = QStringLiteral("New");
    const QByteArray bytes = io::writeLesson(lesson);
    begin();
    return !io::saveFile(QDir(folder).filePath(QStringLiteral("a.lesson")), bytes);
}

bool keepsPrevious(const QString& folder) {
    const QByteArray own = QCryptographicHash::hash("older", QCryptographicHash::Sha256);
    begin();
    return io::keepPreviousVersion(QDir(folder).filePath(QStringLiteral("a.ifs")), own).outcome ==
           io::Keeping::Kept;
}

bool writesCluster(const QString& folder) {
    io::ClusterJob job;
    const document::FractalFile file =
        io::readFractint("a {\n ; barycage: version 1\n ; barycage: animation 3 24/1 off\n"
                         " ; barycage: track map 1\n"
                         " ; barycage: key 0 linear\n ; barycage: value .5 0 0 .5 0 0 .5\n"
                         " ; barycage: key 3 linear\n ; barycage: value .4 0 0 .4 0 0 .5\n"
                         " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
    job.animation.entry = *file.entries.first().fractal;
    if (!document::animationFacts(job.animation.entry)) qFatal("It does not move.");
    job.animation.size = {32, 24};
    begin();
    return !io::writeClusterJob(folder, job).failure;
}

} // namespace

int main(int argc, char** argv) try {
    qputenv("QT_NO_GLIB", "1"); // which ends the program when memory is short
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    const QString kind = arguments.value(1), folder = arguments.value(2);
    const bool isDone = kind == u"recovery"   ? writesRecovery(folder)
                        : kind == u"task"     ? writesTask(folder)
                        : kind == u"lesson"   ? writesLesson(folder)
                        : kind == u"previous" ? keepsPrevious(folder)
                                              : writesCluster(folder);
    return isDone ? 0 : 3;
} catch (const std::bad_alloc&) {
    return 3;
}
