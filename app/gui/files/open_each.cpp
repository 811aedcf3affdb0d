// SPDX-License-Identifier: MIT
#include "files/open_each.h"

#include "document/text/text.h"
#include "files/file_commands.h"
#include "io/file/background.h"
#include "io/file/save_file.h"
#include "session/session.h"

#include <QDeadlineTimer>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSet>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <utility>

namespace {

using namespace std::chrono_literals;

constexpr auto untilLate = 100ms;     // shorter waits are not reported
constexpr auto untilNobodysTurn = 1s; // a file that hangs does not delay the next one longer
constexpr int readAtOnce = 4;
constexpr qsizetype unasked = 8; // windows opened without a question

// Checks whether the lesson can be read: the window reads it with its fractals.
FileReading tryLesson(const QString& path) {
    return io::inBackground<ReadFile>(io::Lane::Reading, [path](QPromise<ReadFile>& promise) {
        io::loadFile(path);
        promise.addResult(ReadFile{});
    });
}

} // namespace

QList<WantedFile> wanted(const QStringList& paths) {
    QList<WantedFile> files;
    for (const QString& path : paths)
        files << WantedFile{path, {}};
    return files;
}

QStringList askWhichToOpen(const QStringList& paths, QWidget* parent) {
    if (paths.size() <= unasked) return paths;
    QMessageBox box(QMessageBox::Question, OpenEach::tr("Open"),
                    OpenEach::tr("Open %n files?", nullptr, int(paths.size())), QMessageBox::Cancel, parent);
    box.setInformativeText(OpenEach::tr("Each of them opens in a window of its own."));
    QPushButton* all = box.addButton(OpenEach::tr("Open &All"), QMessageBox::AcceptRole);
    QPushButton* some =
        box.addButton(OpenEach::tr("Open the &First %1").arg(unasked), QMessageBox::AcceptRole);
    all->setObjectName(QStringLiteral("all"));
    some->setObjectName(QStringLiteral("some"));
    box.setDefaultButton(some);
    box.exec();
    return box.clickedButton() == all    ? paths
           : box.clickedButton() == some ? paths.mid(0, unasked)
                                         : QStringList();
}

struct OpenEach::Piece {
    WantedFile file;
    bool isStarted = false;
    FileReading reading;
    QFutureWatcher<ReadFile> watcher;
    QDeadlineTimer late, nobodysTurn;
    bool hasWindow = false;
    QPointer<SessionWindow> window; // set if the file is late

    bool isRead() const { return isStarted && (reading.isFinished() || reading.isCanceled()); }
    bool isLate() const { return isStarted && late.hasExpired(); }
};

OpenEach::OpenEach(const QList<WantedFile>& files, SessionWindow* first,
                   std::function<SessionWindow*()> createWindow)
    : m_unused(first), m_createWindow(std::move(createWindow)) {
    QSet<QString> seen;
    for (const WantedFile& file : files) {
        if (!file.path.isEmpty() && seen.contains(QFileInfo(file.path).absoluteFilePath())) continue;
        if (!file.path.isEmpty()) seen << QFileInfo(file.path).absoluteFilePath();
        m_left.push_back(std::make_unique<Piece>());
        m_left.back()->file = file;
    }
    // Lessons come first: they name other files, for which the window waits.
    std::stable_partition(m_left.begin(), m_left.end(),
                          [](const auto& piece) { return !isLesson(piece->file.path); });
}

OpenEach::~OpenEach() = default;

void OpenEach::run() {
    const auto count = int(m_left.size());
    const QPointer<QProgressDialog> progress = count > unasked ? showProgress(count) : nullptr;
    while (!m_left.empty() && !m_isCancelled) {
        startSome();
        if (Piece* piece = next()) {
            open(*piece);
            std::erase_if(m_left, [piece](const auto& other) { return other.get() == piece; });
            if (progress) {
                progress->setValue(count - int(m_left.size()));
                progress->raise();
            }
            if (!m_left.empty()) QCoreApplication::processEvents();
        } else {
            showLate();
            waitForMore();
        }
        if (m_hasShown && session::allAreClosed()) break; // the user closed all windows meanwhile
    }
    giveUpTheRest();
    delete progress;
}

