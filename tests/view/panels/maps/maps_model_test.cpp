// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/maps_edits.h"
#include "panels/maps/maps_model.h"
#include "panels/maps/maps_texts.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_text.h"

#include <QAbstractItemModelTester>
#include <QColor>
#include <QGuiApplication>
#include <QSignalSpy>

using namespace maps_support;
using view::MapsModel;

class MapsModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(withTriangle(maple())));
    }

    void showsCodeAndFacts() {
        const MapsModel model(m_document.get());
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.columnCount(), int(MapsModel::ColumnCount));
        QCOMPARE(text(model, 1, MapsModel::A), QStringLiteral("0.61"));
        QCOMPARE(model.index(2, MapsModel::C).data(Qt::EditRole).toDouble(), -0.3);
        QCOMPARE(text(model, 3, MapsModel::F), QStringLiteral("0.6"));
        QCOMPARE(text(model, 1, MapsModel::Determinant), QStringLiteral("0.1891"));
        QCOMPARE(text(model, 3, MapsModel::Contraction), QStringLiteral("0.7232"));
        QCOMPARE(text(model, 0, MapsModel::Kind), QStringLiteral("affine"));
        QCOMPARE(model.index(0, MapsModel::C).data(MapsModel::DecimalsRole).toInt(), 2);
        QCOMPARE(model.headerData(0, Qt::Vertical).toInt(), 1);
    }

    // The header of the rows shows the warning, and recomputes it only on request.
    void warningsComeAndGoInTheRowHeader() {
        MapsModel model(m_document.get());
        QVERIFY(model.headerData(1, Qt::Vertical, MapsModel::WarningRole).toString().isEmpty());
        QSignalSpy header(&model, &MapsModel::headerDataChanged);
        QVERIFY(model.setData(model.index(1, MapsModel::A), 3.0));
        QVERIFY(!model.headerData(1, Qt::Vertical, MapsModel::WarningRole).toString().isEmpty());
        QCOMPARE(header.takeFirst(), (QVariantList{QVariant::fromValue(Qt::Vertical), 0, 3}));
        m_document->undoStack()->undo();
        QVERIFY(model.headerData(1, Qt::Vertical, MapsModel::WarningRole).toString().isEmpty());
        QCOMPARE(header.size(), 1);
    }

    // Files may hold them; the map does not take part, which is said where it is seen.
    void negativeWeightsAreSaid() {
        MapsModel model(m_document.get());
        const QModelIndex cell = model.index(1, MapsModel::Weight);
        const auto sign = [&] {
            return model.headerData(1, Qt::Vertical, MapsModel::WarningRole).toString();
        };
        QVERIFY(model.setData(cell, 0.0));
        QVERIFY(sign().isEmpty() && model.remark(cell).isEmpty());
        QVERIFY(model.setData(cell, -0.1));
        QVERIFY2(sign().contains(QStringLiteral("negative")), qPrintable(sign()));
        QCOMPARE(model.remark(cell), sign());
        QCOMPARE(model.headerData(1, Qt::Vertical, Qt::ToolTipRole).toString(), sign());
        QCOMPARE(cell.data(Qt::ForegroundRole).value<QColor>(), view::problemColour(qGuiApp->palette()));
        QVERIFY(model.remark(model.index(1, MapsModel::A)).isEmpty());
        QVERIFY(model.setData(model.index(1, MapsModel::A), 3.0)); // one does not hide the other
        QCOMPARE(sign().count(u'\n'), 1);
    }

    void flagsSayWhatCanBeEdited() {
        const MapsModel model(m_document.get());
        for (int column = 0; column < MapsModel::ColumnCount; ++column) {
            const auto flags = model.flags(model.index(0, column));
            const bool typed =
                column == MapsModel::Name || (column >= MapsModel::A && column <= MapsModel::Weight);
            QCOMPARE(flags.testFlag(Qt::ItemIsEditable), typed);
            QCOMPARE(flags.testFlag(Qt::ItemIsUserCheckable),
                     column == MapsModel::Enabled || column == MapsModel::Lock);
        }
    }

    void keepsTheContractOfItemModels() {
        MapsModel model(m_document.get());
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.preview(model.index(0, MapsModel::A), 0.2);
        model.commitEdit();
        m_document->edit(QStringLiteral("x"), document::withNewMap(m_document->fractal()).fractal);
        m_document->edit(QStringLiteral("x"), document::withoutMaps(m_document->fractal(), {0, 2}).fractal);
        m_document->undoStack()->undo();
        m_document->edit(QStringLiteral("x"), document::withMapsMoved(m_document->fractal(), {0}, 3).fractal);
        QCOMPARE(model.rowCount(), 5);
    }

    void previewsLiveAndLeavesOneStep() {
        MapsModel model(m_document.get());
        const document::Fractal before = m_document->fractal();
        std::vector<bool> live;
        connect(m_document.get(), &document::Document::changed, this,
                [&](const document::Change& change) { live.push_back(change.live); });
        const QModelIndex cell = model.index(2, MapsModel::B);
        for (const double value : {0.4, 0.45, 0.451}) {
            model.preview(cell, value);
            QCOMPARE(systemOf(*m_document).maps[2].map.linear(0, 1), value);
            QVERIFY(live.back());
        }
        QCOMPARE(m_document->undoStack()->count(), 0);
        model.commitEdit();
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == before);
    }

    void cancelRestoresExactly() {
        MapsModel model(m_document.get());
        const document::Fractal before = m_document->fractal();
        model.preview(model.index(0, MapsModel::E), 7);
        QVERIFY(m_document->fractal() != before);
        model.cancelEdit();
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void setDataIsOneStepAndRefusesRubbish() {
        MapsModel model(m_document.get());
        QVERIFY(model.setData(model.index(1, MapsModel::D), QStringLiteral("0.25")));
        QCOMPARE(systemOf(*m_document).maps[1].map.linear(1, 1), 0.25);
        QVERIFY(!model.setData(model.index(1, MapsModel::D), QStringLiteral("1/0")));
        QVERIFY(model.setData(model.index(1, MapsModel::D), QStringLiteral("0,5")));
        QCOMPARE(systemOf(*m_document).maps[1].map.linear(1, 1), 0.5);
        QVERIFY(!model.setData(model.index(1, MapsModel::Determinant), 3.0));
        QVERIFY(model.setData(model.index(0, MapsModel::Enabled), Qt::Unchecked, Qt::CheckStateRole));
        QVERIFY(!systemOf(*m_document).maps[0].enabled);
        QVERIFY(model.setData(model.index(3, MapsModel::Colour), QColor(10, 20, 30), Qt::DecorationRole));
        QCOMPARE(model.index(3, MapsModel::Colour).data(Qt::DecorationRole).value<QColor>(),
                 QColor(10, 20, 30));
        QCOMPARE(m_document->undoStack()->count(), 4);
        for (const int row : {2, 3}) { // one that the map has by its place, and the one of before
            const QModelIndex cell = model.index(row, MapsModel::Colour);
            QVERIFY(model.setData(cell, cell.data(Qt::DecorationRole), Qt::DecorationRole));
        }
        QCOMPARE(m_document->undoStack()->count(), 4);
    }

    void marksMapsThatDoNotContract() {
        MapsModel model(m_document.get());
        QVERIFY(model.index(1, MapsModel::Kind).data(MapsModel::WarningRole).toString().isEmpty());
        model.setData(model.index(1, MapsModel::A), 1.5);
        const QModelIndex kind = model.index(1, MapsModel::Kind);
        QVERIFY(kind.data(MapsModel::WarningRole).toString().contains(QStringLiteral("1.5")));
        QVERIFY(kind.data().toString().contains(QStringLiteral("not contracting")));
        QCOMPARE(kind.data(Qt::ToolTipRole), kind.data(MapsModel::WarningRole));
    }

    void aWeightTypedWhereNoneIsGivenFixesTheOthers() {
        document::Fractal fractal = maple();
        for (auto& map : document::system2(fractal)->maps)
            map.weight.reset();
        m_document->setFile(document::fileOf(fractal));
        const auto before = ifs::probabilities(systemOf(*m_document));
        MapsModel model(m_document.get());
        QVERIFY(model.setData(model.index(0, MapsModel::Weight), 0.5));
        QCOMPARE(systemOf(*m_document).maps[0].weight, std::optional(0.5));
        for (std::size_t i = 1; i < 4; ++i)
            QCOMPARE(systemOf(*m_document).maps[i].weight, std::optional(before[i]));
    }

    void tooltipOfTheWeightTellsTheProbability() {
        document::Fractal fractal = maple();
        document::system2(fractal)->maps[0].weight = 2.25;
        m_document->setFile(document::fileOf(fractal));
        const MapsModel model(m_document.get());
        const QString tip = model.index(0, MapsModel::Weight).data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains(QStringLiteral("2.25")) && tip.contains(QStringLiteral("0.75")),
                 qPrintable(tip));
    }

    void effectiveCodeFollowsTheCage() {
        document::Fractal fractal = withTriangle(maple());
        for (auto& vertex : document::plane(fractal)->cage->current)
            vertex += ifs::Vector<2>(1, 2);
        m_document->setFile(document::fileOf(fractal));
        const MapsModel model(m_document.get());
        // A translation by t keeps A and adds (I − A)t to b.
        const auto& map = systemOf(*m_document).maps[2].map;
        const ifs::Vector<2> t(1, 2);
        const ifs::Vector<2> expected = map.translation + t - map.linear * t;
        QCOMPARE(model.index(2, MapsModel::EffectiveA).data(Qt::EditRole).toDouble(), map.linear(0, 0));
        QVERIFY(qAbs(model.index(2, MapsModel::EffectiveE).data(Qt::EditRole).toDouble() - expected.x()) <
                1e-12);
        QVERIFY(qAbs(model.index(2, MapsModel::EffectiveF).data(Qt::EditRole).toDouble() - expected.y()) <
                1e-12);

        document::plane(fractal)->cage->current = {{0, 0}, {1, 1}, {2, 2}};
        m_document->edit(QStringLiteral("flat"), fractal);
        QCOMPARE(text(model, 2, MapsModel::EffectiveE), QStringLiteral("–"));
        QVERIFY(!document::bakeObstacle(fractal).isEmpty());
        QVERIFY(!document::baked(fractal));
    }

    // Where rounding leaves −3.5e−18 of 0, the table says 0; and its points stay where they are.
    void movingNumbersStandStill() {
        document::Fractal fractal = withTriangle(maple());
        document::plane(fractal)->system.maps[0].map.linear(0, 1) = -0x1p-58;
        m_document->setFile(document::fileOf(fractal));
        const MapsModel model(m_document.get());
        QCOMPARE(text(model, 0, MapsModel::B), QStringLiteral("-3.47e-18")); // typed, as it stands
        animation::Sway<2> sway;
        sway.maps = {document::plane(fractal)->system.maps[1].id};
        sway.strength = 9;
        sway.waves = {{1, 1, 0, 60}};
        auto& animation = document::plane(fractal)->animation.emplace();
        animation.length = 24;
        animation.motions = {sway};
        m_document->editEntry(QStringLiteral("Sway"), fractal);
        for (int frame = 0; frame < 24; ++frame) {
            m_document->setMoment(animation::moment(frame));
            for (int row = 0; row < model.rowCount(); ++row)
                for (int column = MapsModel::A; column <= MapsModel::F; ++column) {
                    const QString shown = text(model, row, column);
                    QVERIFY2(!shown.contains(u'e') && shown != QLatin1String("-0"), qPrintable(shown));
                    QCOMPARE(model.index(row, column).data(MapsModel::DecimalsRole).toInt(),
                             view::maxDecimals);
                    QVERIFY(view::decimalsOf(shown) <= view::maxDecimals);
                }
        }
        QCOMPARE(text(model, 0, MapsModel::B), QStringLiteral("0"));
    }

    void steadyNumbers() {
        QCOMPARE(view::steadyNumber(0.00123, 4), QStringLiteral("0.0012"));
        QCOMPARE(view::steadyNumber(-0.5, 4), QStringLiteral("-0.5"));
        QCOMPARE(view::steadyNumber(3e-9, 4), QStringLiteral("3e-09")); // a number, not 0
        QCOMPARE(view::steadyNumber(0.126, 2), QStringLiteral("0.13"));
    }

    // A rotated cage leaves the linear part of such maps as it is.
    void effectiveCodeHasNoResidue() {
        document::Fractal fractal = withTriangle(maple());
        for (auto& map : document::plane(fractal)->system.maps)
            map.map.linear = ifs::Matrix<2>::Identity() / 3;
        const Eigen::Rotation2Dd turn(0.7);
        for (auto& vertex : document::plane(fractal)->cage->current)
            vertex = turn * vertex;
        m_document->setFile(document::fileOf(fractal));
        const MapsModel model(m_document.get());
        for (int row = 0; row < model.rowCount(); ++row)
            for (const int column : {MapsModel::EffectiveB, MapsModel::EffectiveC})
                QCOMPARE(text(model, row, column), QStringLiteral("0"));
    }

    void isEmptyForOtherEntries() {
        document::Fractal fractal;
        fractal.shape = document::Shape<3>();
        m_document->setFile(document::fileOf(fractal));
        const MapsModel model(m_document.get());
        QCOMPARE(model.rowCount(), 0);
        QVERIFY(model.idAt(0) == ifs::MapId::None);
    }

private:
    static QString text(const MapsModel& model, int row, int column) {
        return model.index(row, column).data().toString();
    }
    std::unique_ptr<document::Document> m_document;
};

BARYCAGE_TEST(MapsModelTest, QApplication);
#include "maps_model_test.moc"
