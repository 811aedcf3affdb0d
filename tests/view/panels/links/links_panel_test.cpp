// SPDX-License-Identifier: MIT
#include "panels/links/links_panel.h"

#include "document/edits/maps/link_edits.h"
#include "document/edits/maps/maps_edits.h"
#include "ifs/links/linked_systems.h"
#include "panels/links/link_graph.h"
#include "panels/links/links_model.h"
#include "support/named_test.h"

#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolTip>

#include <cmath>
#include <cstdlib>
#include <initializer_list>

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
    void deleteForbidsTheSelectedLinksInOneStep();
    void saysWhereOnlyPointsAreDrawn();
    void refusesWhatIsNoWeight();
    void marksWhatTakesNoPart();
    void followsTheMaps();
    void removesAll();
    void notInSpace();
    void drawsAnArrowForEachLink();
    void draggingLinks();
    void draggingBackLinksAMapToItself();
    void aClickedArrowIsRemoved();
    void theKeyboardDoesTheSame();
    void graphAndTableSelectTogether();
    void theGraphSaysWhy();
    void manyArrowsAreThoseOfOneMap();
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

void LinksPanelTest::deleteForbidsTheSelectedLinksInOneStep() {
    document::Document document; // the Sierpiński triangle
    LinksPanel panel(&document);
    panel.show();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    const document::Fractal before = document.fractal();
    panel.table()->setFocus();
    panel.table()->setCurrentIndex(panel.model()->index(0, 1));
    QTest::keyClick(panel.table(), Qt::Key_Delete);
    QCOMPARE(text(panel, 0, 1), u"0"_s);
    QTest::keyClick(panel.table(), Qt::Key_Delete); // already forbidden
    panel.table()->selectAll();
    QTest::keyClick(panel.table(), Qt::Key_Backspace);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            QCOMPARE(text(panel, row, column), u"0"_s);
    document.undoStack()->undo();
    QCOMPARE(text(panel, 0, 1), u"0"_s);
    QCOMPARE(text(panel, 1, 2), u"1"_s);
    document.undoStack()->undo();
    QVERIFY(document.fractal() == before);
    QVERIFY(!document.undoStack()->canUndo());
}

