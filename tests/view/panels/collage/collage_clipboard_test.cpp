// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "view/panels/collage_panel_fixture.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>
#include <QToolButton>

namespace {

// A picture as other programs offer it: its file, and the promise of an image, for which Qt would decode the
// file.
class OfferedPicture : public QMimeData {
public:
    explicit OfferedPicture(const QByteArray& file) { setData(QStringLiteral("image/png"), file); }

    QStringList formats() const override {
        return {QStringLiteral("application/x-qt-image"), QStringLiteral("image/png")};
    }
    bool hasFormat(const QString& type) const override { return formats().contains(type); }
    int timesDecoded() const { return m_decoded; }

protected:
    QVariant retrieveData(const QString& type, QMetaType wanted) const override {
        if (type == QLatin1String("application/x-qt-image")) ++m_decoded;
        return QMimeData::retrieveData(type, wanted);
    }

private:
    mutable int m_decoded = 0;
};

} // namespace

// Targets that come from the clipboard, or from an entry.
class CollageClipboardTest : public CollagePanelFixture {
    Q_OBJECT

private slots:
    void init() { openPanel(); }
    void cleanup() {
        m_panel.reset();
        close();
    }

    void thePictureMayComeFromTheClipboardOrAnEntry() {
        QGuiApplication::clipboard()->setImage(leaf(96));
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Paste")), Qt::LeftButton);
        settle();
        QVERIFY(m_panel->target()->traced());
        QCOMPARE(m_panel->target()->traced()->mask.width, 96);
        // As other programs offer it: a file, which is not decoded by the clipboard.
        auto* offered = new QMimeData;
        offered->setData(QStringLiteral("image/png"), encoded(leaf(64), "PNG"));
        QGuiApplication::clipboard()->setMimeData(offered);
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Paste")), Qt::LeftButton);
        settle();
        QCOMPARE(m_panel->target()->traced()->mask.width, 64);
        m_panel->target()->take(m_document->sharedFractal());
        settle();
        QVERIFY(m_panel->target()->traced()->mask.width > 400); // the triangle
        QGuiApplication::clipboard()->setText(QStringLiteral("no picture"));
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Paste")), Qt::LeftButton);
        QCOMPARE(sentence(), QStringLiteral("There is no picture on the clipboard."));
    }

    // A picture may take all memory, or minutes: it is decoded beside the window, within the limits of files.
    void theClipboardDecodesNoPicture() {
        auto* offered = new OfferedPicture(encoded(leaf(64), "PNG"));
        QGuiApplication::clipboard()->setMimeData(offered);
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Paste")), Qt::LeftButton);
        settle();
        QCOMPARE(m_panel->target()->traced()->mask.width, 64);
        QCOMPARE(offered->timesDecoded(), 0);
    }
};

BARYCAGE_TEST(CollageClipboardTest, QApplication);
#include "collage_clipboard_test.moc"
