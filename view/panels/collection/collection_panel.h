// SPDX-License-Identifier: MIT
#pragma once

#include "io/collection_source.h"

#include <QFutureWatcher>
#include <QStringList>
#include <QTimer>
#include <QWidget>

class QAction;
class QLineEdit;
class QProgressBar;

namespace view {

class CollectionGrid;
class CollectionModel;
class Thumbnails;

// The bundled collection and the user's own folders of .ifs files, by theme, to browse and search. It opens
// nothing itself.
class CollectionPanel : public QWidget {
    Q_OBJECT

public:
    explicit CollectionPanel(QWidget* parent = nullptr);
    ~CollectionPanel() override;

    void addFolder(const QString& folder); // stored in the settings
    void removeFolder(const QString& folder);
    QStringList folders() const { return m_folders; }
    void browse(); // opens a CollectionWindow

signals:
    // The fractal, and behind it the partner of its fractal transformation.
    void chosen(const QList<document::Fractal>& fractals);        // sent for a double click or Enter
    void openRequested(const QList<document::Fractal>& fractals); // for a document of its own
    void addRequested(const QList<document::Fractal>& fractals);  // for the open file

protected:
    bool event(QEvent* event) override;

private:
    void createGrid();
    void createActions();
    QAction* createAction(const QString& text, const QString& statusTip, const QString& iconName,
                          const QList<QKeySequence>& keys);
    QWidget* createProgress();
    void showContextMenu(const QPoint& position);
    using Watcher = QFutureWatcher<io::CollectionTheme>;
    void read(const QString& folder); // empty: bundled files
    void endReading(const Watcher* watcher);
    void showProgress(); // shows the progress of the first reading
    void updateProgress();
    void chooseFolder();
    void saveFolders() const;
    void updateActions();
    void showPart();
    void use(void (CollectionPanel::*used)(const QList<document::Fractal>&));
    QList<document::Fractal> current() const; // none, one, or one with its partner

    Thumbnails* m_thumbnails;
    CollectionModel* m_model;
    QLineEdit* m_search;
    CollectionGrid* m_grid;
    QAction* m_use = nullptr;
    QAction* m_open = nullptr;
    QAction* m_add = nullptr;
    QAction* m_favourite = nullptr;
    QAction* m_browse = nullptr;
    QAction* m_onlyFavourites = nullptr;
    QAction* m_onlyRecent = nullptr;
    QAction* m_addFolder = nullptr;
    QStringList m_folders;
    struct Reading {
        QString folder;
        Watcher* watcher;
    };
    QList<Reading> m_readings; // parallel readings, because a folder may be on a drive that does not answer
    QTimer m_patience;
    QProgressBar* m_done = nullptr;
    QWidget* m_progress; // parent of m_done; visible if reading takes long
};

} // namespace view
