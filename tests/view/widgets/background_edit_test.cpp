// SPDX-License-Identifier: MIT
#include "widgets/background/background_edit.h"

#include "document/background/background_threads.h"
#include "document/document.h"
#include "support/background_rest.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QSemaphore>

#include <memory>

using view::BackgroundEdit;

class BackgroundEditTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_taken = 0; }
    void cleanupTestCase() { QVERIFY(document::backgroundFinishes(std::chrono::seconds(30))); }

    void whatIsFoundAtOnceIsTakenAtOnce() {
        m_edit.start([](const auto& fractal) { return renamed(fractal); }, take());
        QCOMPARE(m_taken, 1);
        QCOMPARE(m_document.fractal().name, QStringLiteral("found"));
        QVERIFY(support::backgroundRests());
        QCOMPARE(m_taken, 1);
    }
    void whatTakesLongIsTakenLater() {
        const auto gate = std::make_shared<QSemaphore>();
        m_edit.start(behind(gate), take());
        QCOMPARE(m_taken, 0);
        gate->release();
        QTRY_COMPARE(m_taken, 1);
    }
    void whatComesTooLateIsNotTaken() {
        const auto gate = std::make_shared<QSemaphore>();
        m_edit.start(behind(gate), take());
        document::Fractal other = m_document.fractal();
        other.name = QStringLiteral("other");
        m_document.edit(QStringLiteral("meanwhile"), other);
        gate->release();
        QVERIFY(support::backgroundRests());
        QCOMPARE(m_taken, 0);
        QCOMPARE(m_document.fractal().name, QStringLiteral("other"));
    }
    void theNewestReplacesTheOneBefore() {
        const auto gate = std::make_shared<QSemaphore>();
        m_edit.start(behind(gate), take());
        m_edit.start([](const auto& fractal) { return renamed(fractal); }, take());
        QCOMPARE(m_taken, 1);
        gate->release();
        QVERIFY(support::backgroundRests());
        QCOMPARE(m_taken, 1);
    }
    void thereMayBeNone() {
        bool isNone = false;
        m_edit.start([](const auto&) -> std::optional<document::Fractal> { return std::nullopt; },
                     [&](std::optional<document::Fractal> found) { isNone = !found; });
        QVERIFY(isNone);
    }

private:
    static std::optional<document::Fractal> renamed(document::Fractal fractal) {
        fractal.name = QStringLiteral("found");
        return fractal;
    }
    static BackgroundEdit::Find behind(const std::shared_ptr<QSemaphore>& gate) {
        return [gate](const document::Fractal& fractal) {
            gate->acquire();
            return renamed(fractal);
        };
    }
    BackgroundEdit::Take take() {
        return [this](std::optional<document::Fractal> found) {
            ++m_taken;
            m_document.edit(QStringLiteral("found"), *std::move(found));
        };
    }

    document::Document m_document;
    BackgroundEdit m_edit{&m_document};
    int m_taken = 0;
};

BARYCAGE_TEST(BackgroundEditTest, QApplication);
#include "background_edit_test.moc"
