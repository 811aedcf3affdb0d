// SPDX-License-Identifier: MIT
#include "panels/lesson/lesson_print.h"

#include "dialogs/export/print_preview.h"
#include "dialogs/export/printed_parts.h"
#include "document/lesson/shown_step.h"
#include "document/text/file_names.h"
#include "document/text/text.h"
#include "io/file/background.h"
#include "io/lesson/lesson_picture.h"
#include "widgets/background/wait_for.h"

#include <QPainter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>

#include <memory>
#include <stop_token>
#include <utility>

namespace view {

namespace {

constexpr QSize pictureSize(1200, 900);
constexpr int linesOnSheet = 62;
constexpr double pictureShare = 0.34; // share of the height of the page
constexpr double stepGap = 1.5;       // lines

// Writes from the top of the page down, page after page.
class LessonPages {
public:
    LessonPages(QPainter& painter, const QRectF& page, const std::function<void()>& newPage)
        : m_painter(painter),
          m_page(page),
          m_newPage(newPage),
          m_line(std::max(page.width(), page.height()) / linesOnSheet),
          m_y(page.top()) {}

    double line() const { return m_line; }
    double pictureHeight() const { return pictureShare * m_page.height(); }
    void skip(double height) { m_y += height; }

    // Begins a new page if less than `height` is left.
    void keepTogether(double height) {
        if (m_y > m_page.top() && m_y + height > m_page.bottom()) breakPage();
    }

    void write(const QString& text, double lines, bool bold) {
        QTextDocument document;
        document.setDocumentMargin(0);
        document.setDefaultFont(printedFont(m_painter, lines * m_line, bold));
        document.setPlainText(text);
        document.setTextWidth(m_page.width());
        document.size(); // forces the layout
        m_painter.setPen(Qt::black);
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
            for (int i = 0; i < block.layout()->lineCount(); ++i) {
                const QTextLine written = block.layout()->lineAt(i);
                keepTogether(written.height());
                written.draw(&m_painter, QPointF(m_page.left(), m_y - written.y()));
                m_y += written.height();
            }
    }

    void show(const QImage& picture) {
        if (picture.isNull()) return;
        QSizeF size = picture.size();
        size.scale(m_page.width(), pictureHeight(), Qt::KeepAspectRatio);
        m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
        m_painter.drawImage(QRectF(QPointF(m_page.left() + (m_page.width() - size.width()) / 2, m_y), size),
                            picture);
        m_y += size.height();
    }

private:
    void breakPage() {
        m_newPage();
        m_y = m_page.top();
    }

    QPainter& m_painter;
    QRectF m_page;
    const std::function<void()>& m_newPage;
    double m_line;
    double m_y;
};

// A picture for each step; null for those whose entry is gone. Empty when the user has changed their mind.
QList<QImage> picturesOf(const document::Lesson& lesson, const document::FractalFile& file, QWidget* parent) {
    QFuture<QList<QImage>> drawing =
        io::inBackground<QList<QImage>>([lesson, file](QPromise<QList<QImage>>& promise) {
            promise.setProgressRange(0, int(lesson.steps.size()));
            QList<QImage> pictures;
            for (const document::LessonStep& step : lesson.steps) {
                if (promise.isCanceled()) return;
                const document::Entry* entry = document::entryOf(file, step.state);
                pictures << (entry ? io::lessonPicture(
                                         onPaper(document::shownIn(step.state, *entry->fractal).fractal),
                                         step.state, pictureSize)
                                   : QImage());
                promise.setProgressValue(int(pictures.size()));
            }
            promise.addResult(std::move(pictures));
        });
    if (!waitFor(QFuture<void>(drawing), Text::tr("Drawing the pictures…"), parent)) return {};
    return drawing.takeResult();
}

} // namespace

void paintLesson(QPainter& painter, const QRectF& page, const document::Lesson& lesson,
                 const QList<QImage>& pictures, const std::function<void()>& newPage) {
    if (page.isEmpty()) return; // printer not set up
    LessonPages pages(painter, page, newPage);
    if (!lesson.title.isEmpty()) {
        pages.write(lesson.title, 1.3, true);
        pages.skip(pages.line());
    }
    constexpr double titleLines = 3, textLines = 3; // lines that stay with the picture
    for (qsizetype i = 0; i < lesson.steps.size(); ++i) {
        const document::LessonStep& step = lesson.steps[i];
        const QImage picture = pictures.value(i);
        pages.keepTogether((titleLines + textLines) * pages.line() +
                           (picture.isNull() ? 0 : pages.pictureHeight()));
        pages.write(QStringLiteral("%1.  %2").arg(i + 1).arg(step.title).trimmed(), 0.9, true);
        pages.skip(pages.line() / 2);
        pages.show(picture);
        pages.skip(pages.line() / 2);
        pages.write(step.text, 0.8, false);
        pages.skip(stepGap * pages.line());
    }
}

void printLesson(const document::Lesson& lesson, const document::FractalFile& file, QWidget* parent,
                 const PrintSaid& said) {
    const QList<QImage> pictures = picturesOf(lesson, file, parent);
    if (pictures.isEmpty()) return;
    const auto paint = [lesson, pictures](QPainter& painter, const QRectF& page,
                                          const std::function<void()>& newPage) {
        paintLesson(painter, page, lesson, pictures, newPage);
    };
    const QString name = lesson.title.isEmpty() ? Text::tr("Lesson") : lesson.title;
    showPrintPreview({Text::tr("Print “%1”").arg(name), document::fileNamePart(name), paint}, parent, said);
}

} // namespace view
