// SPDX-License-Identifier: MIT
#include "main_window.h"

#include "files/file_commands.h"
#include "files/open_each.h"
#include "first_minute.h"
#include "first_picture.h"
#include "io/collection_reader.h"
#include "lessons/lesson_commands.h"
#include "messages/window_messages.h"
#include "panels/timeline/timeline_panel.h"
#include "stage/stage.h"

#include <QAction>
#include <QFileInfo>
#include <QScopedValueRollback>

#include <utility>

// Opening of a window and its first content.

void MainWindow::openFirstPicture() {
    FirstPicture first = firstPicture();
    if (first.file.entries.isEmpty()) return;
    {
        const QScopedValueRollback opening(m_opensFirstPicture, true);
        m_file.startFrom(std::move(first.file), first.maple);
    }
    if (FirstMinute::isOver()) return;
    if (!m_firstMinute) {
        const auto action = [this](const char* name) { return findChild<QAction*>(QLatin1String(name)); };
        m_firstMinute = new FirstMinute({this, &m_document, m_canvas, m_bridge, m_timeline->motions().front(),
                                         action("mutate"), action("export-picture")},
                                        this);
    }
    m_firstMinute->invite();
}

void MainWindow::openLink(const QByteArray& link) {
    document::FractalFile file = io::readCollection(link).file;
    if (!file.entries.isEmpty()) return m_file.startFrom(std::move(file), document::EntryId::None);
    openFirstPicture();
    m_messages->fail(tr("%1 could not be opened").arg(QStringLiteral("barycage:…")),
                     file.problems.isEmpty() ? QString() : file.problems.front().message);
}

bool MainWindow::beginFirstMinute() {
    if (!m_firstMinute || FirstMinute::isOver()) return false;
    m_firstMinute->sway();
    return true;
}

QVariantMap MainWindow::restartPlace() const {
    QVariantMap place = m_lessons->restartPlace();
    place.insert(QStringLiteral("path"), path());
    place.insert(QStringLiteral("index"), document::indexOf(m_document.file(), m_document.currentId()));
    place.insert(QStringLiteral("entry"), m_document.entryFractal().name);
    return place;
}

// The entry has its place and its name, so that none is taken for another.
void MainWindow::returnTo(const QVariantMap& place) {
    const QString path = place.value(QStringLiteral("path")).toString();
    if (path.isEmpty() || !openPath(path)) openFirstPicture();
    if (m_lessons->returnTo(place)) return;
    const auto& entries = m_document.file().entries;
    const auto index = place.value(QStringLiteral("index"), -1).toLongLong();
    if (index < 0 || index >= entries.size()) return;
    const document::Entry& entry = entries.at(index);
    if (entry.fractal->name == place.value(QStringLiteral("entry")).toString())
        m_document.setCurrent(entry.id);
}

bool MainWindow::openPath(const QString& path) {
    return m_fileCommands->open(path);
}

bool MainWindow::openPath(const QString& path, const FileReading& reading) {
    return m_fileCommands->open(path, reading);
}

void MainWindow::openRecent(const QString& path) {
    m_fileCommands->openRecent(path);
}

void MainWindow::chooseAndOpen() {
    m_fileCommands->chooseAndOpen();
}

void MainWindow::openEach(const QList<WantedFile>& files, MainWindow* first) {
    OpenEach(files, first, [] { return new MainWindow; }).run();
}

void MainWindow::openEach(const QStringList& paths, MainWindow* first) {
    openEach(wanted(paths), first);
}

void MainWindow::openRecovered(const document::Abandoned& abandoned) {
    const QString& path = abandoned.snapshot.path;
    openRecovered(abandoned, path.isEmpty() ? FileReading() : startReading(path));
}

void MainWindow::openRecovered(const document::Abandoned& abandoned, const FileReading& reading) {
    const std::optional<io::Failure> recovered = m_file.recover(abandoned.snapshot, reading);
    if (m_file.isStopped()) return;
    m_stage->fit();
    if (!recovered)
        return m_messages->say(tr("%1 was not recovered. Barycage will offer it again at the next start.")
                                   .arg(abandoned.snapshot.title));
    m_lessons->recover(abandoned.snapshot.lesson, abandoned.snapshot.lessonPath);
    m_recovery.takeOver(abandoned);
    m_messages->say(tr("Recovered %1. It is not saved yet.").arg(abandoned.snapshot.title));
    if (const io::Failure& failure = *recovered)
        m_messages->fail(tr("%1 could not be opened").arg(QFileInfo(abandoned.snapshot.path).fileName()),
                         *failure + u' ' + tr("Your unsaved work was recovered nevertheless."));
}
