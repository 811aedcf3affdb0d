// SPDX-License-Identifier: MIT
#include "session_fixture.h"
#include "support/patient_tries.h"

#include <QCoreApplication>
#include <QTranslator>

namespace {

// 175 %, as a desktop sets it before the program starts: icons and margins grow with the letters.
const bool isLarge = qputenv("QT_FONT_DPI", "168");

} // namespace

// A small screen of 1366 by 768 pixels, of which the title of the window takes some.
class LargeDpiTest : public SessionFixture {
    Q_OBJECT

private slots:
    void theWindowFitsTheScreen_data();
    void theWindowFitsTheScreen();
};

void LargeDpiTest::theWindowFitsTheScreen_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "de", "es", "fr", "mk"})
        QTest::newRow(language) << QString::fromLatin1(language);
}

void LargeDpiTest::theWindowFitsTheScreen() {
    QFETCH(QString, language);
    QVERIFY(isLarge);
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/translations/barycage_%1.qm").arg(language)));
    QVERIFY(QCoreApplication::installTranslator(&translator));
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    QVERIFY(window->fontMetrics().height() > 20); // 14 at 100 %
    const QSize needed = window->minimumSizeHint();
    QVERIFY2(needed.width() <= 1366 && needed.height() <= 728,
             qPrintable(QStringLiteral("%1 x %2").arg(needed.width()).arg(needed.height())));
    window->resize(1366, 728);
    QTRY_COMPARE(window->size(), QSize(1366, 728));
    closeWindows();
}

QTEST_MAIN(LargeDpiTest)
#include "large_dpi_test.moc"
