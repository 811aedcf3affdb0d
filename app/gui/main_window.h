// SPDX-License-Identifier: MIT
#pragma once

#include "analysis_bridge.h"
#include "arising.h"
#include "canvas/canvas_view.h"
#include "dialogs/mutate_dialog.h"
#include "document/document.h"
#include "io/save_file.h"
#include "open_file.h"
#include "recovery.h"
#include "render_bridge.h"

#include <QKeySequence>
#include <QMainWindow>

#include <functional>

class QActionGroup;
class QMenu;
class QMessageBox;
class QToolBar;
class StatusLine;

// A document, its canvas and its panels. Owns them all; deletes itself when closed.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    bool openPath(const QString& path); // says what went wrong
    // Each in a window of its own, the first in `first` when there is one. What cannot be opened leaves its
    // window to the next.
    static void openEach(const QStringList& paths, MainWindow* first = nullptr);
    void openRecent(const QString& path); // asks about unsaved changes first
    void chooseAndOpen();                 // likewise
    void openFirstPicture();              // the maple of the collection, without a path
    void openRecovered(const document::Abandoned& abandoned);
    void showCollection(); // ready for a search
    void addRandom();      // picked out of many

    document::Document& document() { return m_document; }
    QString path() const { return m_file.path(); } // empty while the document has no file

protected:
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void childEvent(QChildEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void createPanels();
    void explainPanels();
    void createFileActions();
    void createEditActions();
    void showPreferences();
    void pickFrom(view::MutateDialog::Source source);
    void createCageActions();
    void createViewActions();
    void createHelpActions();
    QAction* createArisingBar();
    void createBranchBar();
    void createToolBar();
    void connectDocument();

    // An action with its icon ("" for none), shortcut and status tip, in a menu and in the window.
    QAction* action(QMenu* menu, const QString& icon, const QString& text, const QKeySequence& shortcut,
                    const QString& tip);
    QAction* command(QMenu* menu, const QString& icon, const QString& text, const QKeySequence& shortcut,
                     const QString& tip, const std::function<void()>& operation);
    QAction* toggle(QMenu* menu, const QString& icon, const QString& text, const QKeySequence& shortcut,
                    const QString& tip, const QString& setting, bool initially,
                    const std::function<void(bool)>& set);
    // Where it would do nothing, it is disabled, and its tips and its key say why.
    void possibleUnless(QAction* action, QString (*obstacle)(const document::Fractal&));
    QDockWidget* dock(QWidget* panel, const QString& title, const QString& id, Qt::DockWidgetArea area);

    bool maySpoil(); // asks about unsaved changes; false: the user wants to stay
    bool save();
    bool saveAs();
    void revert();
    void reportOpened();
    void fillRecent();
    void updateTitle();
    void say(const QString& sentence); // in the status bar, for a few seconds
    void fail(const QString& title, const QString& sentence);
    void restoreLayout();
    void takeFocusFrom(const QWidget* hidden); // so that it does not go to any other field
    void makeRoomForPicture();
    void present(bool on); // the canvas alone on the screen, with the bar of its tool

    document::Document m_document;
    OpenFile m_file;
    Recovery m_recovery;
    view::RenderBridge* m_bridge;
    view::AnalysisBridge* m_analysis;
    view::Arising* m_arising;
    view::CanvasView* m_canvas;
    StatusLine* m_status;

    QMenu* m_fileMenu = nullptr;
    QMenu* m_recentMenu = nullptr;
    QMenu* m_editMenu = nullptr;
    QMenu* m_cageMenu = nullptr;
    QMenu* m_viewMenu = nullptr;
    QMenu* m_panelMenu = nullptr;
    QMenu* m_helpMenu = nullptr;
    QActionGroup* m_tools = nullptr;
    QAction* m_fullScreen = nullptr;
    QAction* m_presentation = nullptr;
    struct {
        QByteArray geometry;
        QByteArray layout; // of panels and bars
        bool fullScreen = false;
    } m_before;                       // the presentation
    QToolBar* m_branchBar = nullptr;  // under the canvas while maps or branches are dragged
    QList<QAction*> m_toolBarActions; // a null pointer is a separator
    QList<QMessageBox*> m_failures;   // the first one is seen
};
