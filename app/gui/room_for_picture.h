// SPDX-License-Identifier: MIT
#pragma once

#include <QHash>
#include <QObject>
#include <QSize>
#include <QStringList>

class QDockWidget;
class QMainWindow;
class QWidget;

// The panels beside the picture yield until half of the window is left to it, and take their widths back with
// the room. In a window of at most 800 by 600 pixels, where the smallest panels take more, those on the left
// are hidden meanwhile.
class RoomForPicture : public QObject {
    Q_OBJECT

public:
    RoomForPicture(QMainWindow* window, const QWidget* picture);

    void windowShown(bool isAsItWasLeft); // with the layout that the user left
    void windowResized(const QSize& before);
    // However small the window is, before its layout is stored; false: none was hidden.
    bool showHiddenPanels();
    bool isSmall() const; // too small for panels on the left

signals:
    void hidden(const QStringList& titles);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QList<QDockWidget*> panels() const;
    QList<QDockWidget*> columns() const; // one panel of each side
    void hideLeftPanels();
    void rememberWidths();
    void divide();

    QMainWindow* m_window;
    const QWidget* m_picture;
    QSize m_size;              // of the window, once its panels are laid out for it
    bool m_hasYielded = false; // the panels are not as wide as they were
    QHash<int, int> m_widths;  // by Qt::DockWidgetArea, as the user left them
};
