// SPDX-License-Identifier: MIT
#include "io/exports/task_folder.h"
#include "io/exports/task_job.h"
#include "io/file/export_work.h"

#include "document/fractal/fractal_geometry.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QSet>
#include <QSysInfo>
#include <QTemporaryDir>

#include <atomic>
#include <chrono>
#include <future>
#include <random>
#include <thread>

#include <sys/stat.h>

using namespace io;

namespace {

attractor::Camera camera(int width, int height) {
    attractor::Camera view;
    view.width = width;
    view.height = height;
    return fitted(view, {0, 0}, {1, 0.9});
}

ExportTask pixelTask(const QString& path, int width = 96, int height = 64) {
    PixelRecipe recipe;
    recipe.camera = camera(width, height);
    ExportTask task;
    task.path = path;
    task.name = QStringLiteral("sierpinski");
    task.entry = writeEntry(document::sierpinskiTriangle());
    task.recipe = recipe;
    return task;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TaskJob::Outcome drawn(const ExportTask& task) {
    std::promise<TaskJob::Outcome> outcome;
    const TaskJob job(
        task, [](double) {}, [&](const TaskJob::Outcome& found) { outcome.set_value(found); });
    return outcome.get_future().get();
}

} // namespace

// Exports that wait in files.
class ExportTasksTest : public QObject {
    Q_OBJECT

private slots:
    void comesBack();
    void picturesOfSolidsComeBack();
    void damageIsFound();
    void rangesAreChecked();
    void drawsWhatADirectExportDraws_data();
    void drawsWhatADirectExportDraws();
    void replacesOnlyWhatWasAskedAbout();
    void pausesAndStops();
    void aDriveThatDoesNotAnswerHoldsNobodyUp();
    void anEntryThatCannotBeReadIsSaid();
    void filesBelongToTheirOwner();
    void locksOfTheDeadHoldNothing();
    void aLivingProcessKeepsItsTasks();
    void twoProcessesNeverHaveTheSame();
    void whatIsNoTaskIsSkipped();

private:
    QTemporaryDir m_folder;
};

void ExportTasksTest::comesBack() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1e3, 1e3);
    for (int k = 0; k < 200; ++k) {
        ExportTask task = pixelTask(QStringLiteral("/somewhere/цвет %20 “a”.tiff"));
        task.name = QStringLiteral("a\nb\"c");
        task.place = k - 100;
        task.begun = k % 3;
        task.failure = k % 2 ? QStringLiteral("Disk full; ünglücklich.") : QString();
        task.mayReplace = k % 5 == 0;
        PixelRecipe pixels;
        pixels.camera = {{number(random), 1 / number(random)},
                         std::abs(number(random)) * 1e12,
                         1 + k,
                         77,
                         k % 2 ? attractor::YAxis::Up : attractor::YAxis::Down};
        pixels.file = PictureFile::Tiff;
        pixels.camera.rotation = k % 2 ? attractor::rotationOf(10 * k) : 0;
        pixels.depth = PictureFormat::Depth::Bits16;
        pixels.samplesPerPixel = 1 + k;
        pixels.supersample = 1 + k % 4;
        pixels.dotsPerInch = 72.5;
        pixels.cage = k % 2 ? CageVisibility::Shown : CageVisibility::Hidden;
        pixels.isTransparent = k % 3 == 0;
        task.recipe = pixels;
        QCOMPARE(taskIn(taskFile(task)).task, std::optional(task));

        ShapeRecipe shapes;
        shapes.camera = pixels.camera;
        shapes.file = ShapeFile::Pdf;
        shapes.style = ShapeStyle::Points;
        if (k % 2) shapes.depth = k % 200;
        shapes.points = 1 + 100 * k;
        if (k % 3) shapes.dotsPerInch = 100 + k;
        task.recipe = shapes;
        task.path = QStringLiteral("/somewhere/a.pdf");
        QCOMPARE(taskIn(taskFile(task)).task, std::optional(task));

        task.recipe = BodyRecipe{MeshFormat::Glb, 1 + std::abs(number(random)), 8 + k, 0.1, true};
        task.path = QStringLiteral("/somewhere/a.GLB");
        QCOMPARE(taskIn(taskFile(task)).task, std::optional(task));
    }
}

