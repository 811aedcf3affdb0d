// SPDX-License-Identifier: MIT
#include "panels/maps/map_shape_editor.h"

#include "panels/maps/maps_model.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <cmath>
#include <memory>
#include <numbers>

using namespace maps_support;

namespace {

// Also what is on no key.
void typeInto(QWidget* field, const QString& text) {
    for (const QChar c : text)
        QTest::sendKeyEvent(QTest::Click, field, Qt::Key_unknown, QString(c), Qt::NoModifier);
    QTest::keyClick(field, Qt::Key_Return);
}

} // namespace
using view::MapShapeEditor;
using view::MapsModel;

// Expressions stay where they were typed.
class MapShapeEditorTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() {
        m_editor.reset();
        m_document.reset();
    }

    void whatWasTypedStaysWithTheMap();
    void aTranslationIsWrittenAlikeInTheTable();
    void whatIsTypedIsPartOfTheEntry();
    void degreesAreReadOnce_data();
    void degreesAreReadOnce();
    void degreesInSpace();

private:
    QString text(MapShapeEditor::Part part) { return m_editor->field(part)->text(); }
    ifs::MapId map(std::size_t index) { return systemOf(*m_document).maps[index].id; }
    void type(MapShapeEditor::Part part, const QString& text);

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<MapShapeEditor> m_editor;
};

void MapShapeEditorTest::init() {
    m_document = std::make_unique<document::Document>();
    m_document->setFile(document::fileOf(maple()));
    m_editor = std::make_unique<MapShapeEditor>(m_document.get());
    m_editor->setVisible(true);
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
    m_editor->setMap(map(1));
}

void MapShapeEditorTest::type(MapShapeEditor::Part part, const QString& text) {
    view::NumberField* field = m_editor->field(part);
    field->setFocus();
    field->selectAll();
    typeInto(field, text);
}

void MapShapeEditorTest::degreesAreReadOnce_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<QString>("shown"); // after Enter
    QTest::newRow("number") << "90" << 90.0 << "90";
    QTest::newRow("marked") << "90°" << 90.0 << "90";
    QTest::newRow("negative") << "-90°" << -90.0 << "-90";
    QTest::newRow("half") << "45°/2" << 22.5 << "22.5";
    QTest::newRow("fraction") << "360/16" << 22.5 << "360/16";
    QTest::newRow("pi") << "pi/2" << 90.0 << "90";
    QTest::newRow("inverse") << "asin(0.5)" << 30.0 << "30";
    QTest::newRow("sum") << "90° + pi/4" << 135.0 << "135";
    QTest::newRow("cosine") << "cos(60°)" << 0.5 << "cos(60°)";
}

void MapShapeEditorTest::degreesAreReadOnce() {
    QFETCH(QString, typed);
    QFETCH(double, degrees);
    QFETCH(QString, shown);
    type(MapShapeEditor::Rotation, typed);
    QCOMPARE(m_editor->field(MapShapeEditor::Rotation)->value(), degrees);
    QCOMPARE(text(MapShapeEditor::Rotation), shown);
    const ifs::Matrix<2>& linear = systemOf(*m_document).maps[1].map.linear;
    const double turned = std::atan2(linear(1, 0), linear(0, 0)) * 180 / std::numbers::pi;
    QVERIFY(std::abs(turned - degrees) < 1e-12);
    m_editor->field(MapShapeEditor::ScaleX)->setFocus();
    QCOMPARE(m_editor->field(MapShapeEditor::Rotation)->value(), degrees);
    type(MapShapeEditor::TranslationX, QStringLiteral("90°")); // not of degrees
    QCOMPARE(systemOf(*m_document).maps[1].map.translation.x(), std::numbers::pi / 2);
}

