// SPDX-License-Identifier: MIT
#include "bridges/export_queue.h"

#include "desktop/settings.h"
#include "dialogs/export/enqueue.h"
#include "io/exports/export_recipe.h"
#include "io/fractint/entry_writer.h"
#include "panels/exports/exports_delegate.h"
#include "panels/exports/exports_model.h"
#include "panels/exports/exports_panel.h"
#include "support/background_rest.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QAction>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QListView>
#include <QProcess>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

using view::ExportQueue;
using view::QueuedExport;
using State = view::QueuedExport::State;

namespace {

constexpr int soon = 60'000; // milliseconds, on a busy machine

attractor::Camera camera(int width, int height) {
    attractor::Camera view;
    view.width = width;
    view.height = height;
    return fitted(view, {0, 0}, {1, 0.9});
}

io::ExportTask task(const QString& path, int width = 96, int height = 64) {
    io::PixelRecipe recipe;
    recipe.camera = camera(width, height);
    io::ExportTask made;
    made.path = path;
    made.name = QStringLiteral("sierpinski");
    made.entry = io::writeEntry(document::sierpinskiTriangle());
    made.recipe = recipe;
    return made;
}

// Takes minutes.
io::ExportTask longTask(const QString& path) {
    io::ExportTask made = task(path, 6000, 4000);
    std::get<io::PixelRecipe>(made.recipe).samplesPerPixel = 2000;
    return made;
}

} // namespace

// Exports that are drawn one after another, and go on after the program has ended.
class ExportQueueTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        view::finishStoring(); // what the test before has stored
        support::useOwnSettings();
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("out")));
    }
    void drawsOneAfterAnother();
    void pausesAndGoesOn();
    void cancelsWhatIsDrawn();
    void saysHowLongItTakes();
    void triesAgain();
    void aNewFileIsNotReplaced();
    void ordersWhatWaits();
    void goesOnAfterTheEnd();
    void goesOnAfterAKill();
    void twoProgramsShareNothing();
    void whatEndsTheProgramIsNotTriedForEver();
    void damageIsSaid();
    void aFolderThatCannotBeWrittenIsSaid();
    void refusesTheSameFileTwice();
    void thePanelShowsAndActs();
    void failuresAreReadInFull();