void ExportTasksTest::picturesOfSolidsComeBack() {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> number(-1e3, 1e3);
    for (int k = 0; k < 200; ++k) {
        ExportTask task = pixelTask({});
        SpaceRecipe space;
        space.camera.target = {number(random), number(random), number(random)};
        space.camera.orientation = attractor::orbit(number(random), 0.08 * number(random), k);
        space.camera.height = std::abs(number(random)) + 1e-9;
        space.camera.projection = k % 2 ? attractor::OrbitCamera::Projection::Perspective
                                        : attractor::OrbitCamera::Projection::Orthographic;
        space.camera.fieldOfView = 33.3;
        space.camera.size = {640, 480};
        space.size = {1 + k, 200};
        space.file = PictureFile::WebP;
        space.stereo = Stereo::Anaglyph;
        space.supersample = 3;
        space.isTransparent = true;
        task.recipe = space;
        task.path = QStringLiteral("/somewhere/a.webp");
        QCOMPARE(taskIn(taskFile(task)).task, std::optional(task));
        space.file = PictureFile::Png;
        space.page = ShapeFile::Pdf;
        task.recipe = space;
        task.path = QStringLiteral("/somewhere/b.pdf");
        QCOMPARE(taskIn(taskFile(task)).task, std::optional(task));
        task.path = QStringLiteral("/somewhere/b.png"); // which is not a page
        QVERIFY(taskIn(taskFile(task)).failure);
    }
}

void ExportTasksTest::damageIsFound() {
    const ExportTask task = pixelTask(QStringLiteral("/somewhere/a.png"));
    const QByteArray whole = taskFile(task);
    for (qsizetype at = 0; at < whole.size(); ++at) {
        QByteArray damaged = whole;
        damaged[at] = char(damaged[at] ^ 0x11);
        const ReadTask read = taskIn(damaged);
        QVERIFY2(!read.task || *read.task == task, damaged.constData());
        QVERIFY(read.task || read.failure);
        QVERIFY(!taskIn(whole.first(at)).task || at == whole.size());
    }
    for (const char* other : {"", "barycage-export 1\n", "barycage-export 2\n{}\n",
                              "barycage-export 1\n[]\nx", "barycage-export 1\n{\"sha256\": 3}\n"})
        QVERIFY(taskIn(other).failure);
}

