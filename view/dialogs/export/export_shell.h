// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/export_recipe.h"

#include <QDialog>

#include <functional>
#include <memory>
#include <optional>

class QBoxLayout;
class QDialogButtonBox;
class QLabel;
class QPushButton;

namespace view {

class ExportProgress;
class ExportQueue;

// What all dialogs have in common that write a file: the buttons, Esc, the progress, and what came of it.
// The work goes on in a thread of the model while the window is used; closing the dialog stops it.
class ExportShell : public QDialog {
    Q_OBJECT

public:
    ~ExportShell() override;

    // What Export does once a file is chosen, and somebody has been asked whether to replace it.
    virtual void exportTo(const QString& path) = 0;
    void addToQueue(const QString& path);
    void setQueue(ExportQueue* queue); // which outlives it; without one, there is no Add to Queue
    QString message() const;           // what came of it
    bool canExport() const;
    bool isBusy() const { return bool(m_stop); }

signals:
    void exported(const QString& path);
    void queued(); // the export was added
    void failed(const QString& sentence);

protected:
    explicit ExportShell(QWidget* parent);

    // Lays the options out, beside or above what shows what they do, and message, progress and buttons below.
    void lay(QWidget* options, QWidget* preview, Qt::Orientation orientation);
    void setStartHelp(const QString& text) const;
    QPushButton* addButton(const QString& text, const QString& help) const; // between Export and Close
    QPushButton* addQueueButton(const QString& help);

    // Asks for a file. Empty: none was chosen, or something has to be put right first.
    virtual QString chosenFile() = 0;
    // What is put into the queue under this name; nullopt where that cannot be, which has then been said.
    virtual std::optional<io::ExportRecipe> recipeFor(const QString& path);
    virtual const document::Fractal* queuedFractal() const { return nullptr; }
    virtual bool isPossible() const { return true; } // whether the options make sense
    virtual bool isQueueable() const { return true; }
    virtual QString sentenceFor(const io::ExportOutcome& outcome, const QString& path) const;
    virtual void whenFinished() {} // once it is idle again, before the outcome is said

    void say(const QString& sentence); // empty: nothing; with room for it
    virtual void escape();             // what Esc does: as the button, it stops before it closes
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enableButtons();
    void start(io::Export what, const QString& path, const QString& firstStep = {});
    // The same with work that somebody else does: `stop` ends it, and finish() is called once it has ended.
    void begin(std::function<void()> stop, const QString& firstStep = {});
    void setFraction(double fraction);
    void finish(const io::ExportOutcome& outcome, const QString& path);
    void offerFolderOf(const QString& path); // of what was written

private:
    void closeOrStop();

    QWidget* m_options = nullptr;
    QLabel* m_message = nullptr;
    ExportProgress* m_progress = nullptr;
    QDialogButtonBox* m_buttons = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_enqueue = nullptr;
    QPushButton* m_close = nullptr;
    QPushButton* m_showInFolder = nullptr; // visible once something was written
    QString m_written;                     // what it shows
    ExportQueue* m_queue = nullptr;
    std::function<void()> m_stop;         // while it works
    std::unique_ptr<io::ExportJob> m_job; // last: stops before the rest goes
};

} // namespace view
