// SPDX-License-Identifier: MIT
#include "panels/maps/map_shape_editor.h"

#include "panels/maps/maps_model.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"
#include "widgets/number_field.h"

#include <memory>

using namespace maps_support;
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
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
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

BARYCAGE_TEST(MapShapeEditorTest, QApplication);
#include "map_shape_editor_test.moc"