private:
    QString kept() const { return m_folder->filePath(QStringLiteral("kept")); }
    QString out(const QString& name) const { return m_folder->filePath(QStringLiteral("out/") + name); }
    QStringList written() const {
        return QDir(m_folder->filePath(QStringLiteral("out")))
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    int keptFiles() const { return int(QDir(kept()).entryList({QStringLiteral("*.export")}).size()); }
    static bool isDone(const ExportQueue& queue) { return queue.unfinished() == 0; }
    static QStringList names(const ExportQueue& queue) {
        QStringList found;
        for (const QueuedExport& one : queue.exports())
            found << QFileInfo(one.task.path).completeBaseName();
        return found;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void ExportQueueTest::drawsOneAfterAnother() {
    ExportQueue queue(kept());
    int most = 0;
    connect(&queue, &ExportQueue::exportChanged, this, [&] {
        int drawing = 0;
        for (const QueuedExport& one : queue.exports())
            drawing += one.state == State::Drawing;
        most = std::max(most, drawing);
    });
    for (const char* name : {"a.png", "b.png", "c.png"})
        queue.add(task(out(QLatin1String(name))));
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
    QCOMPARE(most, 1);
    QCOMPARE(written(),
             (QStringList{QStringLiteral("a.png"), QStringLiteral("b.png"), QStringLiteral("c.png")}));
    QCOMPARE(QImage(out(QStringLiteral("b.png"))).size(), QSize(96, 64));
    for (const QueuedExport& one : queue.exports())
        QCOMPARE(one.state, State::Done);
    QTRY_COMPARE(keptFiles(), 0);
    queue.forgetDone();
    QVERIFY(queue.exports().empty());
}

void ExportQueueTest::pausesAndGoesOn() {
    ExportQueue queue(kept());
    queue.setPaused(true);
    queue.add(task(out(QStringLiteral("a.png"))));
    QVERIFY(support::backgroundRests()); // as far as it does anything
    QCOMPARE(queue.exports().front().state, State::Waiting);
    QVERIFY(written().isEmpty());
    QVERIFY(ExportQueue(kept()).isPaused()); // the next run, too
    queue.setPaused(false);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
    QCOMPARE(written(), QStringList{QStringLiteral("a.png")});
}

void ExportQueueTest::cancelsWhatIsDrawn() {
    ExportQueue queue(kept());
    queue.add(longTask(out(QStringLiteral("long.png"))));
    queue.add(task(out(QStringLiteral("short.png"))));
    QTRY_VERIFY_WITH_TIMEOUT(queue.exports().front().progress > 0, soon);
    QVERIFY(queue.exports().front().progress < 1);
    queue.cancel(queue.exports().front().id);
    QCOMPARE(queue.exports().size(), std::size_t(1));
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
    QCOMPARE(written(), QStringList{QStringLiteral("short.png")});
    QTRY_COMPARE(keptFiles(), 0);
}

// As much longer as is left to do, at the speed so far.
void ExportQueueTest::saysHowLongItTakes() {
    ExportQueue queue(kept());
    const view::ExportsModel model(&queue);
    QElapsedTimer clock;
    clock.start();
    io::ExportTask slow = longTask(out(QStringLiteral("long.png")));
    std::get<io::PixelRecipe>(slow.recipe).samplesPerPixel = 300; // the first percents come soon
    queue.add(slow);
    const auto sentence = [&] { return model.index(0).data(view::ExportsModel::SentenceRole).toString(); };
    const QueuedExport& drawn = queue.exports().front();
    QTRY_VERIFY_WITH_TIMEOUT(drawn.millisecondsLeft.has_value(), 4 * soon);
    const double left = double(*drawn.millisecondsLeft);
    const double share = (1 - drawn.progress) / drawn.progress;
    QVERIFY(drawn.progress > 0 && drawn.progress < 1);
    QVERIFY(left > 0 && left <= share * double(clock.elapsed() + 1));
    const QRegularExpression form(
        QStringLiteral("^(\\d+) %, about (\\d+) (second|minute|hour)\\(s\\) left$"));
    const QRegularExpressionMatch said = form.match(sentence());
    QVERIFY2(said.hasMatch(), qPrintable(sentence()));
    QCOMPARE(said.captured(1).toInt(), int(std::floor(100 * drawn.progress)));
    const QString unit = said.captured(3);
    const double size = unit == u"second" ? 1000 : unit == u"minute" ? 60'000 : 3'600'000;
    const double told = said.captured(2).toInt() * size;
    QVERIFY(told >= left && told < left + 1.05 * size + 1000); // rounded up
    queue.cancel(queue.exports().front().id);
    QVERIFY(queue.exports().empty());
}

void ExportQueueTest::triesAgain() {
    ExportQueue queue(kept());
    queue.add(task(m_folder->filePath(QStringLiteral("absent/a.png"))));
    queue.add(task(out(QStringLiteral("b.png")))); // goes on with the next
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
    QCOMPARE(queue.exports()[0].state, State::Failed);
    QVERIFY(queue.exports()[0].task.failure.contains(QStringLiteral("absent")));
    QCOMPARE(queue.exports()[1].state, State::Done);
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("absent")));
    queue.retry(queue.exports()[0].id);
    QTRY_COMPARE_WITH_TIMEOUT(queue.exports()[0].state, State::Done, soon);
    QVERIFY(QFileInfo::exists(m_folder->filePath(QStringLiteral("absent/a.png"))));
}

// It was not there when somebody was asked.
void ExportQueueTest::aNewFileIsNotReplaced() {
    ExportQueue queue(kept());
    queue.setPaused(true);
    const QString path = out(QStringLiteral("a.png"));
    queue.add(task(path));
    QFile other(path);
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("mine") == 4);
    other.close();
    queue.setPaused(false);
    QTRY_COMPARE_WITH_TIMEOUT(queue.exports()[0].state, State::Failed, soon);
    QCOMPARE(QFileInfo(path).size(), 4);
    queue.retry(queue.exports()[0].id);
    QTRY_COMPARE_WITH_TIMEOUT(queue.exports()[0].state, State::Done, soon);
    QVERIFY(!QImage(path).isNull());
}

void ExportQueueTest::ordersWhatWaits() {
    std::optional<ExportQueue> first(std::in_place, kept());
    ExportQueue& queue = *first;
    queue.setPaused(true);
    for (const char* name : {"a.png", "b.png", "c.png"})
        queue.add(task(out(QLatin1String(name))));
    queue.move(queue.exports()[2].id, -1);
    queue.move(queue.exports()[0].id, 1);
    queue.move(queue.exports()[0].id, -1); // it is the first
    const QStringList wanted{QStringLiteral("c"), QStringLiteral("a"), QStringLiteral("b")};
    QCOMPARE(names(queue), wanted);
    first.reset(); // its tasks are free
    ExportQueue next(kept());
    next.resume();
    QTRY_COMPARE(next.exports().size(), std::size_t(3));
    QCOMPARE(names(next), wanted);
}

