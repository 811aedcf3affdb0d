// SPDX-License-Identifier: MIT
#include "stage/status_line.h"

#include "document/document.h"
#include "support/named_test.h"
#include "widgets/text/elided_label.h"
#include "widgets/tooltips.h"

#include <QHelpEvent>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QTest>
#include <QToolTip>
#include <QUndoStack>
#include <QVBoxLayout>

#include <memory>
#include <utility>

namespace {

// The second map stretches, but never follows itself.
template <int Dim> document::Shape<Dim> heldByItsLinks() {
    document::Shape<Dim> shape;
    ifs::append<Dim>(shape.system, {0.2 * ifs::Matrix<Dim>::Identity(), ifs::Vector<Dim>::Zero()});
    ifs::append<Dim>(shape.system, {1.5 * ifs::Matrix<Dim>::Identity(), ifs::Vector<Dim>::Ones()});
    const ifs::MapId stretching = shape.system.maps[1].id;
    shape.system.links = {{stretching, stretching, 0}};
    return shape;
}

} // namespace

// What has no room ends in dots, and is read in full at the pointer.
class StatusLineTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_line = std::make_unique<StatusLine>();
        m_line->resize(600, m_line->sizeHint().height());
        m_line->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_line.get()));
        QToolTip::hideText();
    }

    void aLongMessageEndsInDots() {
        const QString message = QStringLiteral("W").repeated(300);
        m_line->showMessage(message);
        const QImage picture = m_line->grab().toImage();
        const auto ink = [&picture](int left, int width) {
            int count = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = left; x < left + width; ++x)
                    count += qGray(picture.pixel(x, y)) + 60 < qGray(picture.pixel(1, 1));
            return count;
        };
        int end = picture.width() - 1; // of what is painted
        while (end > 0 && ink(end, 1) == 0)
            --end;
        const int dots = m_line->fontMetrics().horizontalAdvance(u'…') - 2;
        QVERIFY(end > 300);
        QVERIFY(ink(end - dots, dots) < ink(end - 4 * dots, dots) / 2);
        QCOMPARE(tipAt(m_line.get()), message);
        QCOMPARE(m_line->currentMessage(), message);
    }

    void aShortMessageNeedsNoTip() {
        m_line->showMessage(QStringLiteral("Saved."));
        QVERIFY(tipAt(m_line.get()).isEmpty());
    }

    // What is said about the key itself stays, and so does what is said in another window.
    void escapeTakesTheMessageAway() {
        QWidget window;
        auto* column = new QVBoxLayout(&window);
        auto* field = new QLineEdit;
        auto* inner = new StatusLine;
        column->addWidget(field);
        column->addWidget(inner);
        window.show();
        field->setFocus();
        const QString error = QStringLiteral("The attractor would be lost.");
        inner->showMessage(error);
        m_line->showMessage(error);
        QTest::keyClick(field, Qt::Key_A);
        QCOMPARE(inner->currentMessage(), error);
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(inner->currentMessage().isEmpty());
        QCOMPARE(m_line->currentMessage(), error);
        QShortcut escape(QKeySequence(Qt::Key_Escape), &window);
        const QString answer = QStringLiteral("Taken back.");
        connect(&escape, &QShortcut::activated, inner, [&] { inner->showMessage(answer); });
        QVERIFY(QTest::qWaitForWindowActive(&window));
        inner->showMessage(error);
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(inner->currentMessage(), answer);
    }

    // What is said with a step, before it or after it, is of this step.
    void whatIsSaidOfAStepGoesWithTheNext() {
        document::Document document;
        m_line->follow(document);
        const QString said = QStringLiteral("2 keys deleted.");
        const auto step = [&document] {
            document::Fractal fractal = document.fractal();
            document::plane(fractal)->system.maps[0].map.linear *= 0.5;
            document.edit(QStringLiteral("Step"), std::move(fractal));
        };
        step();
        m_line->showMessage(said);
        QCOMPARE(m_line->currentMessage(), said);
        QCoreApplication::processEvents();
        document.undoStack()->undo();
        QVERIFY(m_line->currentMessage().isEmpty());
        m_line->showMessage(said);
        step();
        QCOMPARE(m_line->currentMessage(), said);
        QCoreApplication::processEvents();
        step();
        QVERIFY(m_line->currentMessage().isEmpty());
    }

    // The end of a drag is a step; what was said during it is read after it.
    void whatIsSaidDuringADragStays() {
        document::Document document;
        m_line->follow(document);
        const QString said = QStringLiteral("The cage is folded.");
        document::EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
        document::Fractal fractal = document.fractal();
        document::plane(fractal)->system.maps[0].map.linear *= 0.5;
        gesture.preview(fractal);
        m_line->showMessage(said);
        QCoreApplication::processEvents();
        gesture.commit();
        QCOMPARE(document.undoStack()->count(), 1);
        QCOMPARE(m_line->currentMessage(), said);
        document.undoStack()->undo();
        QVERIFY(m_line->currentMessage().isEmpty());
    }

    void thePositionIsReadInFull() {
        auto* label = m_line->findChild<view::ElidedLabel*>();
        QVERIFY(label);
        label->setText(QStringLiteral("x 1 y 2"));
        QVERIFY(!view::composedTip(*label).contains(label->text()));
        label->setText(QStringLiteral("address 1 2 3 ").repeated(30));
        QVERIFY2(view::composedTip(*label).contains(label->text()), qPrintable(view::composedTip(*label)));
        QVERIFY(view::composedTip(*label).contains(QStringLiteral("barycentric"))); // what it is
    }

    // As the table, Analysis and `info` do.
    void theMapThatDoesNotContractIsNumberedAsListed() {
        document::Shape<2> shape;
        for (const double factor : {0.5, 2.0, 0.5, 0.5})
            ifs::append<2>(shape.system, {factor * ifs::Matrix<2>::Identity(), {1, 0}});
        shape.system.maps[0].enabled = false;
        QCOMPARE(verdictOn(shape), QStringLiteral("attractor: none: ρ(A) ≥ 1 for the word 2"));
        // A word of the last two.
        shape.system.maps[1].enabled = false;
        shape.system.maps[2].map.linear << 0, 4, 0, 0;
        shape.system.maps[3].map.linear << 0, 0, 4, 0;
        const QString word = verdictOn(shape);
        QVERIFY2(word.contains(QStringLiteral("3 4")) || word.contains(QStringLiteral("4 3")),
                 qPrintable(word));
    }

    void linksCountInPlaneAndSpace() {
        const QString plane = verdictOn(heldByItsLinks<2>());
        QVERIFY2(plane.startsWith(QStringLiteral("eventually contractive, γ = ")), qPrintable(plane));
        QCOMPARE(verdictOn(heldByItsLinks<3>()), plane);
    }

private:
    template <int Dim> QString verdictOn(const document::Shape<Dim>& shape) {
        document::Fractal fractal;
        fractal.shape = shape;
        m_line->showVerdict(fractal);
        for (const QLabel* label : m_line->findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("Existence of an attractor")) return label->text();
        return {};
    }

    static QString tipAt(QWidget* widget) {
        QToolTip::hideText();
        const QPoint middle(40, widget->height() / 2);
        QHelpEvent event(QEvent::ToolTip, middle, widget->mapToGlobal(middle));
        QCoreApplication::sendEvent(widget, &event);
        return QToolTip::text();
    }

    std::unique_ptr<StatusLine> m_line;
};

BARYCAGE_TEST(StatusLineTest, QApplication);
#include "status_line_test.moc"
