// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <QMainWindow>
#include <QTimer>

#include <optional>

class QBoxLayout;
class QLabel;

// A message over the canvas, by default in its lower left corner, which blocks nothing; what the canvas says
// itself stays beside it. It can be dragged away from what it covers. Esc closes it; it deletes itself when
// closed.
class MessageBanner : public QFrame {
    Q_OBJECT

public:
    static constexpr int usualWidth = 340; // pixels at 96 dots per inch
    static constexpr int margin = 16;      // pixels inside, and from the edge of the canvas
    static constexpr int hintHeight = 56;  // pixels kept free at the bottom of the canvas, for its hints

    explicit MessageBanner(QMainWindow* host);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

    QLabel* createTitle(const QString& text = {});
    QBoxLayout* createButtons(); // in a row, or in a column if the row is too wide
    // Title, text and two buttons at the ends of their row. An empty text takes no room.
    void lay(QLabel* title, const QString& text, QWidget* first, QWidget* last);
    void follow(QWidget* widget); // updates the geometry when the widget moves or is resized
    void unfollow(QWidget* widget);
    void placeSoon(); // once panels and bars are laid out
    // Shows the banner, once panels and bars are laid out, and has screen readers announce it.
    void appear(const QString& announcement);
    QMainWindow* host() const { return m_host; }
    QRect canvasRect() const;             // coordinates of the window
    int widest() const;                   // pixels; large letters need more
    virtual int widthFor(int room) const; // width of the banner if the canvas is `room` wide
    virtual QPoint topLeft();             // corner of the banner, in coordinates of the window
    template <class Banner> static void closeOthers(const QMainWindow* window) {
        for (Banner* old : window->findChildren<Banner*>(Qt::FindDirectChildrenOnly))
            delete old;
    }

private:
    void layOut();
    void moveInside(const QPoint& corner); // the window
    void tellCanvas();                     // the part that the banner covers

    QMainWindow* m_host;
    QBoxLayout* m_buttons = nullptr;
    QTimer m_geometryTimer;
    QPoint m_grip;                  // the part of the banner that the pointer holds
    std::optional<QPoint> m_chosen; // the place to which the user has dragged it
};