void ExportQueueTest::goesOnAfterTheEnd() {
    {
        ExportQueue queue(kept());
        queue.add(longTask(out(QStringLiteral("long.png"))));
        queue.add(task(out(QStringLiteral("short.png"))));
        queue.add(task(m_folder->filePath(QStringLiteral("absent/c.png"))));
        QTRY_VERIFY_WITH_TIMEOUT(queue.exports().front().progress > 0, soon);
    }
    QVERIFY(written().isEmpty());
    std::optional<ExportQueue> second(std::in_place, kept());
    ExportQueue& queue = *second;
    QSignalSpy resumed(&queue, &ExportQueue::resumed);
    queue.resume();
    QTRY_COMPARE_WITH_TIMEOUT(queue.exports().size(), std::size_t(3), soon);
    QCOMPARE(resumed.first().first().toInt(), 3);
    QCOMPARE(queue.exports().front().state, State::Drawing); // from the beginning
    queue.cancel(queue.exports().front().id);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
    QCOMPARE(written(), QStringList{QStringLiteral("short.png")});
    // What has failed is there again, too, and can be tried.
    second.reset();
    ExportQueue third(kept());
    third.resume();
    QTRY_COMPARE_WITH_TIMEOUT(third.exports().size(), std::size_t(1), soon);
    QCOMPARE(third.exports().front().state, State::Failed);
}

// Another process that ends in the middle of a picture.
void ExportQueueTest::goesOnAfterAKill() {
    QProcess other;
    other.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("export_queue_test"), QStringLiteral("--draw"), kept(),
                 out(QStringLiteral("long.png")), out(QStringLiteral("short.png"))});
    QVERIFY(other.waitForStarted(soon));
    QVERIFY(other.waitForReadyRead(soon)); // it draws
    ExportQueue queue(kept());
    queue.resume(); // while it lives, its exports are its own
    QVERIFY(support::backgroundRests());
    QVERIFY(queue.exports().empty());
    other.kill();
    QVERIFY(other.waitForFinished(soon));
    QVERIFY(written().isEmpty());
    queue.resume();
    QTRY_COMPARE_WITH_TIMEOUT(queue.exports().size(), std::size_t(2), soon);
    QCOMPARE(names(queue), (QStringList{QStringLiteral("long"), QStringLiteral("short")}));
    QTRY_VERIFY_WITH_TIMEOUT(queue.exports().front().progress > 0, soon); // drawn again
    queue.cancel(queue.exports().front().id);
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
    QCOMPARE(written(), QStringList{QStringLiteral("short.png")});
    QTRY_COMPARE(QDir(kept()).entryList(QDir::Files), QStringList());
}

void ExportQueueTest::twoProgramsShareNothing() {
    ExportQueue gone(kept());
    gone.setPaused(true);
    for (int k = 0; k < 8; ++k)
        gone.add(task(out(QStringLiteral("%1.png").arg(k))));
    ExportQueue a(kept()), b(kept());
    a.resume();
    QVERIFY(support::backgroundRests());
    QVERIFY(a.exports().empty());
    gone.shutDown();
    QVERIFY(support::backgroundRests());
    delete new ExportQueue(kept()); // one that resumes nothing takes nothing
    a.setPaused(true);
    b.setPaused(true);
    a.resume();
    b.resume();
    QTRY_COMPARE(a.exports().size() + b.exports().size(), std::size_t(8));
    QStringList all = names(a) + names(b);
    all.sort();
    QCOMPARE(all.removeDuplicates(), 0);
}

void ExportQueueTest::whatEndsTheProgramIsNotTriedForEver() {
    {
        io::TaskFolder folder(kept());
        io::ExportTask deadly = task(out(QStringLiteral("deadly.png")));
        deadly.begun = 2;
        QVERIFY(folder.write(io::TaskFolder::newId(), deadly));
    }
    ExportQueue queue(kept());
    queue.resume();
    QTRY_COMPARE(queue.exports().size(), std::size_t(1));
    QVERIFY(support::backgroundRests());
    QCOMPARE(queue.exports().front().state, State::Failed);
    QVERIFY(written().isEmpty());
    queue.retry(queue.exports().front().id);
    QTRY_COMPARE_WITH_TIMEOUT(queue.exports().front().state, State::Done, soon);
}

void ExportQueueTest::damageIsSaid() {
    QVERIFY(QDir().mkpath(kept()));
    QFile damaged(kept() + QStringLiteral("/x.export"));
    QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write("barycage-export 1\n{}\nx") > 0);
    damaged.close();
    ExportQueue queue(kept());
    QSignalSpy said(&queue, &ExportQueue::message);
    queue.resume();
    QTRY_COMPARE(said.size(), 1);
    QVERIFY(said.first().first().toString().contains(QStringLiteral("skipped")));
    queue.add(task(out(QStringLiteral("a.png"))));
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
}

void ExportQueueTest::aFolderThatCannotBeWrittenIsSaid() {
    QFile inTheWay(kept());
    QVERIFY(inTheWay.open(QIODevice::WriteOnly)); // a file in place of the folder
    ExportQueue queue(kept());
    QSignalSpy said(&queue, &ExportQueue::message);
    queue.add(task(out(QStringLiteral("a.png"))));
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
    QCOMPARE(queue.exports().front().state, State::Done); // drawn nevertheless
    QTRY_COMPARE(said.size(), 1);
}

