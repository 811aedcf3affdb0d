// SPDX-License-Identifier: MIT
// Another program to drag files from: drag_source FILE... shows a small window at the lower left of the
// screen and says "ready" when it is there. What is dragged out of it are the files.
#include <QApplication>
#include <QDrag>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QUrl>

#include <cstdio>
#include <utility>

class Source : public QLabel {
public:
    using QLabel::QLabel;

protected:
    void mousePressEvent(QMouseEvent* event) override { event->accept(); }
    void mouseMoveEvent(QMouseEvent*) override {
        QList<QUrl> files;
        for (const QString& path : QApplication::arguments().mid(1))
            files << QUrl::fromLocalFile(QFileInfo(path).absoluteFilePath());
        auto* urls = new QMimeData;
        urls->setUrls(files);
        auto* drag = new QDrag(this); // deletes itself when the other program has taken the data
        drag->setMimeData(urls);
        say("drags");
        const Qt::DropAction action = drag->exec(Qt::CopyAction | Qt::MoveAction, Qt::CopyAction);
        say(action == Qt::CopyAction ? "copied" : "not taken");
    }
    void paintEvent(QPaintEvent* event) override {
        QLabel::paintEvent(event);
        if (!std::exchange(m_isReady, true)) say("ready");
    }

private:
    static void say(const char* word) {
        std::puts(word);
        std::fflush(stdout);
    }

    bool m_isReady = false;
};

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    Source source(QStringLiteral("Files"));
    source.setAlignment(Qt::AlignCenter);
    source.setGeometry(0, 860, 160, 60);
    source.setWindowFlag(Qt::FramelessWindowHint);
    source.show();
    return QApplication::exec();
}
