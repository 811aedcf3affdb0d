// SPDX-License-Identifier: MIT
#include "io/text/xml_text.h"

#include "io/exchange/flame.h"
#include "io/picture/vector/svg_system.h"
#include "support/named_test.h"

#include <QTest>

class XmlTextTest : public QObject {
    Q_OBJECT

private slots:
    void limits_data();
    void limits();
    void encodings();
    void readersAskIt();
};

void XmlTextTest::limits_data() {
    QTest::addColumn<QByteArray>("xml");
    QTest::addColumn<QString>("says"); // empty: nothing stands in the way
    const auto row = [](const char* name, const QByteArray& xml, const char* says = "") {
        QTest::newRow(name) << xml << QString::fromUtf8(says);
    };
    const auto attributes = [](int count) {
        QByteArray tag = "<a";
        for (int i = 0; i < count; ++i)
            tag += " a" + QByteArray::number(i) + "=''";
        return tag + "/>";
    };
    row("nothing", "");
    row("1000 deep", QByteArray("<a>").repeated(1000) + QByteArray("</a>").repeated(1000));
    row("1001 deep", QByteArray("<a>").repeated(1001), "1000 levels deep");
    row("one after the other", "<b>" + QByteArray("<a></a><c/>").repeated(2000) + "</b>");
    row("1000 attributes", attributes(1000));
    row("1001 attributes", attributes(1001), "1000 attributes");
    row("signs in values", "<a b='" + QByteArray("=").repeated(5000) + "'/>");
    row("brackets in values", "<a b='" + QByteArray("<a>").repeated(5000) + "'/>");
    row("brackets in comments", "<!--" + QByteArray("<a>").repeated(5000) + "-->");
    row("quotes in comments hide nothing", "<!-- <a ' -->" + attributes(1001), "1000 attributes");
    row("quotes in data hide nothing", "<![CDATA[ <a ' ]]>" + attributes(1001), "1000 attributes");
    row("quotes in instructions hide nothing", "<?a '?>" + attributes(1001), "1000 attributes");
    row("a tag that never ends", "<a" + QByteArray(" =").repeated(5000), "1000 attributes");
    row("64 MB", QByteArray(64 * 1024 * 1024 + 1, ' '), "64 MB");
}

void XmlTextTest::limits() {
    QFETCH(QByteArray, xml);
    QFETCH(QString, says);
    const io::XmlText text = io::xmlText(xml);
    if (says.isEmpty()) {
        QVERIFY2(!text.failure, qPrintable(text.failure.value_or(QString())));
        QCOMPARE(text.text, QString::fromUtf8(xml));
    } else {
        QVERIFY(text.failure && text.text.isEmpty());
        QVERIFY2(text.failure->contains(says), qPrintable(*text.failure));
    }
}

void XmlTextTest::encodings() {
    QCOMPARE(io::xmlText("<a b='\xc3\xa4'/>").text, QStringLiteral("<a b='ä'/>"));
    QCOMPARE(io::xmlText("<a b='\xe4'/>").text, QStringLiteral("<a b='ä'/>"));
    // What a file says of its encoding does not change what its bytes mean.
    const auto file = io::readFlame("<?xml version='1.0' encoding='UTF-16'?><flame name='a'>"
                                    "<xform weight='1' linear='1' coefs='.5 0 0 .5 0 0'/></flame>");
    QCOMPARE(file.entries.size(), 1);
}

void XmlTextTest::readersAskIt() {
    const QByteArray deep = QByteArray("<a>").repeated(1001);
    const auto flame = io::readFlame("<flame>" + deep);
    QVERIFY(flame.entries.isEmpty());
    QVERIFY(flame.problems.value(0).message.contains(QStringLiteral("1000 levels deep")));
    const auto svg = io::readSvgSystem("<svg>" + deep);
    QVERIFY(svg.failure && svg.failure->contains(QStringLiteral("1000 levels deep")));
}

BARYCAGE_TEST(XmlTextTest);
#include "xml_text_test.moc"
