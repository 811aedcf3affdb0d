// SPDX-License-Identifier: MIT
#include "desktop/preferences.h"
#include "desktop/reduced_motion.h"
#include "support/named_test.h"
#include "support/own_settings.h"

#include <QApplication>
#include <QProxyStyle>
#include <QTest>

namespace {

class StyleOf : public QProxyStyle {
public:
    explicit StyleOf(int milliseconds) : m_milliseconds(milliseconds) {}
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* returned) const override {
        if (hint == SH_Widget_Animation_Duration) return m_milliseconds;
        return QProxyStyle::styleHint(hint, option, widget, returned);
    }

private:
    int m_milliseconds;
};

} // namespace

// The user's word counts most, then the desktop's, then the style's.
class ReducedMotionTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }

    void whoDecides_data();
    void whoDecides();
    void otherSettingsSayNothing();
};

void ReducedMotionTest::whoDecides_data() {
    using Motion = view::Preferences::Motion;
    QTest::addColumn<Motion>("preferred");
    QTest::addColumn<QString>("key"); // of the desktop; empty: it says nothing
    QTest::addColumn<bool>("value");
    QTest::addColumn<int>("duration"); // milliseconds of the style's animations
    QTest::addColumn<bool>("isReduced");
    QTest::newRow("nobody") << Motion::Desktop << QString() << false << 200 << false;
    QTest::newRow("the style") << Motion::Desktop << QString() << false << 0 << true;
    QTest::newRow("the portal") << Motion::Desktop << QStringLiteral("reduced-motion") << true << 200 << true;
    QTest::newRow("the portal, against the style")
        << Motion::Desktop << QStringLiteral("reduced-motion") << false << 0 << false;
    QTest::newRow("GNOME") << Motion::Desktop << QStringLiteral("enable-animations") << false << 200 << true;
    QTest::newRow("GNOME, against the style")
        << Motion::Desktop << QStringLiteral("enable-animations") << true << 0 << false;
    QTest::newRow("the user, against all")
        << Motion::Reduced << QStringLiteral("reduced-motion") << false << 200 << true;
    QTest::newRow("the user, who wants motion")
        << Motion::Full << QStringLiteral("reduced-motion") << true << 0 << false;
}

void ReducedMotionTest::whoDecides() {
    QFETCH(view::Preferences::Motion, preferred);
    QFETCH(QString, key);
    QFETCH(bool, value);
    QFETCH(int, duration);
    QFETCH(bool, isReduced);
    for (const view::MotionSetting& setting : view::motionSettings()) // what earlier rows have said
        qApp->setProperty((QByteArray("desktop/") + setting.key).constData(), {});
    view::Preferences preferences;
    preferences.motion = preferred;
    preferences.store();
    QApplication::setStyle(new StyleOf(duration));
    for (const view::MotionSetting& setting : view::motionSettings())
        if (key == QLatin1String(setting.key))
            view::takeDesktopSetting(QLatin1String(setting.group), key, value);
    QCOMPARE(view::reducesMotion(), isReduced);
}

void ReducedMotionTest::otherSettingsSayNothing() {
    view::Preferences().store();
    QApplication::setStyle(new StyleOf(200));
    for (const view::MotionSetting& setting : view::motionSettings())
        qApp->setProperty((QByteArray("desktop/") + setting.key).constData(), {});
    view::takeDesktopSetting(QStringLiteral("org.example"), QStringLiteral("reduced-motion"), true);
    view::takeDesktopSetting(QStringLiteral("org.freedesktop.appearance"), QStringLiteral("color-scheme"), 1);
    QVERIFY(!view::reducesMotion());
}

BARYCAGE_TEST(ReducedMotionTest, QApplication);
#include "reduced_motion_test.moc"
