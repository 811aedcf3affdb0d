// SPDX-License-Identifier: MIT
#include "panels/appearance/appearance_panel.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "panels/appearance/palettes/gradient_preview.h"
#include "panels/appearance/palettes/palette_browser.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include "attractor/colour/palette_library.h"
#include "support/named_test.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>

#include <memory>

using namespace maps_support;
using view::PaletteBrowser;

namespace {

int shown(const PaletteBrowser& browser) {
    return browser.list()->model()->rowCount();
}

} // namespace

class PaletteBrowserTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(maple()));
        m_panel = std::make_unique<view::AppearancePanel>(m_document.get());
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }

    void theSearchNarrowsAndEnterUses() {
        PaletteBrowser browser(palette(), nullptr);
        browser.show();
        QVERIFY(QTest::qWaitForWindowActive(&browser));
        QVERIFY(shown(browser) > 200);
        QVERIFY(browser.search()->hasFocus());
        QTest::keyClicks(browser.search(), QStringLiteral("glow crim"));
        QCOMPARE(shown(browser), 1);
        QCOMPARE(browser.title(), QStringLiteral("Crimson Glow"));
        QVERIFY(browser.palette() == *attractor::findInLibrary("Crimson Glow"));
        const QSignalSpy accepted(&browser, &QDialog::accepted);
        QTest::keyClick(browser.search(), Qt::Key_Return);
        QCOMPARE(accepted.count(), 1);
        browser.search()->setText(QStringLiteral("no such thing"));
        QCOMPARE(shown(browser), 0);
    }

    void favouritesAreRemembered() {
        {
            PaletteBrowser browser(palette(), nullptr);
            browser.search()->setText(QStringLiteral("Teal Metal"));
            QTest::mouseClick(browser.favourite(), Qt::LeftButton);
            browser.search()->clear();
        }
        PaletteBrowser browser(palette(), nullptr);
        browser.onlyFavourites()->setChecked(true);
        QCOMPARE(shown(browser), 1);
        QCOMPARE(browser.list()->model()->index(0, 0).data().toString(), QStringLiteral("★ Teal Metal"));
        QCOMPARE(browser.title(), QStringLiteral("Teal Metal"));
        QVERIFY(browser.favourite()->isChecked());
        QTest::mouseClick(browser.favourite(), Qt::LeftButton);
        QCOMPARE(shown(browser), 0);
    }

    void huesTurnAndThePaletteShifts() {
        PaletteBrowser browser(palette(), nullptr);
        const attractor::Palette before = browser.palette();
        type(browser.hue()->field(), QStringLiteral("90"));
        QVERIFY(!(browser.palette() == before));
        type(browser.hue()->field(), QStringLiteral("0"));
        QVERIFY(browser.palette() == before);
        type(browser.shift()->field(), QStringLiteral("0.5"));
        QCOMPARE(attractor::colourAt(browser.palette(), 0), attractor::colourAt(before, 0.5));
        type(browser.shift()->field(), QStringLiteral("0"));
        browser.reversed()->setChecked(true);
        QCOMPARE(attractor::colourAt(browser.palette(), 0), attractor::colourAt(before, 1));
    }

    void oneStepAfterManyTries() {
        inBrowser([](PaletteBrowser& browser) {
            browser.search()->setText(QStringLiteral("Jade Glow"));
            type(browser.hue()->field(), QStringLiteral("30"));
            browser.search()->setText(QStringLiteral("Crimson Bands"));
            type(browser.hue()->field(), QStringLiteral("0"));
            browser.accept();
        });
        QVERIFY(palette() == *attractor::findInLibrary("Crimson Bands"));
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Palette: Crimson Bands"));
        QCOMPARE(m_panel->gradient()->currentText(), QStringLiteral("Crimson Bands"));
        m_document->undoStack()->undo();
        QVERIFY(palette() == attractor::builtInPalettes().front());
    }

    void cancelRestoresThePalette() {
        inBrowser([this](PaletteBrowser& browser) {
            browser.search()->setText(QStringLiteral("Jade Glow"));
            QVERIFY(palette() == *attractor::findInLibrary("Jade Glow")); // live
            browser.reject();
        });
        QVERIFY(palette() == attractor::builtInPalettes().front());
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

private:
    const attractor::Palette& palette() const { return m_document->fractal().appearance.palette; }

    static void type(view::NumberField* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }

    void inBrowser(const std::function<void(PaletteBrowser&)>& work) {
        bool done = false;
        QTimer::singleShot(0, m_panel.get(), [&] {
            auto* browser = m_panel->findChild<PaletteBrowser*>();
            QVERIFY(browser != nullptr);
            work(*browser);
            done = true;
        });
        QTest::mouseClick(m_panel->browsePalettes(), Qt::LeftButton);
        QVERIFY(done);
    }

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<view::AppearancePanel> m_panel;
};

BARYCAGE_TEST(PaletteBrowserTest, QApplication);
#include "palette_browser_test.moc"
