// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_navigation.h"
#include "canvas/items/overlay_style.h"
#include "support/named_test.h"
#include "view/space/space_window.h"

#include <QAccessible>
#include <QGraphicsScene>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPainter>
#include <QScopeGuard>

#include <algorithm>
#include <array>

using namespace space_window;
using view::AxisBall;
using End = view::AxisBall::End;

// The ball of axes by keyboard.
class AxisBallTest : public QObject {
    Q_OBJECT

private slots:
    void arrowsLeadWhereTheyPoint_data();
    void arrowsLeadWhereTheyPoint();
    void arrowsReachEveryEnd();
    void enterLooksAlongTheAxis_data();
    void enterLooksAlongTheAxis();
    void shiftTurnsTheView();
    void escapeLeavesTheBall();
    void aPressElsewhereLeavesTheBall();
    void tabLeavesAfterTheBall();
    void whatIsHiddenIsPassedOver();
    void screenReadersHearTheEnd();
    void theRingIsSeen_data();
    void theRingIsSeen();
};

namespace {

constexpr std::array<QPoint, 4> directions{QPoint(-1, 0), QPoint(1, 0), QPoint(0, -1), QPoint(0, 1)};

attractor::OrbitCamera turned(double azimuth, double elevation, double roll = 0) {
    attractor::OrbitCamera camera;
    camera.size = {600, 500};
    camera.orientation = attractor::orbit(azimuth, elevation, roll);
    return camera;
}

std::size_t indexOf(const End& end) {
    return std::size_t(2 * end.axis + (end.isPositive ? 0 : 1));
}

constexpr std::array<End, 6> ends{End{0, true},  End{0, false}, End{1, true},
                                  End{1, false}, End{2, true},  End{2, false}};

// No two ends are seen in one place, of which the one behind is reached by Enter.
bool areApart(const attractor::OrbitCamera& camera) {
    const ifs::Matrix<3> toCamera = worldToCamera(camera).linear;
    for (std::size_t i = 0; i < ends.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const auto seen = [&](const End& end) {
                return ifs::Vector<2>((end.isPositive ? 1 : -1) * toCamera.col(end.axis).head<2>());
            };
            if ((seen(ends[i]) - seen(ends[k])).norm() < 0.03) return false;
        }
    return true;
}

// How many ends the arrow keys reach from this one.
qsizetype reachedFrom(const AxisBall& ball, const End& start) {
    std::array<bool, 6> isReached{};
    std::vector<End> open{start};
    isReached[indexOf(start)] = true;
    while (!open.empty()) {
        const End from = open.back();
        open.pop_back();
        for (const QPoint& direction : directions) {
            const auto next = ball.beside(from, direction);
            if (next && !std::exchange(isReached[indexOf(*next)], true)) open.push_back(*next);
        }
    }
    return std::ranges::count(isReached, true);
}

void focusBall(const Window& window) {
    for (std::size_t stop = 0; stop <= window.view->cageItem().count(); ++stop)
        QTest::keyClick(window.view.get(), Qt::Key_Tab);
}

} // namespace

void AxisBallTest::arrowsLeadWhereTheyPoint_data() {
    QTest::addColumn<End>("from");
    QTest::addColumn<QPoint>("direction");
    QTest::addColumn<std::optional<End>>("to");
    const auto row = [](const char* name, const End& from, const QPoint& direction, std::optional<End> to) {
        QTest::newRow(name) << from << direction << to;
    };
    // From the front, z is in the middle.
    row("z left", {2, true}, {-1, 0}, End{0, false});
    row("z right", {2, true}, {1, 0}, End{0, true});
    row("z up", {2, true}, {0, -1}, End{1, true});
    row("z down", {2, true}, {0, 1}, End{1, false});
    row("to the one in front", {0, true}, {-1, 0}, End{2, true});
    row("off the ball", {0, true}, {1, 0}, std::nullopt);
    row("aside, where nothing is ahead", {1, true}, {-1, 0}, End{0, false});
}

void AxisBallTest::arrowsLeadWhereTheyPoint() {
    QFETCH(const End, from);
    QFETCH(const QPoint, direction);
    QFETCH(const std::optional<End>, to);
    AxisBall ball;
    ball.layOut(turned(0, 0));
    QCOMPARE(ball.front(), (End{2, true}));
    QVERIFY(ball.beside(from, direction) == to);
}

