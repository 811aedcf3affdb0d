// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QStringList>
#include <QTimer>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QListView;

namespace view {

class CollectionFilter;
class CollectionModel;
class Thumbnails;

// The bundled collection and the user's own folders of .ifs files, by theme, to browse and search. It opens
// nothing itself.
class CollectionPanel : public QWidget {
    Q_OBJECT

public:
    explicit CollectionPanel(QWidget* parent = nullptr);

    void addFolder(const QString& folder); // remembered in the settings
    void removeFolder(const QString& folder);
    QStringList folders() const { return m_folders; }

signals:
    void openRequested(const document::Fractal& fractal); // as a document of its own
    void addRequested(const document::Fractal& fractal);  // to the open file

protected:
    bool event(QEvent* event) override;

private:
    struct Unread {
        QString path;
        QString folder;
    };

    void createGrid();
    void createActions();
    QAction* createAction(const QString& text, const QString& statusTip, const QString& iconName,
                          const QList<QKeySequence>& keys);
    QWidget* createButtons();
    void showContextMenu(const QPoint& position);
    void queue(const QStringList& paths, const QString& folder);
    void readNext();
    void chooseFolder();
    void saveFolders() const;
    void updateActions();
    void chooseFound();
    void sayWhyEmpty();
    const document::Fractal* current() const;

    Thumbnails* m_thumbnails;
    CollectionModel* m_model;
    CollectionFilter* m_filtered;
    QLineEdit* m_search;
    QListView* m_grid;
    QLabel* m_whyEmpty;
    QAction* m_open = nullptr;
    QAction* m_add = nullptr;
    QAction* m_favourite = nullptr;
    QAction* m_onlyFavourites = nullptr;
    QAction* m_addFolder = nullptr;
    QStringList m_folders;
    QList<Unread> m_unread; // files still to be read, one per turn of the event loop
    QTimer m_readTimer;
};

} // namespace view
