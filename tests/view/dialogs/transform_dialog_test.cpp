// SPDX-License-Identifier: MIT
#include "dialogs/transform_dialog.h"
#include "document/fractal_geometry.h"
#include "view/panels/maps_support.h"
#include "widgets/number_field.h"

#include <QCheckBox>
#include <QComboBox>

#include <memory>
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

private:
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

QTEST_MAIN(TransformDialogTest)
#include "transform_dialog_test.moc"
