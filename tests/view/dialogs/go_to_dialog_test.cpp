// SPDX-License-Identifier: MIT
#include "dialogs/go_to_dialog.h"

#include "document/document.h"
#include "support/choose.h"
#include "support/named_test.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <cmath>

using view::GoToDialog;

// Where the canvas is to look, in numbers, by an address or by a fixed point.
class GoToDialogTest : public QObject {
    Q_OBJECT

private slots:
    void itBeginsWhereTheViewIs();
    void numbersMayBeExpressions();
    void anAddressLeadsToItsPoint();
    void aMapLeadsToItsFixedPoint();
    void aWrongAddressIsExplained_data();
    void aWrongAddressIsExplained();

private:
    document::Document m_document; // a Sierpiński triangle
    const attractor::View m_now{{0.125, -3.5}, 0.75, attractor::YAxis::Down, 0.5};

    static QLineEdit* field(const GoToDialog& dialog, const char* name) {
        for (auto* found : dialog.findChildren<QLineEdit*>())
            if (found->accessibleName() == QLatin1String(name)) return found;
        return nullptr;
    }
    static void type(QLineEdit* field, const QString& text) {
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    static QString note(const GoToDialog& dialog) {
        for (const auto* label : dialog.findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("Note")) return label->text();
        return {};
    }
};

void GoToDialogTest::itBeginsWhereTheViewIs() {
    const GoToDialog dialog(m_document.sharedFractal(), m_now);
    QVERIFY(dialog.view() == m_now);
}

void GoToDialogTest::numbersMayBeExpressions() {
    GoToDialog dialog(m_document.sharedFractal(), m_now);
    dialog.show();
    type(field(dialog, "Centre, x"), QStringLiteral("1/3"));
    type(field(dialog, "Centre, y"), QStringLiteral("sqrt(3)/6"));
    type(field(dialog, "Height"), QStringLiteral("1e-12"));
    QVERIFY(dialog.view());
    QCOMPARE(dialog.view()->centre.x(), 1.0 / 3);
    QCOMPARE(dialog.view()->centre.y(), std::sqrt(3) / 6);
    QCOMPARE(dialog.view()->height, 1e-12);
    QCOMPARE(dialog.view()->yAxis, m_now.yAxis);
    type(field(dialog, "Height"), QStringLiteral("0"));
    QVERIFY(!dialog.view());
    for (const auto* button : dialog.findChildren<QPushButton*>())
        if (button->isDefault()) QVERIFY(!button->isEnabled());
}

// The point whose address is 1 2 1 2 … is mapped to itself by map 1 after map 2.
void GoToDialogTest::anAddressLeadsToItsPoint() {
    GoToDialog dialog(m_document.sharedFractal(), m_now);
    dialog.show();
    type(field(dialog, "Address"), QStringLiteral("1 2"));
    const auto& maps = document::system2(m_document.fractal())->maps;
    const ifs::Vector<2> point = dialog.view()->centre;
    QVERIFY((maps[0].map(maps[1].map(point)) - point).norm() < 1e-14);
    QCOMPARE(dialog.view()->height, m_now.height);
}

void GoToDialogTest::aMapLeadsToItsFixedPoint() {
    GoToDialog dialog(m_document.sharedFractal(), m_now);
    auto* maps = dialog.findChild<QComboBox*>();
    QCOMPARE(maps->count(), 4);
    support::choose(maps, 2); // the third
    const ifs::Vector<2> point = dialog.view()->centre;
    QVERIFY((document::system2(m_document.fractal())->maps[2].map(point) - point).norm() < 1e-14);
}

void GoToDialogTest::aWrongAddressIsExplained_data() {
    QTest::addColumn<QString>("address");
    for (const char* address : {"4", "0", "x", "1 2 9"})
        QTest::newRow(address) << QString::fromLatin1(address);
}

void GoToDialogTest::aWrongAddressIsExplained() {
    QFETCH(QString, address);
    GoToDialog dialog(m_document.sharedFractal(), m_now);
    dialog.show();
    type(field(dialog, "Address"), address);
    QVERIFY2(note(dialog).contains(QStringLiteral("from 1 to 3")), qPrintable(note(dialog)));
}

BARYCAGE_TEST(GoToDialogTest, QApplication);
#include "go_to_dialog_test.moc"
