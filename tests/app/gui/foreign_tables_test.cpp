// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "canvas/canvas_view.h"
#include "document/document.h"
#include "support/named_test.h"

#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QClipboard>
#include <QDockWidget>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

using namespace Qt::StringLiterals;

// What is said in the window about tables that somebody copied.
class ForeignTablesTest : public WindowFixture {
    Q_OBJECT

private slots:
    void weightsThatRiseAreSaid();

private:
    QString problems() const {
        const auto* dock = m_window->findChild<QDockWidget*>(u"problems"_s);
        if (!dock->isVisible()) return {};
        const QAbstractItemModel* model = dock->findChild<QAbstractItemView*>()->model();
        QString text;
        for (int row = 0; row < model->rowCount(); ++row)
            for (int column = 0; column < model->columnCount(); ++column)
                text += model->index(row, column).data().toString() + u' ';
        return text;
    }
    QList<double> weights() const {
        QList<double> all;
        for (const auto& map : document::system2(m_window->document().fractal())->maps)
            all << map.weight.value_or(0);
        return all;
    }
};

// When they are opened and when they are pasted; the numbers stay.
void ForeignTablesTest::weightsThatRiseAreSaid() {
    const QByteArray table = "a,b,c,d,e,f,p\n.5,0,0,.5,0,0,1\n.5,0,0,.5,1,0,86\n.5,0,0,.5,0,1,100\n";
    QGuiApplication::clipboard()->setText(QString::fromLatin1(table));
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->findChild<view::CanvasView*>()->setFocus();
    QVERIFY(problems().isEmpty());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(weights(), (QList<double>{1, 86, 100}));
    QVERIFY2(problems().contains(u"“cumulative”"_s), qPrintable(problems()));
    m_window->document().undoStack()->setClean();

    const QTemporaryDir folder;
    const QString path = folder.filePath(u"table.csv"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(table);
    file.close();
    QVERIFY(m_window->openPath(path));
    QCOMPARE(weights(), (QList<double>{1, 86, 100}));
    QVERIFY2(problems().contains(u"“cumulative”"_s), qPrintable(problems()));
}

BARYCAGE_TEST(ForeignTablesTest, QApplication);
#include "foreign_tables_test.moc"
