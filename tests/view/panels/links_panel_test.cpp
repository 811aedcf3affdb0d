// SPDX-License-Identifier: MIT
#include "panels/links/links_panel.h"

#include "document/edits/maps_edits.h"
#include "ifs/links/linked_systems.h"
#include "panels/links/links_model.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

using namespace Qt::StringLiterals;
using view::LinksModel;
using view::LinksPanel;

namespace {

void show(document::Document& document, const document::System2& system) {
    document::Fractal fractal;
    fractal.name = u"linked"_s;
    fractal.shape = document::Shape<2>{system};
    document.setFile(document::fileOf(fractal));
}

QString text(const LinksPanel& panel, int row, int column) {
    return panel.model()->index(row, column).data().toString();
}

} // namespace

class LinksPanelTest : public QObject {
    Q_OBJECT

private slots:
    void showsTheMatrix();
    void anEditIsOneStep();
    void refusesWhatIsNoWeight();
    void marksWhatTakesNoPart();
    void followsTheMaps();
    void removesAll();
    void notInSpace();
};

void LinksPanelTest::showsTheMatrix() {
    document::Document document;
    show(document, linked_systems::threeOnALine());
    const LinksPanel panel(&document);
    QCOMPARE(panel.model()->rowCount(), 3);
    QCOMPARE(panel.model()->columnCount(), 4);
    QCOMPARE(text(panel, 0, 0), u"0"_s);
    QCOMPARE(text(panel, 0, 1), u"1"_s);
    QCOMPARE(text(panel, 0, 3), u"Takes part"_s);
    QVERIFY(!(panel.model()->index(0, 3).flags() & Qt::ItemIsEditable));
    QVERIFY(panel.model()->index(0, 2).flags() & Qt::ItemIsEditable);
    QVERIFY(panel.model()->index(0, 1).data(Qt::AccessibleTextRole).toString().contains(u"map 2"_s));
}

void LinksPanelTest::anEditIsOneStep() {
    document::Document document; // the Sierpiński triangle
    LinksPanel panel(&document);
    const document::Fractal before = document.fractal();
    QVERIFY(panel.model()->setData(panel.model()->index(0, 2), u"1/4"_s));
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(document.undoStack()->undoText(), u"Link map 1 to map 3"_s);
    QCOMPARE(ifs::linkMatrix(*document::system2(document.fractal()))[2], 0.25);
    QCOMPARE(text(panel, 0, 2), u"0.25"_s);
    QVERIFY(panel.model()->setData(panel.model()->index(0, 2), u"0.25"_s)); // no step
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QVERIFY(document.fractal() == before);
    QCOMPARE(text(panel, 0, 2), u"1"_s);
}

void LinksPanelTest::refusesWhatIsNoWeight() {
    document::Document document;
    LinksPanel panel(&document);
    QSignalSpy messages(&panel, &LinksPanel::message);
    for (const QString& typed : {u"-1"_s, u"x"_s, u""_s, u"1e999"_s, u"nan"_s})
        QVERIFY2(!panel.model()->setData(panel.model()->index(0, 0), typed), qPrintable(typed));
    QCOMPARE(messages.count(), 5);
    QCOMPARE(document.undoStack()->count(), 0);
}

void LinksPanelTest::marksWhatTakesNoPart() {
    document::Document document;
    auto system = linked_systems::threeOnALine();
    ifs::setLinks(system, std::vector<double>{1, 1, 0, 0, 0, 0, 1, 0, 0});
    show(document, system);
    const LinksPanel panel(&document);
    QCOMPARE(text(panel, 0, 3), u"Takes part"_s);
    QVERIFY(text(panel, 1, 3).startsWith(u"Ends"_s));
    QVERIFY(text(panel, 2, 3).startsWith(u"Unreached"_s));
    ifs::setLinks(system, std::vector<double>(9, 0));
    show(document, system);
    QVERIFY(panel.findChild<QLabel*>()->text().contains(u"comes to an end"_s));
}

void LinksPanelTest::followsTheMaps() {
    document::Document document;
    show(document, linked_systems::threeOnALine());
    const LinksPanel panel(&document);
    document::duplicateMaps(document, {2});
    QCOMPARE(panel.model()->rowCount(), 4);
    QCOMPARE(text(panel, 3, 0), u"1"_s);
    QCOMPARE(text(panel, 0, 3), u"0"_s);
    document::deleteMaps(document, {2});
    QCOMPARE(panel.model()->rowCount(), 3);
    QCOMPARE(text(panel, 2, 2), u"1"_s);
    document.undoStack()->undo();
    document.undoStack()->undo();
    QCOMPARE(text(panel, 2, 1), u"0"_s);
}

void LinksPanelTest::removesAll() {
    document::Document document;
    show(document, linked_systems::rauzy());
    const LinksPanel panel(&document);
    auto* remove = panel.findChild<QPushButton*>();
    QVERIFY(remove->isEnabled());
    remove->click();
    QVERIFY(document::system2(document.fractal())->links.empty());
    QCOMPARE(document.undoStack()->count(), 1);
    QVERIFY(!remove->isEnabled());
}

void LinksPanelTest::notInSpace() {
    document::Document document;
    document::Fractal fractal;
    document::Shape<3> shape;
    ifs::append(shape.system, ifs::AffineMap<3>{ifs::Matrix<3>::Identity() / 2, ifs::Vector<3>::Zero()});
    fractal.shape = shape;
    document.setFile(document::fileOf(fractal));
    const LinksPanel panel(&document);
    QCOMPARE(panel.model()->rowCount(), 0);
    QVERIFY(panel.findChild<QLabel*>()->text().contains(u"space"_s));
}

QTEST_MAIN(LinksPanelTest)
#include "links_panel_test.moc"
