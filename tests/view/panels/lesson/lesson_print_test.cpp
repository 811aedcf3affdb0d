// SPDX-License-Identifier: MIT
#include "panels/lesson/lesson_print.h"
#include "support/named_test.h"

#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrintPreviewWidget>
#include <QToolBar>

#include <algorithm>
#include <memory>

namespace {

document::Lesson lesson(int steps, const QString& text) {
    document::Lesson lesson;
    lesson.title = QStringLiteral("The Chaos Game");
    for (int i = 0; i < steps; ++i) {
        lesson.steps.append(document::LessonStep());
        lesson.steps.last().title = QStringLiteral("Step");
        lesson.steps.last().text = text;
    }
    return lesson;
}

QImage redPicture() {
    QImage picture(80, 60, QImage::Format_RGB32);
    picture.fill(Qt::red);
    return picture;
}

std::vector<QImage> pagesOf(const document::Lesson& lesson, const QList<QImage>& pictures) {
    std::vector<QImage> pages;
    QImage page(600, 850, QImage::Format_RGB32);
    page.fill(Qt::white);
    QPainter painter(&page);
    view::paintLesson(painter, QRectF(20, 20, 560, 810), lesson, pictures, [&] {
        pages.push_back(page.copy());
        page.fill(Qt::white);
    });
    painter.end();
    pages.push_back(page);
    return pages;
}

struct Ink {
    int red = 0;
    int dark = 0;
    int outside = 0; // of the page's margins
};

Ink inkOf(const QImage& page) {
    Ink ink;
    for (int y = 0; y < page.height(); ++y)
        for (int x = 0; x < page.width(); ++x) {
            const QColor colour = page.pixelColor(x, y);
            if (colour.lightness() > 200) continue;
            const bool isRed = colour.red() > 200 && colour.green() < 60;
            ink.red += isRed;
            ink.dark += !isRed;
            ink.outside += !QRect(19, 19, 563, 813).contains(x, y);
        }
    return ink;
}

} // namespace

class LessonPrintTest : public QObject {
    Q_OBJECT

private slots:
    void twoStepsFitOnAPage() {
        const auto pages = pagesOf(lesson(2, QStringLiteral("A short text.")), {redPicture(), redPicture()});
        QCOMPARE(pages.size(), 1U);
        const Ink ink = inkOf(pages.front());
        const double height = 0.34 * 810, area = height * height * 4 / 3;
        QVERIFY2(std::abs(ink.red - 2 * area) < 0.05 * area, qPrintable(QString::number(ink.red)));
        QVERIFY(ink.dark > 100);
        QCOMPARE(ink.outside, 0);
    }

    void picturesAreNotCutByPages() {
        const QList<QImage> pictures(5, redPicture());
        const auto pages = pagesOf(lesson(5, QStringLiteral("A short text.")), pictures);
        QCOMPARE(pages.size(), 3U);
        const int whole = inkOf(pages.back()).red; // one picture
        for (const QImage& page : pages) {
            QCOMPARE(inkOf(page).red % whole, 0);
            QCOMPARE(inkOf(page).outside, 0);
        }
    }

    void longTextsGoOnOnTheNextPage() {
        const QString text = QStringLiteral("Word after word after word.\n\n").repeated(130);
        const auto pages = pagesOf(lesson(1, text), {QImage()});
        QVERIFY(pages.size() >= 3);
        for (const QImage& page : pages) {
            QVERIFY(inkOf(page).dark > 50);
            QCOMPARE(inkOf(page).outside, 0);
        }
        QCOMPARE(pagesOf(lesson(0, {}), {}).size(), 1U);
    }

    void aPreviewIsShown() {
        QWidget window;
        window.show();
        document::Lesson printed = lesson(4, QStringLiteral("Text"));
        printed.title = QStringLiteral("a/b");
        printed.steps[3].state.entry = QStringLiteral("gone");
        view::printLesson(printed, document::fileOf(document::sierpinskiTriangle()), &window,
                          [](const QString&, const QString&) {});
        auto* preview = window.findChild<QPrintPreviewDialog*>();
        QVERIFY(preview && preview->isVisible());
        QVERIFY(preview->windowTitle().contains(printed.title));
        QTRY_COMPARE(preview->findChild<QPrintPreviewWidget*>()->pageCount(), 2); // two pictures, then one
        // However narrow the window is, it can be printed.
        preview->resize(preview->minimumSizeHint().width(), 500);
        const auto* bar = preview->findChild<QToolBar*>();
        const QString print = QCoreApplication::translate("QPrintPreviewDialog", "Print");
        const auto isPrint = [&print](const QAction* action) { return action->text() == print; };
        const QList<QAction*> actions = bar->actions();
        const auto printing = std::ranges::find_if(actions, isPrint);
        QVERIFY(printing != actions.end());
        QTRY_VERIFY(bar->widgetForAction(*printing)->isVisible());
        preview->reject();
    }
};

BARYCAGE_TEST(LessonPrintTest, QApplication);
#include "lesson_print_test.moc"