void MapShapeEditorTest::degreesInSpace() {
    document::Fractal fractal;
    fractal.shape = document::Shape<3>{};
    ifs::append(*document::system3(fractal), ifs::AffineMap<3>{0.5 * ifs::Matrix<3>::Identity(), {0, 0, 0}},
                1);
    m_document->setFile(document::fileOf(fractal));
    m_editor->setMap(document::system3(m_document->fractal())->maps[0].id);
    view::NumberField* field = m_editor->field(MapShapeEditor::Angle);
    for (const char* typed : {"90°", "pi/2", "acos(0)"}) {
        field->setFocus();
        field->selectAll();
        typeInto(field, QString::fromUtf8(typed));
        QCOMPARE(field->value(), 90.0);
        QCOMPARE(field->text(), QStringLiteral("90"));
        const ifs::Matrix<3>& linear = document::system3(m_document->fractal())->maps[0].map.linear;
        QVERIFY(std::abs(linear.trace() - 0.5) < 1e-15); // 0.5·(1 + 2 cos 90°)
        m_document->undoStack()->undo();
    }
}

void MapShapeEditorTest::whatWasTypedStaysWithTheMap() {
    const QString typed = QStringLiteral("360/8");
    type(MapShapeEditor::Rotation, typed);
    QCOMPARE(m_editor->field(MapShapeEditor::Rotation)->value(), 45.0);
    QCOMPARE(text(MapShapeEditor::Rotation), typed);
    m_editor->setMap(map(0));
    QVERIFY(text(MapShapeEditor::Rotation) != typed);
    m_editor->setMap(map(1));
    QCOMPARE(text(MapShapeEditor::Rotation), typed);
    m_document->undoStack()->undo();
    QVERIFY(text(MapShapeEditor::Rotation) != typed);
    m_document->undoStack()->redo();
    QCOMPARE(text(MapShapeEditor::Rotation), typed);
}

void MapShapeEditorTest::aTranslationIsWrittenAlikeInTheTable() {
    MapsModel model(m_document.get());
    type(MapShapeEditor::TranslationX, QStringLiteral("1/3"));
    QCOMPARE(systemOf(*m_document).maps[1].map.translation.x(), 1.0 / 3);
    QCOMPARE(model.typedText(model.index(1, MapsModel::E)), QStringLiteral("1/3"));
    QVERIFY(model.typedText(model.index(0, MapsModel::E)).isEmpty());

    const QModelIndex cell = model.index(1, MapsModel::F);
    model.preview(cell, 0.25);
    model.keepTyped(cell, 0.25, QStringLiteral("1/4"));
    model.commitEdit();
    QCOMPARE(text(MapShapeEditor::TranslationY), QStringLiteral("1/4"));
}

// And so of the file and of each step of the history; a plain number takes its place.
void MapShapeEditorTest::whatIsTypedIsPartOfTheEntry() {
    const auto typed = [this](int which) {
        const auto& map = systemOf(*m_document).maps[1];
        const auto* kept = map.typed.of(which, map.map);
        return kept ? QString::fromStdString(kept->text) : QString();
    };
    type(MapShapeEditor::TranslationX, QStringLiteral("1/3"));
    QCOMPARE(typed(4), QStringLiteral("1/3"));
    MapsModel model(m_document.get());
    const QModelIndex a = model.index(1, MapsModel::A);
    model.preview(a, 1.0 / 7);
    model.keepTyped(a, 1.0 / 7, QStringLiteral("1/7"));
    model.commitEdit();
    QCOMPARE(typed(0), QStringLiteral("1/7"));
    QCOMPARE(m_document->undoStack()->count(), 2); // the number and its text are one step
    m_document->undoStack()->undo();
    QCOMPARE(typed(0), QString());
    QCOMPARE(typed(4), QStringLiteral("1/3"));
    m_document->undoStack()->redo();
    QCOMPARE(typed(0), QStringLiteral("1/7"));
    QVERIFY(model.setData(a, QStringLiteral("sqrt(3)/6"), Qt::EditRole));
    QCOMPARE(typed(0), QStringLiteral("sqrt(3)/6"));
    QVERIFY(model.setData(a, systemOf(*m_document).maps[1].map.linear(0, 0), Qt::EditRole));
    QCOMPARE(typed(0), QString());
    type(MapShapeEditor::TranslationX, QStringLiteral("0.25"));
    QCOMPARE(typed(4), QString());
}

BARYCAGE_TEST(MapShapeEditorTest, QApplication);
#include "map_shape_editor_test.moc"
