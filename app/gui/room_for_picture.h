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

    void windowShown(bool isAsItWasLeft); // true if the user's own layout was restored
    void windowResized(const QSize& before);
    // However small the window is, before its layout is stored; false: none was hidden.
    bool showHiddenPanels();
    bool isSmall() const; // true if the window is too small for panels on the left

signals:
    void hidden(const QStringList& titles);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QList<QDockWidget*> panels() const;
    QList<QDockWidget*> columns() const; // one panel from each side
    void hideLeftPanels();
    void rememberWidths();
    void divide();

    QMainWindow* m_window;
    const QWidget* m_picture;
    QSize m_size;              // size of the window after the layout of its panels
    bool m_hasYielded = false; // true if panels have been narrowed
    QHash<int, int> m_widths;  // widths chosen by the user, by Qt::DockWidgetArea
};
