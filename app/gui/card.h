// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <QTimer>

class QBoxLayout;
class QLabel;
class QMainWindow;

// Says something over the canvas, in its lower left corner unless told otherwise, and locks nothing. Esc
// closes it; closed, it deletes itself.
class Card : public QFrame {
    Q_OBJECT

public:
    static constexpr int cardWidth = 340;
    static constexpr int margin = 16;   // inside, and from the edge of the canvas
    static constexpr int noteRoom = 56; // at the bottom of the canvas, where it says something

    explicit Card(QMainWindow* host);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

    QLabel* createTitle();
    QBoxLayout* createButtons();  // beside each other where there is room, else below
    void follow(QWidget* widget); // is placed again when the widget moves
    void unfollow(QWidget* widget);
    void appear(const QString& announcement); // once panels and bars have found their places
    QMainWindow* host() const { return m_host; }
    QRect room() const;      // the canvas, as the window sees it
    virtual QPoint corner(); // the upper left one, where the card belongs now

private:
    void place();

    QMainWindow* m_host;
    QBoxLayout* m_buttons = nullptr;
    QTimer m_settling;
};