void AxisBallTest::arrowsReachEveryEnd() {
    AxisBall ball;
    int views = 0;
    for (int azimuth = -178; azimuth <= 180; azimuth += 7)
        for (int elevation = -88; elevation <= 88; elevation += 4)
            for (const int roll : {0, 33, 71}) {
                const attractor::OrbitCamera camera = turned(azimuth, elevation, roll);
                if (!areApart(camera)) continue;
                ++views;
                ball.layOut(camera);
                for (const End& start : ends)
                    QVERIFY2(reachedFrom(ball, start) == 6,
                             qPrintable(QStringLiteral("%1 %2 %3").arg(azimuth).arg(elevation).arg(roll)));
            }
    QVERIFY(views > 5000);
    ball.layOut(turned(0, 0));
    QCOMPARE(reachedFrom(ball, ball.front()), 5);
}

void AxisBallTest::enterLooksAlongTheAxis_data() {
    QTest::addColumn<Qt::Key>("key");
    QTest::newRow("Return") << Qt::Key_Return;
    QTest::newRow("Enter") << Qt::Key_Enter;
    QTest::newRow("Space") << Qt::Key_Space;
}

void AxisBallTest::enterLooksAlongTheAxis() {
    QFETCH(const Qt::Key, key);
    Window window;
    QVERIFY(window.rests());
    QVERIFY(!window.view->ball().focused());
    focusBall(window);
    const AxisBall& ball = window.view->ball();
    QVERIFY(ball.focused() == ball.front());
    const auto before = window.camera().orientation.coeffs().eval();
    QTest::keyClick(window.view.get(), Qt::Key_Up);
    const std::optional<End> chosen = ball.focused();
    QVERIFY(chosen && *chosen != ball.front());
    QVERIFY(window.camera().orientation.coeffs() == before); // the keys do not turn the view
    QTest::keyClick(window.view.get(), key);
    QTRY_VERIFY(AxisBall::looksFrom(window.camera(), *chosen));
    QVERIFY(ball.focused() == chosen && ball.front() == *chosen);
    QTest::keyClick(window.view.get(), key);
    const End behind{chosen->axis, !chosen->isPositive};
    QTRY_VERIFY(AxisBall::looksFrom(window.camera(), behind));
    QVERIFY(ball.focused() == behind);
    QVERIFY(!window.document.isModified());
    QCOMPARE(window.document.undoStack()->count(), 0);
}

void AxisBallTest::shiftTurnsTheView() {
    Window window;
    QVERIFY(window.rests());
    focusBall(window);
    const auto chosen = window.view->ball().focused();
    const attractor::Direction before = attractor::directionOf(window.camera(), attractor::UpAxis::Y);
    QTest::keyClick(window.view.get(), Qt::Key_Right, Qt::ShiftModifier);
    const attractor::Direction after = attractor::directionOf(window.camera(), attractor::UpAxis::Y);
    QVERIFY(std::abs(after.azimuth - before.azimuth - 5) < 1e-9);
    QVERIFY(window.view->ball().focused() == chosen);
}

void AxisBallTest::escapeLeavesTheBall() {
    Window window;
    QVERIFY(window.rests());
    focusBall(window);
    QKeyEvent escape(QEvent::ShortcutOverride, Qt::Key_Escape, Qt::NoModifier);
    escape.ignore();
    QCoreApplication::sendEvent(window.view.get(), &escape);
    QVERIFY(escape.isAccepted()); // whatever the window does with it
    QTest::keyClick(window.view.get(), Qt::Key_Escape);
    QVERIFY(!window.view->ball().focused());
    QVERIFY(window.view->hasFocus());
    const auto before = window.camera().orientation.coeffs().eval();
    QTest::keyClick(window.view.get(), Qt::Key_Right);
    QVERIFY(window.camera().orientation.coeffs() != before);
}

void AxisBallTest::aPressElsewhereLeavesTheBall() {
    Window window;
    QVERIFY(window.rests());
    focusBall(window);
    const QPointF middle = window.view->ball().boundingRect().center();
    window.drag(middle, middle + QPointF(20, 0)); // turns the view
    QVERIFY(window.view->ball().focused());
    window.drag(window.handle(0), window.handle(0) + QPointF(10, 0));
    QVERIFY(!window.view->ball().focused());
}

