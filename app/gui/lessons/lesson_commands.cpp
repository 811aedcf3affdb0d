// SPDX-License-Identifier: MIT
#include "lessons/lesson_commands.h"

#include "desktop/preferences.h"
#include "docks/panels.h"
#include "document/lesson/shown_step.h"
#include "document/text/unique_names.h"
#include "files/file_commands.h"
#include "files/open_file.h"
#include "files/recent_files.h"
#include "io/file/background.h"
#include "io/file/named_path.h"
#include "io/file/slow_disk.h"
#include "io/fractint/fractint_reader.h"
#include "io/lesson/lesson_writer.h"
#include "messages/save_question.h"
#include "messages/written_banner.h"
#include "panels/lesson/lesson_panel.h"
#include "panels/lesson/lesson_print.h"
#include "stage/stage.h"
#include "widgets/background/save_beside.h"
#include "widgets/background/wait_for.h"
#include "widgets/file_dialogs.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QUndoStack>

#include <optional>
#include <utility>

namespace {

struct BuiltIn {
    const char* name;
    const char* title;
};

constexpr BuiltIn builtIn[] = {
    {"chaos_game", QT_TRANSLATE_NOOP("MainWindow", "The Chaos Game")},
    {"maple_triangle", QT_TRANSLATE_NOOP("MainWindow", "Why the Maple Fits Its Triangle")},
};

QByteArray resource(const QString& name) {
    QFile file(QStringLiteral(":/lessons/") + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

struct LessonReading {
    io::Failure failure;
    io::LessonFile lesson;  // valid if there is no failure
    QString fractals;       // path; empty if the file is missing or elsewhere
    bool isForeign = false; // true: outside the folder of the lesson, not examined
};

QString referenceTo(const QString& fractals, const QString& lesson) {
    return QFileInfo(lesson).absoluteDir().relativeFilePath(QFileInfo(fractals).absoluteFilePath());
}

QString absolutePath(const QString& lesson, const QString& reference) {
    return QDir::cleanPath(QFileInfo(lesson).absoluteDir().absoluteFilePath(reference));
}

// The path of the fractals: as the lesson says, or beside it when both have been moved. Empty if they are in
// neither place.
QString fractalsOf(const QString& lesson, const QString& reference) {
    const QDir folder = QFileInfo(lesson).absoluteDir();
    for (const QString& file : {reference, QFileInfo(reference).fileName()}) {
        const QString path = QDir::cleanPath(folder.filePath(file));
        if (QFileInfo::exists(path)) return path;
    }
    return {};
}

// The file that is open needs no question.
QFuture<LessonReading> readBeside(const QString& path, const QString& openFile) {
    return io::inBackground<LessonReading>(
        io::Lane::Reading, [path, openFile](QPromise<LessonReading>& promise) {
            LessonReading reading;
            const io::Loaded loaded = io::loadFile(path);
            reading.failure = loaded.failure;
            if (!loaded.failure) reading.lesson = io::readLesson(loaded.bytes);
            const QString& reference = reading.lesson.lesson.file;
            reading.isForeign = !io::liesInside(QFileInfo(path).absolutePath(), reference) &&
                                absolutePath(path, reference) != openFile;
            if (!reference.isEmpty() && !reading.isForeign) reading.fractals = fractalsOf(path, reference);
            promise.addResult(std::move(reading));
        });
}

} // namespace

LessonCommands::LessonCommands(const MenuContext& context, const LessonParts& parts, QAction* presentation)
    : ActionMenu(context, tr("&Lesson")),
      m_parts(parts),
      m_notebook(new view::LessonNotebook(this)),
      m_panel(new view::LessonPanel(m_notebook)),
      m_player(new LessonPlayer(parts, presentation)) {
    setToolTipsVisible(true);
    createActions();
    connectPanel();
    connect(m_player, &LessonPlayer::problem, this, [this](const QString& sentence) {
        this->context().messages->say(sentence);
        this->context().canvas->setHint(sentence);
    });
}

void LessonCommands::createActions() {
    QAction* play = add(
        {"play-lesson",
         tr("&Play Lesson"),
         {},
         tr("Play the lesson in full screen, from the beginning or from the step you clicked in the list"),
         nullptr,
         false,
         "play"},
        [this] { this->play(); });
    QAction* next = add({"next-step", tr("&Next Step"), QKeySequence(Qt::Key_PageDown),
                         tr("Show the next step of the lesson being played")},
                        [this] { m_player->showStep(m_player->step() + 1); });
    QAction* back = add({"previous-step", tr("Previous &Step"), QKeySequence(Qt::Key_PageUp),
                         tr("Show the previous step of the lesson being played")},
                        [this] { m_player->showStep(m_player->step() - 1); });
    addSeparator();
    add({"add", tr("&Add Step"), {}, tr("Add a step to the lesson, with the current state of the window")},
        [this] { addStep(); });
    QAction* save = add({"save-lesson",
                         tr("Save &Lesson…"),
                         {},
                         tr("Save the lesson as a text that refers to its fractals"),
                         nullptr,
                         false,
                         "save"},
                        [this] { this->save(); });
    QAction* saveAs = add({"save-lesson-as",
                           tr("Sa&ve Lesson As…"),
                           {},
                           tr("Save the lesson under another name or in another folder")},
                          [this] { this->saveAs(); });
    QAction* print = add({"print-lesson",
                          tr("Pr&int Lesson…"),
                          {},
                          tr("Print the steps of the lesson, with their pictures and texts"),
                          nullptr,
                          false,
                          "print"},
                         [this] { this->print(); });
    const auto update = [this, play, next, back, save, saveAs, print] {
        print->setEnabled(!m_notebook->lesson().steps.isEmpty());
        play->setEnabled(!m_notebook->lesson().steps.isEmpty() && !m_player->isPlaying());
        for (QAction* saving : {save, saveAs})
            saving->setEnabled(!m_notebook->isEmpty() && !m_player->isPlaying());
        next->setEnabled(m_player->isPlaying());
        back->setEnabled(m_player->isPlaying());
    };
    connect(m_notebook, &view::LessonNotebook::changed, play, update);
    connect(m_player, &LessonPlayer::playingChanged, play, update);
    connect(m_notebook, &view::LessonNotebook::changed, this, [this] {
        if (!m_dock) return;
        const bool isUnsaved = m_notebook->isModified() && !m_notebook->isEmpty();
        const QString& title = factsOf(Panel::Lesson).title;
        m_dock->setWindowTitle(isUnsaved ? title + u'*' : title);
        m_dock->toggleViewAction()->setText(title); // of the menu
    });
    update();
}

void LessonCommands::connectPanel() {
    using view::LessonPanel;
    connect(m_panel, &LessonPanel::addRequested, this, &LessonCommands::addStep);
    connect(m_panel, &LessonPanel::updateRequested, this, [this] {
        document::LessonState state = lessonState(m_parts);
        if (const auto* step = m_notebook->currentStep()) state.panels = step->state.panels;
        m_notebook->setState(state);
        context().messages->say(tr("The step now has the current state of the window."));
    });
    connect(m_panel, &LessonPanel::showRequested, this, [this] {
        const auto* step = m_notebook->currentStep();
        if (!step || m_player->isPlaying()) return;
        if (const QString problem = showLessonState(m_parts, step->state); !problem.isEmpty())
            context().messages->say(problem);
    });
    connect(m_panel, &LessonPanel::playRequested, this, &LessonCommands::play);
    connect(m_panel, &LessonPanel::saveRequested, this, [this] { save(); });
    connect(m_notebook, &view::LessonNotebook::changed, this, [this] {
        m_isGivenUp = false;
        if (m_named.isEmpty()) m_named = namedEntries();
    });
}

void LessonCommands::setFiles(FileCommands* commands, OpenFile* file) {
    m_commands = commands;
    m_file = file;
    commands->setLessons({[this](const QString& path) { return open(path); }, [this] { return maybeSave(); },
                          [this] {
                              if (!m_player->isPlaying()) return false;
                              context().canvas->setHint(tr("End the lesson before you save (Esc)."));
                              return true;
                          },
                          [this](const QString& ofFile) { follow(ofFile); },
                          [this] { return m_notebook->isModified() && !m_notebook->isEmpty(); }});
    connect(context().document, &document::Document::changed, this, [this](const document::Change& change) {
        if (change.parts & document::Change::File && !m_isOpening)
            QMetaObject::invokeMethod(
                this, [this] { fileChanged(); }, Qt::QueuedConnection);
    });
    connect(context().document, &document::Document::changed, this, &LessonCommands::followNames);
    connect(file, &OpenFile::pathChanged, this, [this] {
        if (!m_isOpening && m_filePath.isEmpty() && !m_notebook->isEmpty()) m_filePath = m_file->path();
    });
}

// An entry that is renamed stays the one that steps show.
void LessonCommands::followNames(const document::Change& change) {
    using document::Change;
    const bool areNames = change.parts & (Change::Name | Change::Entries | Change::File);
    if (change.live || m_named.isEmpty() || !areNames) return;
    const QHash<QString, document::EntryId> before = std::exchange(m_named, namedEntries());
    if (change.parts & Change::File) return;
    QHash<document::EntryId, QString> formerly;
    for (auto named = before.cbegin(); named != before.cend(); ++named)
        formerly.insert(named.value(), named.key());
    QHash<QString, QString> renamed;
    for (const document::Entry& entry : context().document->file().entries) {
        const QString old = formerly.value(entry.id);
        const QString name = document::lessonLine(entry.fractal->name);
        if (!old.isEmpty() && old != name) renamed.insert(old, name);
    }
    m_notebook->followRenamed(renamed);
}

// The entry that steps with a name show: the first; none without a lesson.
QHash<QString, document::EntryId> LessonCommands::namedEntries() const {
    QHash<QString, document::EntryId> named;
    if (m_notebook->isEmpty()) return named;
    for (const document::Entry& entry : context().document->file().entries)
        if (const QString name = document::lessonLine(entry.fractal->name); !named.contains(name))
            named.insert(name, entry.id);
    return named;
}

void LessonCommands::setPanels(const Panels& panels) {
    m_dock = panels.dock(Panel::Lesson);
    QList<QPair<QString, QString>> offered;
    for (const auto& [panel, id] : ifs::names<Panel>)
        if (panels.dock(panel) && panel != Panel::Lesson && panel != Panel::Problems)
            offered.append({QLatin1String(id), factsOf(panel).title});
    m_panel->setPanels(offered);
}

// Steps that nobody saved stay until the user gives them up: they may be all that is left.
void LessonCommands::fileChanged() {
    const bool isSame = !m_filePath.isEmpty() && m_file->path() == m_filePath;
    if (isSame || m_isOpening || (m_notebook->isModified() && !m_isGivenUp)) return;
    m_filePath = m_file->path();
    m_builtIn.clear();
    if (!m_notebook->isEmpty()) m_notebook->open({}, {});
}

bool LessonCommands::isUnused() const {
    return m_file->path().isEmpty() && context().document->undoStack()->count() == 0 &&
           m_notebook->isEmpty() && !m_player->isPlaying();
}

bool LessonCommands::adopt(const LessonPlace& place, const QString& name, io::LessonFile read) {
    const auto fail = [&](const QString& sentence) {
        context().messages->fail(tr("%1 could not be opened").arg(name), sentence);
        return false;
    };
    if (read.lesson.steps.isEmpty()) return fail(read.problems.first().message);
    if (read.lesson.file.isEmpty())
        return fail(tr("The lesson names no file of fractals (“file: name.ifs”)."));
    const QScopedValueRollback<bool> opening(m_isOpening, true);
    if (place.lesson.isEmpty()) {
        m_file->startFrom(io::readFractint(resource(read.lesson.file)), document::EntryId::None);
    } else if (!m_commands->open(place.fractals)) {
        return false;
    }
    m_builtIn.clear();
    m_filePath = m_file->path();
    const document::Problems problems = read.problems;
    m_notebook->open(std::move(read.lesson), place.lesson);
    if (place.isOther) m_notebook->moveTo(referenceTo(place.fractals, place.lesson));
    if (!problems.isEmpty()) context().messages->say(document::toText(problems.first(), name));
    return true;
}

bool LessonCommands::open(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    QFuture<LessonReading> work = readBeside(path, m_file->path());
    const QPointer<LessonCommands> self(this);
    if (!view::waitFor(QFuture<void>(work), tr("Reading “%1”…").arg(name), m_parts.window)) return false;
    if (!self) return false;
    LessonReading reading = work.takeResult();
    if (reading.failure) {
        context().messages->fail(tr("%1 could not be opened").arg(name), *reading.failure);
        return false;
    }
    const document::Lesson& lesson = reading.lesson.lesson;
    if (reading.fractals.isEmpty() && !lesson.file.isEmpty() && !lesson.steps.isEmpty()) {
        reading.isForeign ? askForForeign(path, std::move(reading.lesson))
                          : offerToFind(path, std::move(reading.lesson));
        return false;
    }
    return openWith(reading.fractals, path, std::move(reading.lesson));
}

bool LessonCommands::openWith(const QString& fractals, const QString& path, io::LessonFile lesson) {
    if (!adopt({path, fractals}, QFileInfo(path).fileName(), std::move(lesson))) return false;
    recent_files::add(path);
    showPanel();
    showFirstEntry();
    return true;
}

// That of the step which is current in the list.
void LessonCommands::showFirstEntry() {
    const document::LessonStep* step = m_notebook->currentStep();
    const document::Entry* entry =
        step ? document::entryOf(context().document->file(), step->state) : nullptr;
    if (entry) context().document->setCurrent(entry->id);
}

void LessonCommands::showPanel() {
    if (!m_dock) return;
    m_dock->show();
    m_dock->raise();
}

// A lesson from a stranger could name any collection of the user.
void LessonCommands::askForForeign(const QString& path, io::LessonFile lesson) {
    const QString named = absolutePath(path, lesson.lesson.file);
    auto* box = new QMessageBox(QMessageBox::Warning, QApplication::applicationDisplayName(),
                                tr("%1 names a file outside its folder.").arg(QFileInfo(path).fileName()),
                                QMessageBox::Cancel, m_parts.window);
    box->setInformativeText(tr("Its fractals are in “%1”. Open that file only if you trust the lesson.")
                                .arg(QDir::toNativeSeparators(named)));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* open = box->addButton(tr("&Open It"), QMessageBox::AcceptRole);
    open->setObjectName(QStringLiteral("open"));
    box->setDefaultButton(QMessageBox::Cancel);
    const auto agree = [this, path, lesson = std::move(lesson)] {
        const QPointer<LessonCommands> self(this);
        const QString& reference = lesson.lesson.file;
        QFuture<QString> found =
            io::inBackground<QString>(io::Lane::Asking, [path, reference](QPromise<QString>& promise) {
                promise.addResult(fractalsOf(path, reference));
            });
        const QString label = tr("Reading “%1”…").arg(QFileInfo(reference).fileName());
        if (!view::waitFor(QFuture<void>(found), label, self->m_parts.window) || !self) return;
        if (const QString fractals = found.result(); fractals.isEmpty())
            offerToFind(path, lesson);
        else
            openWith(fractals, path, lesson);
    };
    // Queued until the question has closed.
    connect(open, &QPushButton::clicked, this, agree, Qt::QueuedConnection);
    box->open();
}

// The file of its fractals is not there: perhaps it has another name now, or is elsewhere.
void LessonCommands::offerToFind(const QString& path, io::LessonFile lesson) {
    const QString name = QFileInfo(path).fileName();
    auto* box =
        new QMessageBox(QMessageBox::Warning, QApplication::applicationDisplayName(),
                        tr("%1 could not be opened").arg(name) + u'.', QMessageBox::Cancel, m_parts.window);
    box->setInformativeText(tr("The file of its fractals, “%1”, was not found. It may have been renamed or "
                               "moved.")
                                .arg(lesson.lesson.file));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* find = box->addButton(tr("&Find…"), QMessageBox::AcceptRole);
    find->setObjectName(QStringLiteral("find"));
    box->setDefaultButton(find);
    const auto choose = [this, window = m_parts.window, path, lesson = std::move(lesson)] {
        const QPointer<LessonCommands> self(this);
        const QString found =
            view::chooseFileToOpen(window, tr("Find “%1”").arg(lesson.lesson.file),
                                   tr("Fractint collections (*.ifs *.par)"), QFileInfo(path).path());
        if (found.isEmpty() || !self || !adopt({path, found, true}, QFileInfo(path).fileName(), lesson))
            return;
        recent_files::add(path);
        showPanel();
        showFirstEntry();
        context().messages->say(tr("The lesson now refers to %1. Save the lesson to keep this change.")
                                    .arg(QFileInfo(found).fileName()));
    };
    // Queued until the question has closed.
    connect(find, &QPushButton::clicked, this, choose, Qt::QueuedConnection);
    box->open();
}

void LessonCommands::recover(const QByteArray& lesson, const QString& path) {
    io::LessonFile read = io::readLesson(lesson);
    if (read.lesson.steps.isEmpty() && read.lesson.title.isEmpty()) return;
    m_filePath = m_file->path();
    m_notebook->open(std::move(read.lesson), path);
    m_notebook->history()->resetClean(); // not saved yet
    showPanel();
}

void LessonCommands::showBuiltIn(const QString& name, int step) {
    const QString language = view::Preferences::stored().language;
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    QByteArray bytes = resource(name + u'.' + locale.name().section(u'_', 0, 0) + QStringLiteral(".lesson"));
    if (bytes.isEmpty()) bytes = resource(name + QStringLiteral(".lesson"));
    if (!adopt({}, name, io::readLesson(bytes))) return;
    m_builtIn = name;
    m_player->play(m_notebook->lesson(),
                   std::clamp<int>(step, 0, int(m_notebook->lesson().steps.size()) - 1));
}

namespace {

const QString builtInKey = QStringLiteral("ready-made"), lessonKey = QStringLiteral("lesson"),
              stepKey = QStringLiteral("step");

} // namespace

QVariantMap LessonCommands::restartPlace() const {
    QVariantMap place;
    if (!m_builtIn.isEmpty()) place.insert(builtInKey, m_builtIn);
    if (!m_notebook->path().isEmpty()) place.insert(lessonKey, m_notebook->path());
    if (!place.isEmpty() && m_player->isPlaying()) place.insert(stepKey, m_player->step());
    return place;
}

bool LessonCommands::returnTo(const QVariantMap& place) {
    const QString builtIn = place.value(builtInKey).toString(), path = place.value(lessonKey).toString();
    if (!builtIn.isEmpty()) {
        showBuiltIn(builtIn, place.value(stepKey).toInt());
        if (!place.contains(stepKey)) m_player->stop();
        return true;
    }
    if (path.isEmpty()) return false;
    if (open(path) && place.contains(stepKey))
        m_player->play(m_notebook->lesson(), place.value(stepKey).toInt());
    return true;
}

void LessonCommands::addBuiltIn(QMenu* menu, const std::function<LessonCommands*()>& window) {
    for (const auto& [name, title] : builtIn) {
        QAction* action = menu->addAction(tr(title));
        action->setData(QLatin1String(name));
        action->setStatusTip(tr("Play this lesson, in a window of its own if this one is in use"));
        action->setWhatsThis(
            tr("Plays this lesson in full screen, with its text next to the picture. Page Down and "
               "Page Up go to the next and the previous step. Esc ends the lesson."));
        action->setToolTip(action->statusTip());
        connect(action, &QAction::triggered, this, [this, window, name = QLatin1String(name)] {
            (isUnused() ? this : window())->showBuiltIn(name);
        });
    }
}

bool LessonCommands::maybeSave() {
    m_player->stop();
    if (!m_notebook->isModified() || m_notebook->isEmpty()) return true;
    const QString& title = m_notebook->lesson().title;
    switch (askToSave(m_parts.window, tr("Unsaved lesson"),
                      title.isEmpty() ? tr("The lesson has unsaved changes.")
                                      : tr("The lesson “%1” has unsaved changes.").arg(title))) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        m_isGivenUp = true;
        return true;
    default:
        return false;
    }
}

bool LessonCommands::isReadyToSave() const {
    return !m_notebook->isEmpty() && !m_player->isPlaying();
}

// The lesson refers to the file of its fractals. Those that have none yet get one of the same name, so that
// only the lesson is asked for; a file that is there already is left alone.
bool LessonCommands::saveWithFractals(const QString& lesson) {
    if (!m_file->path().isEmpty()) return saveTo(lesson);
    const QFileInfo info(lesson);
    const QString base = info.dir().filePath(info.completeBaseName());
    QString path = base + QStringLiteral(".ifs");
    constexpr int mostTries = 100;
    for (int k = 2; k < mostTries && io::answerSoon([path] { return QFile::exists(path); }).value_or(true);
         ++k)
        path = QStringLiteral("%1-%2.ifs").arg(base).arg(k);
    const std::optional<QString> saved = m_commands->saveTo(path);
    return saved && saveTo(lesson, *saved);
}

// One command saves both, once it is known where the lesson belongs: beside these fractals.
void LessonCommands::follow(const QString& ofFile) {
    if (m_notebook->isEmpty() || !m_notebook->isModified()) return;
    const QString& path = m_notebook->path();
    if (path.isEmpty() || absolutePath(path, m_notebook->lesson().file) != m_file->path())
        context().messages->say(ofFile + u' ' + tr("The lesson is not saved yet: choose Save Lesson."));
    else
        saveTo(path, ofFile);
}

bool LessonCommands::save() {
    const QString path = m_notebook->path();
    if (path.isEmpty()) return saveAs();
    return isReadyToSave() && saveWithFractals(path);
}

bool LessonCommands::saveAs() {
    if (!isReadyToSave()) return false;
    const bool hasFile = !m_file->path().isEmpty();
    const QFileInfo fractals(m_file->path());
    QString suggestion = m_notebook->path();
    if (suggestion.isEmpty()) {
        const QString& title = m_notebook->lesson().title;
        const QString name = !title.isEmpty() ? title
                             : hasFile        ? fractals.completeBaseName()
                                              : document::uniqueName({}, context().document->fractal().name);
        const QString suggested = view::suggestedName(name, QStringLiteral("lesson"));
        suggestion = hasFile ? fractals.dir().filePath(suggested) : suggested;
    }
    const QString path = view::chooseFileToSave(m_parts.window, tr("Save Lesson"), suggestion,
                                                tr("Lessons (*.lesson)"), QStringLiteral("lesson"));
    return !path.isEmpty() && saveWithFractals(path);
}

bool LessonCommands::saveTo(const QString& path, const QString& before) {
    const QString name = QFileInfo(path).fileName();
    const QString reference = referenceTo(m_file->path(), path);
    if (!document::isLessonFile(reference)) {
        context().messages->fail(tr("The lesson was not saved"),
                                 tr("A lesson cannot refer to “%1”. Save the fractals as a .ifs file first, "
                                    "with no : * ? \" < > | in "
                                    "its name and folders.")
                                     .arg(QDir::toNativeSeparators(reference)));
        return false;
    }
    m_notebook->setFile(reference);
    const QPointer<LessonCommands> self(this);
    const auto [saving, outcome] =
        saveKeeping(path, io::writeLesson(m_notebook->lesson()), m_parts.window, m_file->versions());
    if (!self || saving.isCancelled) return false;
    if (saving.failure) {
        context().messages->fail(tr("%1 was not saved").arg(name), *saving.failure);
        return false;
    }
    m_notebook->markSaved(path);
    m_filePath = m_file->path();
    recent_files::add(path);
    QString sentence = before.isEmpty() ? before : before + u' ';
    sentence += tr("Saved %1.").arg(name);
    if (const QString previous = remarkOn(outcome, name); !previous.isEmpty()) sentence += u' ' + previous;
    if (context().document->isModified()) sentence += u' ' + tr("The fractals have unsaved changes.");
    context().messages->say(sentence);
    return true;
}

void LessonCommands::addStep() {
    if (m_player->isPlaying()) return;
    m_notebook->addStep(lessonState(m_parts));
    if (!m_dock) return;
    showPanel();
    m_panel->beginToWrite();
    context().messages->say(tr("Step %1 has the current state of the window. Now write its text.")
                                .arg(m_notebook->current() + 1));
}

void LessonCommands::print() {
    const document::FractalFile& file = m_player->isPlaying() ? m_player->file() : context().document->file();
    view::printLesson(m_notebook->lesson(), file, m_parts.window,
                      [context = context()](const QString& sentence, const QString& path) {
                          context.messages->say(sentence);
                          WrittenBanner::offerPrinted(context.window, *context.document, path);
                      });
}

void LessonCommands::play() {
    m_player->play(m_notebook->lesson(), m_notebook->firstToPlay());
}