QProgressDialog* OpenEach::showProgress(int count) {
    auto* progress = new QProgressDialog(tr("Opening files…"), Text::tr("Cancel"), 0, count);
    progress->setWindowModality(Qt::NonModal);
    progress->setAutoReset(false);
    progress->setAutoClose(false);
    QObject::connect(progress, &QProgressDialog::canceled, &m_loop, [this] {
        m_isCancelled = true;
        m_loop.quit();
    });
    progress->show();
    return progress;
}

void OpenEach::giveUpTheRest() {
    for (const auto& piece : m_left) {
        piece->reading.cancel();
        if (piece->window) open(*piece);
    }
    m_left.clear();
}

void OpenEach::startSome() {
    auto underWay = std::ranges::count_if(m_left, [](const auto& piece) {
        return piece->isStarted && !piece->isRead() && !piece->nobodysTurn.hasExpired();
    });
    for (const auto& piece : m_left) {
        if (underWay >= readAtOnce) return;
        if (piece->isStarted) continue;
        const QString& path = piece->file.path;
        piece->isStarted = true;
        piece->late = QDeadlineTimer(untilLate);
        piece->nobodysTurn = QDeadlineTimer(untilNobodysTurn);
        if (path.isEmpty()) continue; // finished already
        piece->reading = isLesson(path) ? tryLesson(path) : startReading(path);
        using Watcher = QFutureWatcherBase;
        QObject::connect(&piece->watcher, &Watcher::finished, &m_loop, &QEventLoop::quit);
        QObject::connect(&piece->watcher, &Watcher::canceled, &m_loop, &QEventLoop::quit);
        piece->watcher.setFuture(piece->reading);
        ++underWay;
    }
}

OpenEach::Piece* OpenEach::next() {
    for (const auto& piece : m_left) {
        if (piece->isRead()) return piece.get();
        if (!piece->isLate()) return nullptr;
    }
    return nullptr;
}

SessionWindow* OpenEach::takeWindow() {
    SessionWindow* window = m_unused ? m_unused.data() : m_createWindow();
    m_unused = nullptr;
    window->show();
    m_hasShown = true;
    return window;
}

void OpenEach::open(Piece& piece) {
    if (piece.hasWindow && !piece.window) return; // window closed meanwhile
    const auto& [path, recovered] = piece.file;
    if (!recovered && session::showOther(path, piece.hasWindow ? piece.window : m_unused)) {
        m_hasShown = true;
        if (piece.window) piece.window->file().giveUpAwaiting();
        if (!m_unused) m_unused = piece.window;
        return;
    }
    SessionWindow* window = piece.hasWindow ? piece.window.data() : takeWindow();
    if (recovered)
        window->openRecovered(*recovered, piece.reading);
    else if (!window->openPath(path, piece.reading) && !window->file().isStopped())
        m_unused = window;
}

void OpenEach::showLate() {
    for (const auto& piece : m_left) {
        if (!piece->isLate() || piece->isRead() || piece->hasWindow) continue;
        piece->window = takeWindow();
        piece->hasWindow = true;
        piece->window->file().await(piece->file.path, QFuture<void>(piece->reading));
    }
}

void OpenEach::waitForMore() {
    std::chrono::milliseconds soon = untilNobodysTurn;
    for (const auto& piece : m_left) {
        if (!piece->isStarted) continue;
        for (const QDeadlineTimer& timer : {piece->late, piece->nobodysTurn})
            if (!timer.hasExpired())
                soon = std::min(soon, std::chrono::milliseconds(timer.remainingTime() + 1));
    }
    QTimer::singleShot(soon, &m_loop, &QEventLoop::quit);
    m_loop.exec();
}
