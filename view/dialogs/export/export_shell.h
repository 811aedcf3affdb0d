// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/export/last_export.h"
#include "io/exports/export_recipe.h"
#include "io/file/export_work.h"

#include <QDialog>

#include <QMessageBox>
#include <QPointer>

#include <functional>
#include <memory>
#include <optional>

class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace view {

class ExportProgress;
class ExportQueue;

// Base of all dialogs that write a file: the buttons, Esc, the chooser of the file, the progress and the
// outcome. The work goes on in a thread of the model while the window is used; closing the dialog stops it.
class ExportShell : public QDialog {
    Q_OBJECT

public:
    ~ExportShell() override;

    // Exports to a chosen file, after the user has agreed to replace an existing one.
    virtual void exportTo(const QString& path) = 0;
    void addToQueue(const QString& path);
    void setQueue(ExportQueue* queue); // must outlive the dialog; without a queue there is no Add to Queue
    QString message() const;           // outcome for the user
    bool canExport() const;
    bool isBusy() const { return bool(m_work); }
    bool mayClose();                           // asks the user during an export
    void suggestFolderOf(const QString& path); // default before the first export, if the folder is writable

signals:
    void exported(const QString& path);
    void queued(); // sent when the export has been added to the queue
    void failed(const QString& sentence);

protected:
    // Exports of one kind begin as the last one: dialogs/export/last_export.h. The file is named after the
    // entry.
    ExportShell(const QString& kind, const QString& entry, QWidget* parent);

    // Lays out the options beside or above their preview, and message, progress and buttons below.
    void lay(QWidget* options, QWidget* preview, Qt::Orientation orientation);
    void lay(QFormLayout* options, QWidget* preview, Qt::Orientation orientation);
    void setStartHelp(const QString& text) const;
    QPushButton* addButton(const QString& text, const QString& help) const; // placed between Export and Close
    QPushButton* addQueueButton(const QString& help);
    void addAnimationButton(); // named “animation”; the window has the dialog that it leads to

    // Asks for a file. Empty: none was chosen, or something has to be put right first.
    virtual QString chosenFile() = 0;
    struct WantedFile {
        QString title;                             // title of the chooser
        QString suffix;                            // default suffix of the format
        QString filter = {};                       // empty: files with `suffix`
        std::function<QString(QString)> name = {}; // name to suggest; null: name of the entry
        bool asksToReplace = true;
    };
    QString chooseFile(const WantedFile& wanted);
    LastExport last() const { return lastExport(m_kind); }
    void remember(const LastExport& last, const QString& path) const { rememberExport(m_kind, last, path); }
    // The recipe to queue under this name; nullopt if it cannot be queued, after the user was told why.
    virtual std::optional<io::ExportRecipe> recipeFor(const QString& path);
    virtual const document::Fractal* queuedFractal() const { return nullptr; }
    virtual bool isPossible() const { return true; } // false if the options contradict each other
    virtual bool isQueueable() const { return true; }
    virtual QString sentenceFor(const io::ExportOutcome& outcome, const QString& path) const;
    // Texts of mayClose(): the export under way, and the effect of stopping it.
    struct Unfinished {
        QString sentence;
        QString ifStopped;
    };
    virtual Unfinished unfinished() const;
    virtual void whenFinished() {} // called when the dialog is idle again, before the outcome is shown

    void say(const QString& sentence); // makes room for the sentence; empty: none
    virtual void escape();             // handler of Esc, which like the button stops before it closes
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enableButtons();
    using Work = std::function<io::ExportOutcome(const io::Progress& progress, const std::stop_token& stop)>;
    void start(Work work, const QString& path, const QString& firstStep = {}); // runs in a background thread
    void start(io::Export what, const QString& path, const QString& firstStep = {});
    void writeText(const QByteArray& text, const QString& path); // writes synchronously
    void finish(const io::ExportOutcome& outcome, const QString& path);
    void offerFolderOf(const QString& path); // folder of the written file

private:
    void closeOrStop();

    QString m_kind;
    QString m_entry;
    QString m_folder;
    QWidget* m_options = nullptr;
    QLabel* m_message = nullptr;
    ExportProgress* m_progress = nullptr;
    QDialogButtonBox* m_buttons = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_enqueue = nullptr;
    QPushButton* m_animation = nullptr;
    QPushButton* m_close = nullptr;
    QPushButton* m_showInFolder = nullptr; // enabled once something was written
    QString m_written;                     // path of the written file
    ExportQueue* m_queue = nullptr;
    QPointer<QMessageBox> m_question;       // asks whether to stop; closed when the work ends
    std::unique_ptr<io::ExportWork> m_work; // last member: its thread uses the others
};

} // namespace view
