// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "widgets/icon.h"

#include <QDir>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QtTest>

namespace {

// The pixel that is covered most: its colour is that of the ink.
QColor ink(const QImage& image) {
    QColor strongest(0, 0, 0, 0);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor colour = image.pixelColor(x, y);
            if (colour.alpha() > strongest.alpha()) strongest = colour;
        }
    return strongest;
}

QRect inkedArea(const QImage& image) {
    QRect area;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y).alpha() > 16) area |= QRect(x, y, 1, 1);
    return area;
}

QStringList iconNames() {
    QStringList names;
    for (const QString& file : QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")}))
        if (file != QStringLiteral("barycage.svg")) names << file.chopped(4);
    return names;
}

void setInk(const QColor& text, const QColor& disabled, const QColor& selected) {
    QPalette palette = QGuiApplication::palette();
    palette.setColor(QPalette::Active, QPalette::WindowText, text);
    palette.setColor(QPalette::Disabled, QPalette::WindowText, disabled);
    palette.setColor(QPalette::Active, QPalette::HighlightedText, selected);
    QGuiApplication::setPalette(palette);
}

} // namespace

class IconTest : public QObject {
    Q_OBJECT

private slots:
    void everyNameTheProgramUses_data();
    void everyNameTheProgramUses();
    void oneStyle_data();
    void oneStyle();
    void unknownNameIsNull();
    void takesThePaletteColourOfTheMode();
    void followsAPaletteChange();
    void isCrispAtTwiceTheResolution();
    void keepsItsShapeInAnOblongRectangle();
    void applicationIconIsReadable();
};

void IconTest::everyNameTheProgramUses_data() {
    QTest::addColumn<QString>("name");
    const QString names = QStringLiteral("cage maps branch define fit fit-simplex zoom-in zoom-out "
                                         "zoom-reset undo redo new open save save-as export "
                                         "print copy paste cut add remove duplicate up down bake reset place "
                                         "rewrite grid axes snap y-axis hide palette "
                                         "history entries collection problems warning error info transform "
                                         "weight-det weight-equal weight-dimension "
                                         "normalise rotate scale pivot search edit settings help close");
    for (const QString& name : names.split(u' '))
        QTest::newRow(qPrintable(name)) << name;
}

void IconTest::everyNameTheProgramUses() {
    QFETCH(QString, name);
    const QIcon icon = view::icon(name);
    QVERIFY(!icon.isNull());
    const QImage image = icon.pixmap(QSize(24, 24), 1.0).toImage();
    QCOMPARE(image.size(), QSize(24, 24));
    const QRect area = inkedArea(image);
    QVERIFY2(area.width() >= 14 || area.height() >= 14, "the drawing fills its square");
    QVERIFY2(QRect(1, 1, 22, 22).contains(area), "a margin of a pixel is left all round");
}

void IconTest::oneStyle_data() {
    QTest::addColumn<QString>("name");
    for (const QString& name : iconNames())
        QTest::newRow(qPrintable(name)) << name;
}

void IconTest::oneStyle() {
    QFETCH(QString, name);
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray svg = file.readAll();
    QVERIFY(QSvgRenderer(svg).isValid());
    QVERIFY(svg.contains("viewBox=\"0 0 24 24\""));
    QVERIFY(svg.contains("stroke-width=\"1.75\" stroke-linecap=\"round\" stroke-linejoin=\"round\""));
    QCOMPARE(svg.count("stroke-width"), 1);
    static const QRegularExpression colour(QStringLiteral("#[0-9a-fA-F]{3,6}"));
    auto matches = colour.globalMatch(QString::fromUtf8(svg));
    while (matches.hasNext())
        QCOMPARE(matches.next().captured(), QStringLiteral("#000"));
}

void IconTest::unknownNameIsNull() {
    QVERIFY(view::icon(QStringLiteral("no-such-icon")).isNull());
}

void IconTest::takesThePaletteColourOfTheMode() {
    setInk(QColor(10, 120, 200), QColor(150, 151, 152), QColor(250, 240, 10));
    const QIcon icon = view::icon(QStringLiteral("cage"));
    const auto inkOf = [&](QIcon::Mode mode) { return ink(icon.pixmap(QSize(48, 48), 1.0, mode).toImage()); };
    QCOMPARE(inkOf(QIcon::Normal), QColor(10, 120, 200));
    QCOMPARE(inkOf(QIcon::Active), QColor(10, 120, 200));
    QCOMPARE(inkOf(QIcon::Disabled), QColor(150, 151, 152));
    QCOMPARE(inkOf(QIcon::Selected), QColor(250, 240, 10));
}

void IconTest::followsAPaletteChange() {
    setInk(Qt::black, Qt::gray, Qt::white);
    const QIcon icon = view::icon(QStringLiteral("save"));
    QCOMPARE(ink(icon.pixmap(QSize(24, 24), 1.0).toImage()), QColor(0, 0, 0));
    setInk(QColor(230, 231, 232), Qt::gray, Qt::white);
    QCOMPARE(ink(icon.pixmap(QSize(24, 24), 1.0).toImage()), QColor(230, 231, 232));
}

// Drawn at the higher resolution, not enlarged: the picture has finer detail than the small one scaled up.
void IconTest::isCrispAtTwiceTheResolution() {
    setInk(Qt::black, Qt::gray, Qt::white);
    const QIcon icon = view::icon(QStringLiteral("settings"));
    const QPixmap twice = icon.pixmap(QSize(24, 24), 2.0);
    QCOMPARE(twice.size(), QSize(48, 48));
    QCOMPARE(twice.devicePixelRatio(), 2.0);
    QImage direct(48, 48, QImage::Format_ARGB32_Premultiplied);
    direct.fill(Qt::transparent);
    QPainter painter(&direct);
    QSvgRenderer(QStringLiteral(":/icons/settings.svg")).render(&painter, QRectF(0, 0, 48, 48));
    painter.end();
    QImage shown = twice.toImage().convertToFormat(QImage::Format_ARGB32_Premultiplied);
    shown.setDevicePixelRatio(1);
    QCOMPARE(shown, direct);
}

void IconTest::keepsItsShapeInAnOblongRectangle() {
    setInk(Qt::black, Qt::gray, Qt::white);
    QImage image(80, 24, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    view::icon(QStringLiteral("error")).paint(&painter, image.rect());
    painter.end();
    const QRect circle = inkedArea(image);
    QVERIFY(qAbs(circle.width() - circle.height()) <= 1);
    QVERIFY(qAbs(circle.center().x() - 40) <= 1);
}

// At 16 pixels the three corners and the tree still stand out from the ground.
void IconTest::applicationIconIsReadable() {
    const QImage image = QIcon(QStringLiteral(":/icons/barycage.svg")).pixmap(QSize(16, 16), 1.0).toImage();
    QCOMPARE(image.size(), QSize(16, 16));
    const int ground = qGray(image.pixel(2, 7));
    for (const QPoint& point : {QPoint(8, 2), QPoint(2, 13), QPoint(13, 13), QPoint(8, 7)})
        QVERIFY2(qGray(image.pixel(point)) > ground + 40,
                 qPrintable(QString::number(qGray(image.pixel(point)))));
}

BARYCAGE_TEST(IconTest, QApplication);
#include "icon_test.moc"