void AxisBallTest::tabLeavesAfterTheBall() {
    Window window;
    QVERIFY(window.rests());
    QWidget around;
    auto* row = new QHBoxLayout(&around);
    auto* before = new QLineEdit(&around);
    auto* after = new QLineEdit(&around);
    for (QWidget* widget : std::initializer_list<QWidget*>{before, window.view.get(), after})
        row->addWidget(widget);
    const auto alone = qScopeGuard([&window] { window.view->setParent(nullptr); });
    QWidget::setTabOrder(before, window.view.get());
    QWidget::setTabOrder(window.view.get(), after);
    around.resize(900, 500);
    around.show();
    QVERIFY(QTest::qWaitForWindowActive(&around));
    window.view->setFocus();
    focusBall(window);
    QVERIFY(window.view->ball().focused());
    QTest::keyClick(window.view.get(), Qt::Key_Tab);
    QCOMPARE(around.focusWidget(), after);
    QVERIFY(!window.view->ball().focused());
    window.view->setFocus(); // back: the ball is met first
    QTest::keyClick(window.view.get(), Qt::Key_Backtab, Qt::ShiftModifier);
    QVERIFY(window.view->ball().focused());
    QTest::keyClick(window.view.get(), Qt::Key_Backtab, Qt::ShiftModifier);
    QVERIFY(!window.view->ball().focused());
    QVERIFY(window.view->accessibleDescription().startsWith(QStringLiteral("Vertex 4")));
}

void AxisBallTest::whatIsHiddenIsPassedOver() {
    Window window;
    QVERIFY(window.rests());
    focusBall(window);
    window.view->setOverlaysVisible(false);
    QVERIFY(!window.view->ball().focused());
    const auto before = window.camera().orientation.coeffs().eval();
    QTest::keyClick(window.view.get(), Qt::Key_Right);
    QVERIFY(window.camera().orientation.coeffs() != before); // the keys turn the view
    Window fixed;
    fixed.view->fixDirection(view::directions::front, QStringLiteral("Front")); // it shows no ball
    focusBall(fixed);
    QVERIFY(!fixed.view->ball().focused());
}

namespace {

QStringList heard;

void hear(QAccessibleEvent* event) {
    if (event->type() == QAccessible::DescriptionChanged)
        heard << event->accessibleInterface()->text(QAccessible::Description);
}

} // namespace

void AxisBallTest::screenReadersHearTheEnd() {
    Window window;
    QVERIFY(window.rests());
    QAccessible::setActive(true);
    const auto before = QAccessible::installUpdateHandler(&hear);
    const auto restored = qScopeGuard([before] { QAccessible::installUpdateHandler(before); });
    const auto description = [&window] { return window.view->accessibleDescription(); };
    focusBall(window);
    QCOMPARE(description(), QStringLiteral("Ball of axes, positive end of Z. Enter looks from there, the "
                                           "arrow keys choose another end."));
    heard.clear();
    QTest::keyClick(window.view.get(), Qt::Key_Down);
    QVERIFY(description().startsWith(QStringLiteral("Ball of axes, negative end of Y.")));
    QTest::keyClick(window.view.get(), Qt::Key_Return);
    QTRY_VERIFY(description().endsWith(QStringLiteral("Enter looks from behind.")));
    if (QAccessible::isActive()) QCOMPARE(heard.size(), 2); // not on every platform; nothing is said twice
    QTest::keyClick(window.view.get(), Qt::Key_Escape);
    QVERIFY(description().startsWith(QStringLiteral("The attractor")));
}

void AxisBallTest::theRingIsSeen_data() {
    QTest::addColumn<attractor::Rgba>("background");
    QTest::newRow("dark") << attractor::Rgba{12, 14, 18, 255};
    QTest::newRow("light") << attractor::Rgba{255, 255, 255, 255};
}

void AxisBallTest::theRingIsSeen() {
    QFETCH(const attractor::Rgba, background);
    const view::OverlayStyle style = view::overlayStyle(background, QPalette());
    QGraphicsScene scene; // owns the ball
    auto* ball = new AxisBall;
    scene.addItem(ball);
    ball->setStyle(style);
    ball->layOut(turned(30, 20));
    const auto marked = [&] {
        QImage image(600, 200, QImage::Format_ARGB32_Premultiplied);
        image.fill(style.backdrop);
        QPainter painter(&image);
        ball->paint(&painter, nullptr, nullptr);
        int pixels = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (image.pixelColor(x, y) == style.accent) ++pixels;
        return pixels;
    };
    QCOMPARE(marked(), 0);
    for (const End& end : ends) { // also of an end behind another
        ball->setFocused(end);
        QVERIFY2(marked() > 60, qPrintable(QString::number(marked())));
    }
}

BARYCAGE_TEST(AxisBallTest, QApplication);
#include "axis_ball_test.moc"
