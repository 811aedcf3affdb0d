// SPDX-License-Identifier: MIT
#include "dialogs/transform_dialog.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QCheckBox>
#include <QComboBox>

#include <memory>
#include <numbers>
#include <random>

using namespace maps_support;
using document::Transformation;
using view::TransformDialog;

class TransformDialogTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(placedMaple()));
    }

    void fixesThePointItIsMadeAbout() {
        Transformation t;
        t.rotation = 90;
        t.about = {1, 2};
        const auto quarter = document::affineMap(t);
        QVERIFY((quarter({1, 2}) - ifs::Vector<2>(1, 2)).norm() < 1e-15);
        QVERIFY((quarter({2, 2}) - ifs::Vector<2>(1, 3)).norm() < 1e-15);
        t = {};
        t.reflect = true;
        t.axis = 90;
        t.about = {3, 0};
        t.translation = {0, 1};
        QVERIFY((document::affineMap(t)({5, 7}) - ifs::Vector<2>(1, 8)).norm() < 1e-14);
        t = {};
        t.reflect = true;
        t.axis = 45;
        t.scaleX = 2;
        QVERIFY((document::affineMap(t)({1, 3}) - ifs::Vector<2>(6, 1)).norm() <
                1e-14); // mirrored first, then scaled
    }

    // Placing moves the cage, rewriting conjugates the code: what is displayed must agree.
    void placingAndRewritingShowTheSamePicture() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> number(-2, 2);
        for (int round = 0; round < 100; ++round) {
            Transformation t;
            t.reflect = round % 2 == 1;
            t.axis = 90 * number(random);
            t.shear = number(random);
            t.scaleX = 0.3 + std::abs(number(random));
            t.scaleY = 0.3 + std::abs(number(random));
            t.rotation = 90 * number(random);
            t.translation = {number(random), number(random)};
            t.about = {number(random), number(random)};
            const auto map = document::affineMap(t);
            const document::Fractal before = round < 50 ? withTriangle(maple()) : placedMaple();
            const auto placed = document::effectiveSystem(document::placed(before, map));
            const auto rewritten = document::rewritten(before, map);
            QVERIFY(placed && rewritten);
            const auto shown = document::effectiveSystem(*rewritten);
            QVERIFY(shown);
            QVERIFY(*document::system2(document::placed(before, map)) == *document::system2(before));
            for (std::size_t i = 0; i < placed->maps.size(); ++i)
                QVERIFY(distance(placed->maps[i].map, shown->maps[i].map) < 1e-9);
            // Where the cage is seen must agree as well.
            const auto cage = document::plane(document::placed(before, map))->cage->current;
            for (std::size_t i = 0; i < cage.size(); ++i)
                QVERIFY((cage[i] - document::plane(*rewritten)->cage->current[i]).norm() < 1e-12);
        }
    }

    void isLiveAndOneStep() {
        const document::Fractal before = m_document->fractal();
        TransformDialog dialog(m_document.get());
        dialog.show();
        type(dialog, TransformDialog::Rotation, QStringLiteral("30"));
        QVERIFY(m_document->fractal() != before);
        QVERIFY(*document::system2(m_document->fractal()) == *document::system2(before));
        dialog.setMode(TransformDialog::Mode::Rewrite);
        QVERIFY(*document::system2(m_document->fractal()) != *document::system2(before));
        QCOMPARE(m_document->undoStack()->count(), 0);
        dialog.accept();
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == before);
    }

    void anglesAreInDegrees() {
        TransformDialog dialog(m_document.get());
        dialog.show();
        type(dialog, TransformDialog::Rotation, QStringLiteral("pi/2"));
        QCOMPARE(dialog.transformation().rotation, 90.0);
        type(dialog, TransformDialog::Rotation, QStringLiteral("2*acos(0)"));
        QCOMPARE(dialog.transformation().rotation, 180.0);
        for (auto* box : dialog.findChildren<QCheckBox*>())
            box->setChecked(true);
        type(dialog, TransformDialog::Mirror, QStringLiteral("pi/4"));
        QCOMPARE(dialog.transformation().axis, 45.0);
        type(dialog, TransformDialog::Shear, QStringLiteral("pi/4"));
        QCOMPARE(dialog.transformation().shear, std::numbers::pi / 4);
        dialog.reject();
    }

    void anglesOfSolidsAreInDegrees() {
        m_document->setFile(document::fileOf(solid()));
        TransformDialog dialog(m_document.get());
        dialog.show();
        for (const char* typed : {"pi/2", "acos(0)", "90"}) {
            type(dialog, TransformDialog::Rotation, QStringLiteral("10"));
            QCOMPARE(dialog.spaceTransformation().rotation, 10.0);
            type(dialog, TransformDialog::Rotation, QString::fromLatin1(typed));
            QCOMPARE(dialog.spaceTransformation().rotation, 90.0);
        }
        dialog.reject();
    }

    // In the field that follows, too.
    void expressionsStay() {
        TransformDialog dialog(m_document.get());
        dialog.show();
        type(dialog, TransformDialog::ScaleX, QStringLiteral("1/2"));
        QCOMPARE(dialog.field(TransformDialog::ScaleY)->text(), QStringLiteral("1/2"));
        QCOMPARE(dialog.transformation().scaleY, 0.5);
        dialog.reject();
    }

    void cancelRestoresExactly() {
        const document::Fractal before = m_document->fractal();
        TransformDialog dialog(m_document.get());
        dialog.show();
        type(dialog, TransformDialog::ShiftX, QStringLiteral("3"));
        QVERIFY(m_document->fractal() != before);
        dialog.reject();
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void nothingDoneLeavesNoStep() {
        const document::Fractal before = m_document->fractal();
        TransformDialog dialog(m_document.get());
        dialog.show();
        dialog.accept();
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void aFlatTransformationCanBePlacedButNotWritten() {
        TransformDialog dialog(m_document.get());
        dialog.show();
        type(dialog, TransformDialog::ScaleX, QStringLiteral("0"));
        QVERIFY(dialog.problem().isEmpty());
        dialog.setMode(TransformDialog::Mode::Rewrite);
        QVERIFY(!dialog.problem().isEmpty());
        dialog.accept();
        QVERIFY(dialog.isVisible()); // refused
        dialog.reject();
    }

    // What an axis is, and that the order is that of the rows.
    void turnsAboutAnAxis() {
        document::SpaceTransformation t;
        t.axis = {0, 0, 3};
        t.rotation = 90;
        t.about = {1, 2, 5};
        const auto quarter = document::affineMap(t);
        QVERIFY(quarter({1, 2, 7}) == ifs::Vector<3>(1, 2, 7)); // on the axis
        QVERIFY((quarter({2, 2, 0}) - ifs::Vector<3>(1, 3, 0)).norm() < 1e-15);
        t = {};
        t.axis = {1, 1, 1};
        t.rotation = 120;
        t.scale = {2, 1, 1};
        t.translation = {0, 0, 10};
        QVERIFY((document::affineMap(t)({1, 0, 0}) - ifs::Vector<3>(0, 2, 10)).norm() < 1e-14); // x ↦ y
        t.axis.setZero();
        QVERIFY((document::affineMap(t)({1, 0, 0}) - ifs::Vector<3>(2, 0, 10)).norm() < 1e-14);
    }

    void placingAndRewritingShowTheSameSolid() {
        std::mt19937 random(12);
        std::uniform_real_distribution<double> number(-2, 2);
        const auto vector = [&] { return ifs::Vector<3>(number(random), number(random), number(random)); };
        for (int round = 0; round < 60; ++round) {
            document::SpaceTransformation t;
            t.axis = vector();
            t.rotation = 90 * number(random);
            t.scale = vector().cwiseAbs() + ifs::Vector<3>::Constant(0.3);
            t.translation = vector();
            t.about = vector();
            const auto map = document::affineMap(t);
            const document::Fractal before = round < 30 ? solid() : placedSolid();
            const document::Fractal placed = document::placed(before, map);
            const auto rewritten = document::rewritten(before, map);
            QVERIFY(rewritten);
            QVERIFY(*document::system3(placed) == *document::system3(before));
            const auto one = document::effectiveSystem<3>(placed);
            const auto other = document::effectiveSystem<3>(*rewritten);
            QVERIFY(one && other && one->maps.size() == 4);
            for (std::size_t i = 0; i < one->maps.size(); ++i) {
                QVERIFY((one->maps[i].map.linear - other->maps[i].map.linear).norm() < 1e-9);
                QVERIFY((one->maps[i].map.translation - other->maps[i].map.translation).norm() < 1e-9);
            }
        }
    }

    void isLiveAndOneStepInSpace() {
        const document::Fractal before = placedSolid();
        m_document->setFile(document::fileOf(before));
        TransformDialog dialog(m_document.get());
        dialog.show();
        QVERIFY(!dialog.reflect() && !dialog.field(TransformDialog::Shear));
        const ifs::Vector<3> middle = *document::middleOfBox<3>(before);
        QVERIFY((dialog.spaceTransformation().about - middle).norm() < 1e-12);
        support::choose(dialog.axis(), TransformDialog::AxisChoice::Z);
        QVERIFY(dialog.spaceTransformation().axis == ifs::Vector<3>::UnitZ());
        type(dialog, TransformDialog::Rotation, QStringLiteral("90"));
        // Every corner turns about the vertical line through the middle.
        const auto& from = document::space(before)->cage->current;
        const auto& to = document::space(m_document->fractal())->cage->current;
        for (std::size_t k = 0; k < from.size(); ++k) {
            const ifs::Vector<3> arm = from[k] - middle;
            QVERIFY((to[k] - middle - ifs::Vector<3>(-arm.y(), arm.x(), arm.z())).norm() < 1e-12);
        }
        QCOMPARE(m_document->undoStack()->count(), 0);
        dialog.setMode(TransformDialog::Mode::Rewrite);
        QVERIFY(*document::system3(m_document->fractal()) != *document::system3(before));
        dialog.accept();
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == before);
    }

    void escapeRestoresTheSolid() {
        const document::Fractal before = placedSolid();
        m_document->setFile(document::fileOf(before));
        TransformDialog dialog(m_document.get());
        dialog.show();
        type(dialog, TransformDialog::ScaleY, QStringLiteral("1/2"));
        QVERIFY(dialog.spaceTransformation().scale == ifs::Vector<3>::Constant(0.5)); // the same in all
        type(dialog, TransformDialog::ShiftZ, QStringLiteral("3"));
        QVERIFY(m_document->fractal() != before);
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void anAxisNeedsADirection() {
        m_document->setFile(document::fileOf(solid()));
        TransformDialog dialog(m_document.get());
        dialog.show();
        type(dialog, TransformDialog::AxisY, QStringLiteral("0"));
        QCOMPARE(view::chosenValue<TransformDialog::AxisChoice>(dialog.axis()),
                 TransformDialog::AxisChoice::Typed);
        QVERIFY(dialog.problem().isEmpty()); // nothing is turned
        type(dialog, TransformDialog::Rotation, QStringLiteral("10"));
        QVERIFY(!dialog.problem().isEmpty());
        type(dialog, TransformDialog::AxisX, QStringLiteral("-2"));
        QVERIFY(dialog.problem().isEmpty());
        dialog.reject();
    }

    // Mean value coordinates go with similarities alone.
    void aBentSolidIsWrittenBySimilaritiesOnly() {
        document::Fractal bent = solid();
        document::space(bent)->cage = ifs::polygonAtRest<3>(
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
        document::space(bent)->cage->current[7] += ifs::Vector<3>(0.5, 0.2, 0);
        m_document->setFile(document::fileOf(bent));
        TransformDialog dialog(m_document.get());
        dialog.show();
        dialog.setMode(TransformDialog::Mode::Rewrite);
        type(dialog, TransformDialog::ScaleX, QStringLiteral("2"));
        QVERIFY(dialog.problem().isEmpty());
        auto* same = dialog.findChildren<QCheckBox*>().front();
        same->setChecked(false);
        type(dialog, TransformDialog::ScaleX, QStringLiteral("3"));
        QVERIFY(!dialog.problem().isEmpty());
        dialog.setMode(TransformDialog::Mode::Place);
        QVERIFY(dialog.problem().isEmpty());
        dialog.reject();
    }

private:
    // A tetrahedron of Sierpiński.
    static document::Fractal solid() {
        document::Fractal fractal;
        fractal.name = QStringLiteral("solid");
        document::Shape<3> shape;
        for (int k = 0; k < 4; ++k) {
            const ifs::Vector<3> shift =
                k == 0 ? ifs::Vector<3>::Zero() : ifs::Vector<3>(0.5 * ifs::Vector<3>::Unit(k - 1));
            ifs::append<3>(shape.system, {0.5 * ifs::Matrix<3>::Identity(), shift});
        }
        fractal.shape = shape;
        return fractal;
    }
    static document::Fractal placedSolid() {
        document::Fractal fractal = solid();
        document::space(fractal)->cage = document::spaceCage(fractal);
        document::space(fractal)->cage->current = {{-1, 0, 2}, {3, 0.5, 1}, {0, 4, 0}, {0, 1, -2}};
        return fractal;
    }
    static document::Fractal placedMaple() {
        document::Fractal fractal = withTriangle(maple());
        document::plane(fractal)->cage->current = {{-2, -3}, {5, -2}, {-3, 4}};
        return fractal;
    }
    static void type(TransformDialog& dialog, TransformDialog::Value value, const QString& text) {
        view::NumberField* field = dialog.field(value);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    std::unique_ptr<document::Document> m_document;
};

BARYCAGE_TEST(TransformDialogTest, QApplication);
#include "transform_dialog_test.moc"
