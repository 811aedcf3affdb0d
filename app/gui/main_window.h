// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/analysis_bridge.h"
#include "bridges/construction.h"
#include "bridges/render_bridge.h"
#include "bridges/solid_bridge.h"
#include "canvas/canvas_view.h"
#include "docks/panels.h"
#include "document/document.h"
#include "files/open_each.h"
#include "files/open_file.h"
#include "files/recovery.h"
#include "session/session.h"

class ActionMenu;
class AnimationMenu;
class DiscoverMenu;
class FileCommands;
class FirstMinute;
class LessonCommands;
class QDockWidget;
class QToolBar;
class RoomForPicture;
class SnapshotCommands;
class Stage;
class StatusLine;
class TeachMenu;
class ToolBar;
class ViewMenu;
class WindowMessages;
namespace view {
class CollagePanel;
class CollectionPanel;
class MapsPanel;
class TimelinePanel;
} // namespace view

// A document, its canvas and its panels. Owns them all; deletes itself when closed.
class MainWindow : public SessionWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    bool openPath(const QString& path); // reports failures
    bool openPath(const QString& path, const FileReading& reading) override;
    OpenFile& file() override { return m_file; }
    // Files and unsaved work, in windows of this kind as files/open_each.h says.
    static void openEach(const QList<WantedFile>& files, MainWindow* first = nullptr);
    static void openEach(const QStringList& paths, MainWindow* first = nullptr);
    void openRecent(const QString& path);  // asks about unsaved changes first
    void chooseAndOpen();                  // asks about unsaved changes first
    void openFirstPicture();               // the maple of the collection, without a path
    void openLink(const QByteArray& link); // without a path; says what went wrong, beside the first picture
    bool beginFirstMinute(); // starts with that picture; false if the user has dragged a corner before
    void openRecovered(const document::Abandoned& abandoned);
    void openRecovered(const document::Abandoned& abandoned, const FileReading& reading) override;
    void showCollection(); // opens it with the focus in the search field
    void addRandom();      // adds one chosen by the user among many

    document::Document& document() { return m_document; }
    const Panels& panels() const { return m_panels; }
    QString path() const override { return m_file.path(); }
    void adopt(const view::Preferences& preferences) override;
    Recovery& recovery() override { return m_recovery; }
    bool mayClose(Leaving leaving) override;
    void closingIsOff() override { m_mayClose = false; }
    QVariantMap restartPlace() const override;
    void returnTo(const QVariantMap& place) override;

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
    void createMenus();
    void createPanels();
    void createTimeline();
    void createLesson();
    void showEntriesWithSeveral();
    void createProblems();
    void createCollage();
    void createConstructionBar();
    void createOptionsBar();
    void createToolBar();
    void connectDocument();
    QDockWidget* dock(Panel panel, QWidget* content);

    void updateTitle();
    void restoreLayout();
    void takeFocusFrom(const QWidget* hidden); // prevents the focus from moving to another field
    void present(bool on);                     // full screen with the canvas alone

    document::Document m_document;
    OpenFile m_file;
    Recovery m_recovery;
    view::RenderBridge* m_bridge;
    view::SolidBridge* m_solid;
    view::AnalysisBridge* m_analysis;
    view::Construction* m_construction;
    Stage* m_stage;
    Panels m_panels;
    RoomForPicture* m_room;
    bool m_opensFirstPicture = false;
    bool m_isAsItWasLeft = false; // true if the panels have the layout of the last run
    bool m_mayClose = false;      // true once the user has agreed
    view::CanvasView* m_canvas;   // canvas of the plane
    view::TimelinePanel* m_timeline;
    view::CollagePanel* m_collage;
    StatusLine* m_status;
    WindowMessages* m_messages;
    FileCommands* m_fileCommands;
    SnapshotCommands* m_snapshots;

    ViewMenu* m_viewMenu = nullptr;
    DiscoverMenu* m_discoverMenu = nullptr;
    TeachMenu* m_teachMenu = nullptr;
    AnimationMenu* m_animationMenu = nullptr;
    LessonCommands* m_lessons = nullptr;
    QList<ActionMenu*> m_menus;
    FirstMinute* m_firstMinute = nullptr;
    struct {
        QByteArray geometry;
        QByteArray layout; // layout of panels and bars
        bool fullScreen = false;
    } m_before; // state before the presentation
    ToolBar* m_toolBar = nullptr;
    QToolBar* m_optionsBar = nullptr; // bar under the canvas
};