void ExportQueueTest::refusesTheSameFileTwice() {
    ExportQueue queue(kept());
    queue.setPaused(true);
    document::Fractal fractal = document::sierpinskiTriangle();
    io::PixelRecipe recipe;
    recipe.camera = camera(50, 40);
    QVERIFY(enqueue(queue, fractal, recipe, out(QStringLiteral("a.png"))).isAdded);
    const view::Enqueued twice =
        enqueue(queue, fractal, recipe, m_folder->filePath(QStringLiteral("out/../out/a.png")));
    QVERIFY(!twice.isAdded && twice.sentence.contains(QStringLiteral("a.png")));
    QVERIFY(!enqueue(queue, fractal, recipe, out(QStringLiteral("a.gif"))).isAdded);
    QCOMPARE(queue.exports().size(), std::size_t(1));
    // What is edited after that is not in it.
    const QByteArray entry = queue.exports().front().task.entry;
    document::system2(fractal)->maps.clear();
    QCOMPARE(queue.exports().front().task.entry, entry);
}

void ExportQueueTest::thePanelShowsAndActs() {
    ExportQueue queue(kept());
    queue.setPaused(true);
    view::ExportsPanel panel(&queue);
    panel.resize(360, 300);
    panel.show();
    QVERIFY(!panel.list()->isVisible()); // but what to do
    for (const char* name : {"a.png", "b.png"})
        queue.add(task(out(QLatin1String(name))));
    QVERIFY(panel.list()->isVisible());
    const auto action = [&](const char* name) { return support::action(panel, name); };
    QAbstractItemModel* model = panel.list()->model();
    QCOMPARE(model->index(0, 0).data().toString(), QStringLiteral("a.png"));
    QCOMPARE(model->index(0, 0).data(view::ExportsModel::SentenceRole).toString(), QStringLiteral("Paused"));
    QVERIFY(!action("cancel")->isEnabled());
    panel.list()->setCurrentIndex(model->index(1, 0));
    QVERIFY(action("up")->isEnabled() && !action("down")->isEnabled());
    action("up")->trigger();
    QCOMPARE(names(queue).first(), QStringLiteral("b"));
    QCOMPARE(panel.list()->currentIndex().row(), 0); // the same one
    QTest::keyClick(panel.list(), Qt::Key_Delete);
    QCOMPARE(names(queue), QStringList{QStringLiteral("a")});
    action("pause")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isDone(queue), soon);
    QCOMPARE(model->index(0, 0).data(view::ExportsModel::SentenceRole).toString(), QStringLiteral("Done"));
    action("clear-finished")->trigger();
    QVERIFY(queue.exports().empty() && !panel.list()->isVisible());
}

void ExportQueueTest::failuresAreReadInFull() {
    QStandardItemModel model;
    for (const State state : {State::Waiting, State::Failed}) {
        auto* item = new QStandardItem(QStringLiteral("a.png"));
        item->setData(int(state), view::ExportsModel::StateRole);
        item->setData(QStringLiteral("The file could not be written, for a reason that takes many more words "
                                     "than there is room for in one line of a narrow panel."),
                      view::ExportsModel::SentenceRole);
        model.appendRow(item);
    }
    QListView list;
    list.setModel(&model);
    list.setItemDelegate(new view::ExportsDelegate(&list));
    const auto heightAt = [&](int row, int width) {
        list.resize(width, 300);
        return list.sizeHintForIndex(model.index(row, 0)).height();
    };
    list.show();
    QVERIFY(QTest::qWaitForWindowExposed(&list));
    QCOMPARE(heightAt(0, 220), heightAt(0, 1600));
    QVERIFY(heightAt(1, 220) > heightAt(1, 1600));
    QVERIFY(heightAt(1, 220) > heightAt(0, 220) + 2 * QFontMetrics(list.font()).height());
}

namespace {

// In a process that is going to be killed.
int draw(QApplication& application, const QStringList& arguments) {
    support::useOwnSettings();
    ExportQueue queue(arguments[2]);
    QObject::connect(&queue, &ExportQueue::exportChanged, &queue, [&queue] {
        if (queue.exports().front().progress <= 0) return;
        std::puts("drawing");
        std::fflush(stdout);
    });
    queue.add(longTask(arguments[3]));
    queue.add(task(arguments[4]));
    return application.exec();
}

} // namespace

static int run(int argc, char** argv) {
    QApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == QStringLiteral("--draw") && arguments.size() == 5)
        return draw(application, arguments);
    ExportQueueTest test;
    return QTest::qExec(&test, argc, argv);
}

static const support::NamedTest namedQueue(__FILE__, run);

#include "export_queue_test.moc"
