// SPDX-License-Identifier: MIT
// Another program to drag files from: drag_source FILE... shows a small window at the lower left of the
// screen and says "ready" when it is there. What is dragged out of it are the files.
#include <QApplication>
#include <QDrag>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QTimer>
#include <QUrl>

#include <cstdio>

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
        const Qt::DropAction action = drag->exec(Qt::CopyAction | Qt::MoveAction, Qt::CopyAction);
        std::printf("%s\n", action == Qt::CopyAction ? "copied" : "not taken");
        std::fflush(stdout);
    }
};

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    Source source(QStringLiteral("Files"));
    source.setAlignment(Qt::AlignCenter);
    source.setGeometry(0, 860, 160, 60);
    source.setWindowFlag(Qt::FramelessWindowHint);
    source.show();
    QTimer::singleShot(400, [] {
        std::puts("ready");
        std::fflush(stdout);
    });
    return QApplication::exec();
}
