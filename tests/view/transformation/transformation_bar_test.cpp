// SPDX-License-Identifier: MIT
#include "transformation/transformation_bar.h"

#include "io/fractint/fractint_reader.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "widgets/text/elided_label.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QTest>

#include <memory>

using view::TransformationBar;

// The bar in a window of 1440 pixels, with names and sentences that are longer than it.
class TransformationBarTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        const QByteArray maps(" {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
        m_file = io::readFractint("the_first" + maps + longName + '1' + maps + longName + '2' + maps);
        QCOMPARE(m_file.entries.size(), 3);
        m_bar = std::make_unique<TransformationBar>();
        show(1);
        m_bar->resize(640, m_bar->sizeHint().height());
        m_bar->setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(m_bar.get()));
    }

    // Of names that are told apart by their ends, the ends are seen, and all of them in the list.
    void namesEndInDots() {
        auto* partner = m_bar->findChild<QComboBox*>();
        QCOMPARE(partner->currentText(), QString::fromLatin1(longName) + u'1');
        QVERIFY(partner->fontMetrics().horizontalAdvance(partner->currentText()) > partner->width());
        const QImage first = partner->grab().toImage();
        show(2);
        QCOMPARE(partner->currentText(), QString::fromLatin1(longName) + u'2');
        QVERIFY(partner->grab().toImage() != first);
        partner->showPopup();
        QTRY_VERIFY(partner->view()->isVisible());
        QVERIFY(partner->view()->viewport()->width() >= partner->view()->sizeHintForColumn(0));
        partner->hidePopup();
    }

    void itFitsASmallWindow_data() { support::addLanguages(); }

    // Whatever is offered, and however long the names are.
    void itFitsASmallWindow() {
        QFETCH(QString, language);
        const support::Spoken spoken(language);
        QVERIFY(spoken.isInstalled());
        m_bar = std::make_unique<TransformationBar>();
        m_bar->show(m_file, m_file.entries.at(1).id, m_file.entries.at(2).id, {});
        for (const auto remedy :
             {TransformationBar::Remedy::DivideWords, TransformationBar::Remedy::ResetOrder,
              TransformationBar::Remedy::FindPicture}) {
            m_bar->showProblem(QStringLiteral("?"), remedy);
            QVERIFY2(m_bar->minimumSizeHint().width() <= 500,
                     qPrintable(QString::number(m_bar->minimumSizeHint().width())));
        }
    }

    void sentencesHaveTwoLines() {
        const view::ElidedLabel* status = nullptr;
        for (const auto* label : m_bar->findChildren<view::ElidedLabel*>())
            if (label->accessibleName() == QStringLiteral("State of the fractal transformation"))
                status = label;
        QVERIFY(status);
        const QFontMetrics metrics = status->fontMetrics();
        QVERIFY(status->height() >= 2 * metrics.lineSpacing());
        const int height = m_bar->sizeHint().height();
        QString sentence = QStringLiteral("Proved:");
        while (metrics.horizontalAdvance(sentence) < 1.5 * status->width())
            sentence += QStringLiteral(" no jump");
        m_bar->showContinuity(sentence);
        QVERIFY(!status->isCut());
        m_bar->showContinuity(sentence + sentence);
        QVERIFY(status->isCut());
        QCOMPARE(m_bar->sizeHint().height(), height);
    }

private:
    static constexpr char longName[] = "a_name_that_is_longer_than_any_box_in_a_window_ought_to_be_";

    void show(qsizetype partner) {
        m_bar->show(m_file, m_file.entries.at(0).id, m_file.entries.at(partner).id, {});
    }

    document::FractalFile m_file;
    std::unique_ptr<TransformationBar> m_bar;
};

BARYCAGE_TEST(TransformationBarTest, QApplication);
#include "transformation_bar_test.moc"