// Made by somebody who knows the hash.
void ExportTasksTest::rangesAreChecked() {
    const auto isRefused = [](auto change) {
        ExportTask task = pixelTask(QStringLiteral("/somewhere/a.png"));
        change(task, std::get<PixelRecipe>(task.recipe));
        const ReadTask read = taskIn(taskFile(task));
        return !read.task && read.failure;
    };
    QVERIFY(!isRefused([](ExportTask&, PixelRecipe&) {}));
    QVERIFY(isRefused([](ExportTask&, PixelRecipe& one) { one.camera.width = 2'000'000'000; }));
    QVERIFY(isRefused([](ExportTask&, PixelRecipe& one) { one.camera.height = 0; }));
    QVERIFY(isRefused([](ExportTask&, PixelRecipe& one) { one.camera.pixelsPerUnit = -1; }));
    QVERIFY(isRefused([](ExportTask&, PixelRecipe& one) { one.camera.centre.x() = NAN; }));
    QVERIFY(isRefused([](ExportTask&, PixelRecipe& one) { one.samplesPerPixel = 1 << 30; }));
    QVERIFY(isRefused([](ExportTask&, PixelRecipe& one) { one.supersample = 100; }));
    QVERIFY(isRefused([](ExportTask&, PixelRecipe& one) { one.file = PictureFile::Jpeg; })); // named .png
    QVERIFY(isRefused([](ExportTask& task, PixelRecipe&) { task.path = QStringLiteral("a.png"); }));
    QVERIFY(isRefused([](ExportTask& task, PixelRecipe&) { task.path = QStringLiteral("/etc/passwd"); }));
    QVERIFY(isRefused([](ExportTask& task, PixelRecipe&) { task.path.clear(); }));
    ExportTask body = pixelTask(QStringLiteral("/somewhere/a.stl"));
    BodyRecipe huge;
    huge.resolution = 1'000'000;
    body.recipe = huge;
    QVERIFY(taskIn(taskFile(body)).failure);
    SpaceRecipe space; // whose camera has no pixels
    space.size = {10, 10};
    body.recipe = space;
    body.path = QStringLiteral("/somewhere/a.png");
    QVERIFY(taskIn(taskFile(body)).failure);
}

void ExportTasksTest::drawsWhatADirectExportDraws_data() {
    QTest::addColumn<QByteArray>("entry");
    const QByteArray maps = " .5 0 0 .5 0 0 .3\n .5 0 0 .5 .5 0 .3\n .4 -.3 .3 .4 .2 .5 .4\n";
    QTest::newRow("plain") << "a {\n" + maps + "}\n";
    document::Fractal coloured = document::sierpinskiTriangle();
    coloured.appearance.colourBy = attractor::ColourBy::Map;
    coloured.appearance.mapColours[document::system2(coloured)->maps[1].id] = {9, 200, 30, 255};
    coloured.appearance.background = {40, 10, 90, 255};
    coloured.appearance.gamma = 1.7;
    document::plane(coloured)->cage = document::canonicalCage(coloured);
    document::plane(coloured)->cage->current[0].x() += 0.123456789;
    QTest::newRow("with colours and a moved cage") << writeEntry(coloured);
}

// The entry goes through its text and back.
void ExportTasksTest::drawsWhatADirectExportDraws() {
    QFETCH(const QByteArray, entry);
    const document::Fractal fractal = *readFractint(entry).entries.first().fractal;
    for (const char* name : {"a.png", "a.tiff", "a.exr", "a.svg"}) {
        ExportTask task = pixelTask(m_folder.filePath(QLatin1String(name)));
        task.entry = writeEntry(fractal);
        task.mayReplace = true;
        PixelRecipe pixels;
        pixels.camera = camera(80, 60);
        pixels.isTransparent = true;
        pixels.supersample = 2;
        pixels.cage = CageVisibility::Shown;
        if (task.path.endsWith(QStringLiteral(".tiff"))) pixels.file = PictureFile::Tiff;
        if (task.path.endsWith(QStringLiteral(".exr"))) pixels.file = PictureFile::ExrHalf;
        if (pixels.file == PictureFile::ExrHalf) pixels.depth = PictureFormat::Depth::Bits16;
        task.recipe = pixels;
        ShapeRecipe shapes;
        shapes.camera = pixels.camera;
        if (task.path.endsWith(QStringLiteral(".svg"))) task.recipe = shapes;
        const TaskJob::Outcome outcome = drawn(*taskIn(taskFile(task)).task);
        QVERIFY2(!outcome.failure && !outcome.stopped, name);
        const QString direct = m_folder.filePath(QStringLiteral("direct"));
        QVERIFY(!exportTo(exportOf(task.recipe, fractal), direct).failure);
        QVERIFY(!contents(direct).isEmpty());
        QCOMPARE(contents(task.path), contents(direct));
    }
}

void ExportTasksTest::replacesOnlyWhatWasAskedAbout() {
    const QString path = m_folder.filePath(QStringLiteral("taken.png"));
    QFile mine(path);
    QVERIFY(mine.open(QIODevice::WriteOnly) && mine.write("mine") == 4);
    mine.close();
    ExportTask task = pixelTask(path);
    const TaskJob::Outcome refused = drawn(task);
    QVERIFY(refused.failure && refused.isTaken);
    QCOMPARE(contents(path), QByteArray("mine"));
    task.mayReplace = true;
    QVERIFY(!drawn(task).failure);
    QCOMPARE(QImage(path).size(), QSize(96, 64));
}

void ExportTasksTest::pausesAndStops() {
    using namespace std::chrono_literals;
    QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("quiet")));
    const QString path = m_folder.filePath(QStringLiteral("quiet/large.png"));
    ExportTask task = pixelTask(path, 3000, 2000);
    std::get<PixelRecipe>(task.recipe).samplesPerPixel = 2000;
    std::atomic<int> steps = 0;
    std::promise<TaskJob::Outcome> outcome;
    std::future<TaskJob::Outcome> finished = outcome.get_future();
    {
        TaskJob job(
            task, [&](double) { ++steps; }, [&](const TaskJob::Outcome& found) { outcome.set_value(found); });
        QTRY_VERIFY_WITH_TIMEOUT(steps > 0, 60000);
        job.setPaused(true);
        int before = -1;
        QTRY_VERIFY_WITH_TIMEOUT(std::exchange(before, steps.load()) == steps, 60000);
        const int paused = steps;
        ExportTask other = task;
        other.path = m_folder.filePath(QStringLiteral("other.png"));
        std::atomic<int> otherSteps = 0;
        {
            const TaskJob running(
                other, [&](double) { ++otherSteps; }, [](const TaskJob::Outcome&) {});
            QTRY_VERIFY_WITH_TIMEOUT(otherSteps > 3, 60000); // meanwhile
        }
        QVERIFY(steps <= paused + 1); // the step under way comes to its end
        job.setPaused(false);
        QTRY_VERIFY_WITH_TIMEOUT(steps > paused + 1, 60000);
        job.setPaused(true); // and goes like this
    }
    QVERIFY(finished.wait_for(0s) == std::future_status::ready);
    QVERIFY(finished.get().stopped);
    QVERIFY(QDir(m_folder.filePath(QStringLiteral("quiet")))
                .isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
}

// Nothing is told to who has gone, and it is stopped once the drive answers.
void ExportTasksTest::aDriveThatDoesNotAnswerHoldsNobodyUp() {
    const auto answer = std::make_shared<std::promise<void>>();
    const auto wasStopped = std::make_shared<std::promise<bool>>();
    const auto told = std::make_shared<std::atomic<int>>(0);
    std::promise<void> begun;
    {
        const ExportWork work([=, &begun](const std::stop_token& stop, document::Listener& listener) {
            listener.tell([&] { ++*told; });
            begun.set_value();
            answer->get_future().wait();
            listener.tell([&] { ++*told; });
            wasStopped->set_value(stop.stop_requested());
        });
        begun.get_future().wait();
    }
    QCOMPARE(*told, 1);
    answer->set_value();
    QVERIFY(wasStopped->get_future().get());
    QCOMPARE(*told, 1);
}

void ExportTasksTest::anEntryThatCannotBeReadIsSaid() {
    ExportTask task = pixelTask(m_folder.filePath(QStringLiteral("unread.png")));
    for (const char* entry : {"", "a { this is no fractal }", "}{}{", "\0\0\0"}) {
        task.entry = entry;
        QVERIFY(drawn(task).failure);
        QVERIFY(!QFileInfo::exists(task.path));
    }
    task.entry = writeEntry(document::sierpinskiTriangle()); // of the plane, for a body
    task.recipe = BodyRecipe();
    task.path = m_folder.filePath(QStringLiteral("unread.stl"));
    QVERIFY(drawn(task).failure);
}

void ExportTasksTest::filesBelongToTheirOwner() {
    const QString folder = m_folder.filePath(QStringLiteral("own/exports"));
    ::umask(0);
    TaskFolder tasks(folder);
    const QString id = TaskFolder::newId();
    QVERIFY(tasks.write(id, pixelTask(QStringLiteral("/somewhere/a.png"))));
    ::umask(022);
    const QStringList files = QDir(folder).entryList(QDir::Files);
    QCOMPARE(files.size(), 2); // with its lock
    for (const QString& file : files) {
        struct stat facts {};
        QCOMPARE(::stat(qPrintable(folder + u'/' + file), &facts), 0);
        QCOMPARE(facts.st_mode & 0777, mode_t(0600));
    }
    struct stat facts {};
    QCOMPARE(::stat(qPrintable(folder), &facts), 0);
    QCOMPARE(facts.st_mode & 0777, mode_t(0700));
    tasks.remove(id);
    QVERIFY(QDir(folder).entryList(QDir::Files).isEmpty());
}

// A process that ends while a read hangs destroys nothing, and leaves its locks. In a container the next one
// may have its number.
void ExportTasksTest::locksOfTheDeadHoldNothing() {
    const QString folder = m_folder.filePath(QStringLiteral("dead"));
    QString id;
    {
        TaskFolder dead(folder);
        id = TaskFolder::newId();
        QVERIFY(dead.write(id, pixelTask(QStringLiteral("/somewhere/a.png"))));
    }
    const QString name = QFileInfo(QCoreApplication::applicationFilePath()).fileName();
    const auto leave = [&](const QString& path) {
        QFile lock(path);
        return lock.open(QIODevice::WriteOnly) &&
               lock.write(QByteArray::number(QCoreApplication::applicationPid()) + '\n' + name.toUtf8() +
                          '\n' + QSysInfo::machineHostName().toUtf8() + "\n\n\n") > 0;
    };
    QVERIFY(leave(folder + u'/' + id + QStringLiteral(".export.lock")));
    QVERIFY(leave(folder + QStringLiteral("/gone.export.lock"))); // of a task that is done
    {
        TaskFolder next(folder);
        QCOMPARE(next.takeOver().tasks.size(), 1);
        QCOMPARE(QDir(folder).entryList(QDir::Files).size(), 2); // the task with its lock
    }
    QCOMPARE(QDir(folder).entryList(QDir::Files).size(), 1);
}

void ExportTasksTest::aLivingProcessKeepsItsTasks() {
    const QString folder = m_folder.filePath(QStringLiteral("living"));
    TaskFolder later(folder);
    {
        TaskFolder first(folder);
        for (const int place : {3, 1, 2}) {
            ExportTask task = pixelTask(QStringLiteral("/somewhere/%1.png").arg(place));
            task.place = place;
            QVERIFY(first.write(TaskFolder::newId(), task));
        }
        QVERIFY(later.takeOver().tasks.isEmpty());
    }
    const TaskFolder::TakenOver taken = later.takeOver();
    QVERIFY(taken.skipped.isEmpty());
    QCOMPARE(taken.tasks.size(), 3);
    for (int k = 0; k < 3; ++k)
        QCOMPARE(taken.tasks[k].task.path, QStringLiteral("/somewhere/%1.png").arg(k + 1));
    QVERIFY(later.takeOver().tasks.isEmpty()); // they are its own now
    QVERIFY(TaskFolder(folder).takeOver().tasks.isEmpty());
    QVERIFY(later.write(taken.tasks[0].id, taken.tasks[0].task));
    for (const TaskFolder::Found& found : taken.tasks)
        later.remove(found.id);
    QVERIFY(QDir(folder).entryList(QDir::Files).isEmpty());
}

// They start at the same moment.
void ExportTasksTest::twoProcessesNeverHaveTheSame() {
    for (int round = 0; round < 20; ++round) {
        const QString folder = m_folder.filePath(QStringLiteral("race%1").arg(round));
        {
            TaskFolder gone(folder);
            for (int k = 0; k < 6; ++k)
                QVERIFY(
                    gone.write(TaskFolder::newId(), pixelTask(QStringLiteral("/somewhere/%1.png").arg(k))));
        }
        TaskFolder a(folder), b(folder);
        TaskFolder::TakenOver ofA, ofB;
        {
            const std::jthread one([&] { ofA = a.takeOver(); });
            const std::jthread other([&] { ofB = b.takeOver(); });
        }
        QSet<QString> paths;
        for (const auto& tasks : {ofA.tasks, ofB.tasks})
            for (const TaskFolder::Found& found : tasks) {
                QVERIFY2(!paths.contains(found.task.path), "two processes would draw it");
                paths.insert(found.task.path);
            }
        QVERIFY(ofA.skipped.isEmpty() && ofB.skipped.isEmpty());
        for (const TaskFolder::Found& found : TaskFolder(folder).takeOver().tasks)
            paths.insert(found.task.path); // each left to the other
        QCOMPARE(paths.size(), 6);
    }
}

void ExportTasksTest::whatIsNoTaskIsSkipped() {
    const QString folder = m_folder.filePath(QStringLiteral("skipped"));
    {
        TaskFolder gone(folder);
        QVERIFY(gone.write(QStringLiteral("good"), pixelTask(QStringLiteral("/somewhere/good.png"))));
        QVERIFY(gone.write(QStringLiteral("damaged"), pixelTask(QStringLiteral("/somewhere/bad.png"))));
    }
    QFile damaged(folder + QStringLiteral("/damaged.export"));
    QVERIFY(damaged.open(QIODevice::ReadWrite) && damaged.seek(100) && damaged.write("#") == 1);
    damaged.close();
    QCOMPARE(::mkfifo(qPrintable(folder + QStringLiteral("/pipe.export")), 0600), 0);
    QVERIFY(QFile::link(QStringLiteral("/etc/passwd"), folder + QStringLiteral("/link.export")));
    QFile half(folder + QStringLiteral("/good.export.Xy12Ab")); // of a process that was killed
    QVERIFY(half.open(QIODevice::WriteOnly) && half.write("half") == 4);
    half.close();
    TaskFolder tasks(folder);
    const TaskFolder::TakenOver taken = tasks.takeOver();
    QCOMPARE(taken.tasks.size(), 1);
    QCOMPARE(taken.tasks.first().task.path, QStringLiteral("/somewhere/good.png"));
    QCOMPARE(taken.skipped.size(), 3);
    for (const QString& sentence : taken.skipped)
        QVERIFY(sentence.contains(folder));
    QVERIFY(!half.exists());
    QVERIFY(QFileInfo::exists(QStringLiteral("/etc/passwd")));
    QVERIFY(TaskFolder(folder).takeOver().skipped.isEmpty()); // it is said once
}

BARYCAGE_TEST(ExportTasksTest, QGuiApplication);
#include "export_tasks_test.moc"