void LinksPanelTest::saysWhereOnlyPointsAreDrawn() {
    document::Document document;
    const LinksPanel panel(&document);
    const auto* notice = panel.findChild<QLabel*>();
    const auto isSaid = [&] { return notice->text().contains(u"single points"_s); };
    const auto link = [&](std::initializer_list<double> weights) {
        document::Fractal fractal = document.fractal();
        int at = 0;
        for (const double weight : weights) {
            fractal = document::withLink(std::move(fractal), at / 3, at % 3, weight);
            ++at;
        }
        document.edit(u"link"_s, fractal);
    };
    QVERIFY(!isSaid());
    link({0, 1, 0, 0, 0, 1, 1, 0, 0}); // one cycle
    QVERIFY(isSaid());
    link({0, 1, 0, 0, 0, 1, 1, 0, 1});
    QVERIFY(!isSaid());
    link({1, 0, 0, 0, 0, 0, 0, 0, 0}); // one map is left
    QVERIFY(isSaid());
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
    QVERIFY(panel.findChild<QLabel*>()->text().contains(u"sequence of maps ends"_s));
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

namespace {

const view::LinkLayout::Arrow* arrowOf(const LinksPanel& panel, int from, int to) {
    for (const auto& arrow : panel.graph()->graph().arrows())
        if (arrow.from == from && arrow.to == to) return &arrow;
    return nullptr;
}

QPoint nodeOf(const LinksPanel& panel, int map) {
    return panel.graph()->graph().node(map).toPoint();
}

void drag(const LinksPanel& panel, int from, int to) {
    view::LinkGraph* graph = panel.graph();
    QTest::mousePress(graph, Qt::LeftButton, {}, nodeOf(panel, from));
    QTest::mouseMove(graph, graph->rect().center());
    QTest::mouseMove(graph, nodeOf(panel, to));
    QTest::mouseRelease(graph, Qt::LeftButton, {}, nodeOf(panel, to));
}

void press(const LinksPanel& panel, std::initializer_list<Qt::Key> keys) {
    for (const Qt::Key key : keys)
        QTest::keyClick(panel.graph(), key);
}

double weightOf(const document::Document& document, std::size_t at) {
    return ifs::linkMatrix(*document::system2(document.fractal()))[at];
}

} // namespace

void LinksPanelTest::drawsAnArrowForEachLink() {
    document::Document document;
    show(document, linked_systems::threeOnALine());
    LinksPanel panel(&document);
    panel.resize(300, 500);
    panel.show();
    QCOMPARE(panel.graph()->graph().arrows().size(), std::size_t(4));
    QVERIFY(arrowOf(panel, 0, 1) && arrowOf(panel, 1, 2) && arrowOf(panel, 2, 0) && arrowOf(panel, 2, 2));
    QVERIFY(view::arrowWidth(0.25) < view::arrowWidth(1) && view::arrowWidth(1) < view::arrowWidth(4));
    // There and back are apart.
    const auto* there = arrowOf(panel, 0, 1);
    QCOMPARE(panel.graph()->graph().arrowAt(there->line.at(there->line.size() / 2)),
             int(there - panel.graph()->graph().arrows().data()));
    const QImage picture = panel.graph()->grab().toImage();
    const double ratio = picture.devicePixelRatio();
    const QColor node =
        picture.pixelColor(((panel.graph()->graph().node(1) + QPointF(0, 11)) * ratio).toPoint());
    const QColor colour = panel.model()->colour(1);
    QVERIFY(std::abs(node.red() - colour.red()) + std::abs(node.green() - colour.green()) +
                std::abs(node.blue() - colour.blue()) <
            30);
}

void LinksPanelTest::draggingLinks() {
    document::Document document;
    show(document, linked_systems::threeOnALine());
    LinksPanel panel(&document);
    panel.resize(300, 500);
    panel.show();
    drag(panel, 0, 2);
    QCOMPARE(weightOf(document, 2), 1.0);
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(document.undoStack()->undoText(), u"Link map 1 to map 3"_s);
    QVERIFY(arrowOf(panel, 0, 2));
    drag(panel, 0, 2); // it is there already: only selected
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(panel.graph()->selectedTarget(), 2);
    document.undoStack()->undo();
    QVERIFY(!arrowOf(panel, 0, 2));
    // A click, or a drag into the void, links nothing.
    QTest::mouseClick(panel.graph(), Qt::LeftButton, {}, nodeOf(panel, 1));
    QTest::mousePress(panel.graph(), Qt::LeftButton, {}, nodeOf(panel, 1));
    QTest::mouseMove(panel.graph(), panel.graph()->rect().center());
    QTest::mouseRelease(panel.graph(), Qt::LeftButton, {}, QPoint(2, 2));
    QCOMPARE(document.undoStack()->index(), 0);
}

void LinksPanelTest::draggingBackLinksAMapToItself() {
    document::Document document;
    show(document, linked_systems::threeOnALine());
    LinksPanel panel(&document);
    panel.resize(300, 500);
    panel.show();
    drag(panel, 0, 0);
    QCOMPARE(weightOf(document, 0), 1.0);
    QCOMPARE(document.undoStack()->count(), 1);
}

void LinksPanelTest::aClickedArrowIsRemoved() {
    document::Document document;
    show(document, linked_systems::threeOnALine());
    const document::Fractal before = document.fractal();
    LinksPanel panel(&document);
    panel.resize(300, 500);
    panel.show();
    const auto* arrow = arrowOf(panel, 2, 0);
    QTest::mouseClick(panel.graph(), Qt::LeftButton, {}, arrow->line.at(arrow->line.size() / 2).toPoint());
    QCOMPARE(panel.graph()->currentMap(), 2);
    QCOMPARE(panel.graph()->selectedTarget(), 0);
    QVERIFY(panel.graph()->accessibleDescription().contains(u"From map 3 to map 1"_s));
    press(panel, {Qt::Key_Delete});
    QCOMPARE(weightOf(document, 6), 0.0);
    QVERIFY(!arrowOf(panel, 2, 0));
    QCOMPARE(document.undoStack()->undoText(), u"Unlink map 1 from map 3"_s);
    press(panel, {Qt::Key_Delete}); // nothing is selected any more
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QVERIFY(document.fractal() == before);
}

void LinksPanelTest::theKeyboardDoesTheSame() {
    document::Document document;
    show(document, linked_systems::threeOnALine());
    LinksPanel panel(&document);
    panel.resize(300, 500);
    panel.show();
    press(panel, {Qt::Key_Right}); // map 1
    QVERIFY(panel.graph()->accessibleDescription().startsWith(u"Map 1"_s));
    press(panel, {Qt::Key_Space, Qt::Key_Right, Qt::Key_Right});
    QVERIFY(panel.graph()->accessibleDescription().contains(u"from map 1 to map 3"_s));
    press(panel, {Qt::Key_Escape});
    QCOMPARE(document.undoStack()->count(), 0);
    press(panel, {Qt::Key_Space, Qt::Key_Left, Qt::Key_Return}); // to the last
    QCOMPARE(weightOf(document, 2), 1.0);
    press(panel, {Qt::Key_Up}); // from 3 to 2
    QCOMPARE(panel.graph()->selectedTarget(), 1);
    press(panel, {Qt::Key_Backspace});
    QCOMPARE(weightOf(document, 1), 0.0);
    QCOMPARE(document.undoStack()->count(), 2);
}

void LinksPanelTest::graphAndTableSelectTogether() {
    document::Document document;
    show(document, linked_systems::threeOnALine());
    LinksPanel panel(&document);
    panel.resize(300, 500);
    panel.show();
    panel.table()->setCurrentIndex(panel.model()->index(1, 2));
    QCOMPARE(panel.graph()->currentMap(), 1);
    QCOMPARE(panel.graph()->selectedTarget(), 2);
    panel.table()->setCurrentIndex(panel.model()->index(1, 0)); // no arrow
    QCOMPARE(panel.graph()->selectedTarget(), -1);
    press(panel, {Qt::Key_Right, Qt::Key_Down});
    QCOMPARE(panel.table()->currentIndex().row(), 2);
    QCOMPARE(panel.table()->currentIndex().column(), 0);
    // Enter edits the weight of the arrow there.
    press(panel, {Qt::Key_Return});
    QVERIFY(panel.table()->findChild<QLineEdit*>());
}

void LinksPanelTest::theGraphSaysWhy() {
    document::Document document;
    auto system = linked_systems::threeOnALine();
    ifs::setLinks(system, std::vector<double>{1, 1, 0, 0, 0, 0, 1, 0, 0});
    show(document, system);
    LinksPanel panel(&document);
    panel.resize(300, 500);
    panel.show();
    press(panel, {Qt::Key_Right, Qt::Key_Right});
    QVERIFY(panel.graph()->accessibleDescription().contains(u"Ends"_s));
    QHelpEvent help(QEvent::ToolTip, nodeOf(panel, 2), panel.graph()->mapToGlobal(nodeOf(panel, 2)));
    QCoreApplication::sendEvent(panel.graph(), &help);
    QVERIFY2(QToolTip::text().contains(u"Unreached"_s), qPrintable(QToolTip::text()));
}

void LinksPanelTest::manyArrowsAreThoseOfOneMap() {
    document::Document document;
    document::System2 system;
    for (int k = 0; k < 20; ++k)
        ifs::append(system, ifs::affineMap(.1, 0, 0, .1, k, 0), 1.0);
    show(document, system);
    LinksPanel panel(&document);
    panel.resize(300, 500);
    panel.show();
    panel.table()->setCurrentIndex(panel.model()->index(4, 0));
    for (const auto& arrow : panel.graph()->graph().arrows())
        QVERIFY(arrow.from == 4 || arrow.to == 4);
    QCOMPARE(panel.graph()->graph().arrows().size(), std::size_t(39));
}

BARYCAGE_TEST(LinksPanelTest, QApplication);
#include "links_panel_test.moc"
