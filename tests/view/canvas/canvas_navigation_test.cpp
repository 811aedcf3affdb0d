// SPDX-License-Identifier: MIT
#include "bars/zoom_box.h"
#include "canvas/geometry/coordinate_text.h"
#include "canvas/geometry/grid_spacing.h"
#include "canvas/items/border_arrows_item.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <QLineEdit>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QSet>
#include <QSignalSpy>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <optional>

class CanvasNavigationTest : public CanvasFixture {
    Q_OBJECT

    const std::vector<view::BorderArrow>& arrows() const {
        for (const QGraphicsItem* item : scene().items())
            if (const auto* found = dynamic_cast<const view::BorderArrowsItem*>(item)) return found->arrows();
        static const std::vector<view::BorderArrow> none;
        return none;
    }

private slots:
    void init() { open(); }
    void cleanup() { close(); }

    // What is known of the picture goes along at once, however long the new one takes.
    void panningAndZoomingShowThePictureAtOnce() {
        QTRY_VERIFY(m_bridge->isCurrent());
        const QImage before = m_canvas->viewport()->grab().toImage();
        const QRgb ground = before.pixel(2, 2);
        const auto share = [&](const QImage& picture) {
            int shown = 0;
            for (int y = 100; y < 380; ++y)
                for (int x = 100; x < 540; ++x)
                    shown += picture.pixel(x, y) != ground;
            return shown / (280.0 * 440);
        };
        QVERIFY(share(before) > 0.1);
        const std::shared_ptr<const attractor::Frame> frame = m_bridge->frame();
        for (const bool zoom : {false, true}) {
            if (zoom) {
                m_canvas->navigation().zoomBy(1.1);
            } else {
                press({300, 200}, {}, Qt::MiddleButton);
                move({340, 225}, {}, Qt::MiddleButton);
            }
            QCOMPARE(m_bridge->frame(), frame); // there is no other yet
            const QImage after = m_canvas->viewport()->grab().toImage();
            QVERIFY(after != before);
            QVERIFY2(share(after) > 0.7 * share(before), qPrintable(QString::number(share(after))));
        }
    }

    // The cage is in the view where that costs little; the attractor always is, and large.
    void fitShowsTheAttractor() {
        const auto share = [this] { // of the height or width of the view
            const auto box = *document::displayedBox(m_document->fractal());
            const attractor::Camera& camera = m_canvas->camera();
            return std::max((box.max.x() - box.min.x()) * camera.pixelsPerUnit / camera.width,
                            (box.max.y() - box.min.y()) * camera.pixelsPerUnit / camera.height);
        };
        m_canvas->fit();
        for (int i = 0; i < 3; ++i)
            QVERIFY(m_canvas->viewport()->rect().contains(vertex(i)));
        document::Fractal fractal = m_document->fractal();
        ifs::ControlCage<2> cage = document::effectiveCage(fractal);
        const auto placement = ifs::displayMap(cage);
        for (std::size_t i = 0; i < cage.rest.size(); ++i) { // held from far away; the picture is the same
            cage.rest[i] = cage.rest[i] * 50;
            cage.current[i] = placement(cage.rest[i]);
        }
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("another cage"), fractal);
        m_canvas->fit();
        QVERIFY2(share() > 0.7 && share() < 1, qPrintable(QString::number(share())));
    }

    // However flat a cage is dragged, and wherever its picture lies on it then, its corners are in the view.
    void fitShowsAFlatCage_data() {
        QTest::addColumn<int>("corner");
        QTest::addColumn<double>("place"); // on the opposite side
        for (const int corner : {0, 1, 2})
            for (const double place : {0.0, 0.3, 0.5, 1.0, 4.0})
                QTest::addRow("corner %d at %.1f", corner + 1, place) << corner << place;
    }
    void fitShowsAFlatCage() {
        QFETCH(int, corner);
        QFETCH(double, place);
        document::Fractal fractal = m_document->fractal();
        document::System2 upright; // a line, which may become very short
        for (const Vector<2>& end : {Vector<2>(0.5, 0), Vector<2>(0.5, 1)}) {
            ifs::AffineMap<2> map;
            map.linear *= 0.5;
            map.translation = end / 2;
            ifs::append(upright, map, 0.5);
        }
        document::plane(fractal)->system = upright;
        ifs::ControlCage<2> cage = ifs::cageAtRest<2>({Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0.5, 1)});
        const Vector<2>& from = cage.rest[std::size_t(corner + 1) % 3];
        const Vector<2>& to = cage.rest[std::size_t(corner + 2) % 3];
        cage.current[std::size_t(corner)] = from + place * (to - from);
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("Flat"), fractal);
        key(Qt::Key_F);
        const QRect view = m_canvas->viewport()->rect();
        QTRY_VERIFY(view.contains(vertex(0)) && view.contains(vertex(1)) && view.contains(vertex(2)));
    }

    // A window that changes its size shows the moment that was fitted again, even where there is no
    // attractor.
    void resizingLeavesTheViewOfAnAnimation() {
        document::Fractal fractal = m_document->fractal();
        document::plane(fractal)->animation.emplace();
        document::plane(fractal)->animation->length = 32;
        document::plane(fractal)->animation->motions = {animation::Breathe<2>{{}, 0.5, 1, {0, 0}}};
        for (auto& map : document::plane(fractal)->system.maps)
            map.map.linear *= 1.6;
        m_document->setFile(document::fileOf(fractal));
        m_canvas->fit();
        const QRect whole = m_canvas->viewport()->rect();
        QTRY_VERIFY(whole.contains(vertex(0)) && whole.contains(vertex(1)) && whole.contains(vertex(2)));
        const attractor::Camera fitted = m_canvas->camera();
        const QSize size = m_canvas->size();
        const auto lost = document::firstWithoutAttractor(m_document->entryFractal());
        QVERIFY(lost);
        for (const animation::Moment& moment : {animation::moment(1), lost->moment}) {
            m_document->setMoment(moment);
            QCOMPARE(m_canvas->camera(), fitted);
            m_canvas->resize(size - QSize(0, 60));
            QTRY_VERIFY(m_canvas->camera().height < fitted.height);
            QVERIFY(m_canvas->navigation().isFitted());
            m_canvas->resize(size);
            QTRY_COMPARE(m_canvas->camera().height, fitted.height);
            QTRY_VERIFY(std::abs(m_canvas->camera().pixelsPerUnit - fitted.pixelsPerUnit) <
                        1e-6 * fitted.pixelsPerUnit);
            QVERIFY((m_canvas->camera().centre - fitted.centre).norm() < 1e-6);
        }
    }

    // From the first moment to the last one everything is in the view, whatever moment is shown.
    void fitShowsTheWholeMotion() {
        document::Fractal fractal = m_document->fractal();
        const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
        animation::Animation<2> animation;
        animation.length = 24;
        for (const int frame : {0, 24}) {
            std::vector<Vector<2>> corners = cage.current;
            for (Vector<2>& corner : corners)
                corner.x() += frame / 24.0 * 3;
            animation.cage.push_back({frame, corners, {}});
        }
        document::plane(fractal)->cage = cage;
        document::plane(fractal)->animation = animation;
        m_document->setFile(document::fileOf(fractal));
        const QRect view = m_canvas->viewport()->rect();
        const auto showsAll = [&] {
            return view.contains(vertex(0)) && view.contains(vertex(1)) && view.contains(vertex(2));
        };
        for (const int shown : {0, 12, 24}) {
            m_document->setMoment(animation::moment(shown));
            key(Qt::Key_F);
            for (const int frame : {0, 12, 24}) {
                m_document->setMoment(animation::moment(frame));
                QTRY_VERIFY2(showsAll(), qPrintable(QStringLiteral("%1, %2").arg(shown).arg(frame)));
            }
        }
    }

    // A command that moves the cage keeps it in the view; a drag goes where the hand goes.
    void commandsKeepTheCageInTheView() {
        m_canvas->fit();
        QTRY_VERIFY(arrows().empty());
        document::Fractal fractal = m_document->fractal();
        ifs::ControlCage<2> cage = document::effectiveCage(fractal);
        for (Vector<2>& corner : cage.current)
            corner += Vector<2>(4, 0);
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("Move the cage"), fractal);
        QTRY_VERIFY(arrows().empty());
        const attractor::Camera before = m_canvas->camera();
        drag(vertex(0), {-600, 0});
        QCOMPARE(m_canvas->camera(), before);
        QVERIFY(!arrows().empty());
        m_canvas->navigation().setZoom(1000); // who looks closer than the cage stays there
        const attractor::Camera close = m_canvas->camera();
        cage = document::effectiveCage(m_document->fractal());
        cage.current[1] += Vector<2>(0.1, 0.1);
        fractal = m_document->fractal();
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("Move the cage"), fractal);
        QCOMPARE(m_canvas->camera(), close);
    }

    // No hand in the canvas wants the corners elsewhere.
    void typedNumbersKeepTheCageInTheView() {
        m_canvas->fit();
        m_canvas->clearFocus();
        document::Fractal fractal = m_document->fractal();
        auto& cage = document::plane(fractal)->cage.emplace(document::effectiveCage(fractal));
        document::EditGesture typing = m_document->beginGesture(QStringLiteral("Type"));
        for (Vector<2>& corner : cage.current)
            corner += Vector<2>(4, 0);
        typing.preview(fractal);
        QVERIFY(!arrows().empty());
        typing.commit();
        QTRY_VERIFY(arrows().empty());
    }

    void anArrowLeadsToACornerOutside() {
        m_canvas->fit();
        QTRY_VERIFY(arrows().empty());
        QVERIFY(arrows().empty());
        const attractor::Camera fitted = m_canvas->camera();
        m_canvas->navigation().pan({-350, 0});
        const auto shown = arrows();
        QVERIFY(!shown.empty());
        for (const view::BorderArrow& arrow : shown) {
            QVERIFY(m_canvas->viewport()->rect().contains(arrow.at.toPoint()));
            const QPointF corner = at({Kind::Vertex, arrow.vertex});
            QVERIFY(!m_canvas->viewport()->rect().contains(corner.toPoint()));
            const QPointF way = corner - arrow.at; // the arrow points to its corner
            QVERIFY(QPointF::dotProduct(way, arrow.towards) > 0.999 * std::hypot(way.x(), way.y()));
        }
        hover(shown.front().at);
        QCOMPARE(cursor(), Qt::PointingHandCursor);
        click(shown.front().at);
        QTRY_COMPARE(m_canvas->camera(), fitted);
        QVERIFY(arrows().empty());
        QCOMPARE(steps(), 0);
    }

    // Corners of the selected maps are handles, too, with the tool that moves maps.
    void anArrowShowsACornerOfAMap() {
        document::Fractal fractal = m_document->fractal();
        ifs::ControlCage<2> cage = document::effectiveCage(fractal);
        cage.rest[2] = cage.current[2] = Vector<2>(40, 7); // so are the corners of the maps
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("A cage from afar"), fractal);
        m_canvas->setTool(CanvasView::Tool::Maps);
        m_canvas->selectMaps({system().maps[0].id, system().maps[1].id});
        m_canvas->fit();
        QTRY_VERIFY(!arrows().empty());
        const auto areVisible = [this] {
            for (const QGraphicsItem* item : scene().items())
                if (dynamic_cast<const view::BorderArrowsItem*>(item)) return item->isVisible();
            return false;
        };
        QVERIFY(areVisible());
        for (const view::BorderArrow& arrow : arrows())
            QVERIFY(arrow.vertex < 3); // numbered as the corners of the cage are
    }

    // Where F leaves out a corner that is very far away, its arrow leads there nevertheless.
    void anArrowShowsAllCorners() {
        document::Fractal fractal = m_document->fractal();
        ifs::ControlCage<2> cage = document::effectiveCage(fractal);
        cage.rest[0] = cage.current[0] = Vector<2>(-70, 20);
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("Another cage"), fractal);
        m_canvas->fit();
        const auto arrow = [this] {
            const auto& shown = arrows();
            const auto found = std::ranges::find(shown, 0, &view::BorderArrow::vertex);
            return found != shown.end() ? std::optional(found->at) : std::nullopt;
        };
        QTRY_VERIFY(arrow());
        click(*arrow());
        QTRY_VERIFY(arrows().empty());
    }

    // One corner is far away; those just outside the attractor are in the view nevertheless.
    void fitShowsTheCornersNearby() {
        document::Fractal fractal = m_document->fractal();
        const document::Box box = *document::displayedBox(fractal);
        const double height = box.max.y() - box.min.y();
        const double low = box.min.y() - 0.15 * height;
        ifs::ControlCage<2> cage = document::effectiveCage(fractal);
        cage.rest = {{box.min.x(), low}, {box.max.x(), low}, {box.min.x(), box.max.y() + 50 * height}};
        cage.current = cage.rest;
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("another cage"), fractal);
        m_canvas->fit();
        const QRect view = m_canvas->viewport()->rect();
        QTRY_VERIFY(view.contains(vertex(0)) && view.contains(vertex(1)));
        QVERIFY(!view.contains(vertex(2)));
    }

    // What is said of the pointer is true though it has not moved, whatever moves the view.
    void thePointIsReadAgainWhenTheViewMoves() {
        const QPointF p(200, 150);
        std::optional<Vector<2>> read;
        connect(m_canvas.get(), &CanvasView::pointerMoved, this,
                [&read](const view::PointerPosition& position) { read = position.world; });
        const auto isTrue = [&] {
            const double pixel = 1 / m_canvas->camera().pixelsPerUnit;
            return read && (*read - view::worldAt(m_canvas->camera(), p)).norm() < 0.01 * pixel;
        };
        hover(p);
        QVERIFY(isTrue());
        m_canvas->navigation().zoomBy(3);
        QTRY_VERIFY(isTrue());
        m_canvas->navigation().rotateBy(20);
        QTRY_VERIFY(isTrue());
        m_canvas->fit();
        QTRY_VERIFY(isTrue());
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(m_canvas->viewport(), &leave);
        read.reset();
        m_canvas->navigation().zoomBy(2);
        QCoreApplication::processEvents();
        QVERIFY(!read); // it is elsewhere
    }

    // Read-out and labels have the digits that neighbouring pixels differ in, at every depth.
    void coordinatesTellPixelsApart() {
        attractor::Camera camera = m_canvas->camera();
        camera.centre = {0.123456789012345, -1.987654321};
        for (camera.pixelsPerUnit = 1; camera.pixelsPerUnit < 1e13; camera.pixelsPerUnit *= 7)
            for (const int axis : {0, 1}) {
                const view::CoordinateText text(camera, axis);
                QStringList seen;
                for (int pixel = -300; pixel <= 300; pixel += 50)
                    for (const int next : {0, 1})
                        seen << text.text(camera.centre[axis] + (pixel + next) / camera.pixelsPerUnit);
                QCOMPARE(QSet<QString>(seen.begin(), seen.end()).size(), seen.size());
                for (const QString& each : seen)
                    QVERIFY2(each.size() <= 32, qPrintable(each));
                // A label is the read-out of its place: the base, where there is one, and what it says.
                const QString base = text.base().section(u' ', 0, 0);
                const double value = camera.centre[axis] + 200 / camera.pixelsPerUnit;
                const double said = (base.isEmpty() ? 0 : base.toDouble()) + text.label(value).toDouble();
                QVERIFY(std::abs(said - value) * camera.pixelsPerUnit < 1);
                QCOMPARE(base.isEmpty(), !text.text(value).contains(u'e'));
            }
    }

    // Where the axes cross there is a 0, however deep the view; other labels are round.
    void labelsOfDeepViewsAreReadable() {
        attractor::Camera camera = m_canvas->camera();
        for (const double centre : {0.0, 0.25, 0.123456789012345}) {
            camera.centre = {centre, centre};
            camera.pixelsPerUnit = 1e12 * 100;
            const view::CoordinateText text(camera, 0);
            const double step = view::gridSpacing(camera.pixelsPerUnit).major;
            const double base = text.base().section(u' ', 0, 0).toDouble();
            for (int k = -3; k <= 3; ++k) {
                const QString label = text.label(base + k * step);
                QVERIFY2(label.size() <= 8, qPrintable(label));
                if (k == 0) QCOMPARE(label, QStringLiteral("0"));
            }
        }
    }

    void anEmptyViewSaysSo() {
        const QString nothing = QStringLiteral("Nothing here.");
        m_canvas->fit();
        QTRY_VERIFY(m_bridge->isCurrent());
        QVERIFY(m_canvas->note().isEmpty());
        m_canvas->navigation().pan({5000, 0});
        QTRY_VERIFY2(m_canvas->note().startsWith(nothing), qPrintable(m_canvas->note()));
        key(Qt::Key_F);
        QTRY_VERIFY(m_canvas->note().isEmpty());
        m_bridge->showChaosGame(1, 1); // which has only begun
        QTRY_VERIFY(m_bridge->isCurrent());
        QVERIFY(m_canvas->note().isEmpty());
        m_bridge->showDensity();
        QTRY_VERIFY(m_bridge->isCurrent());
        // A hole in the middle of the picture shows nothing, too.
        m_canvas->navigation().setZoom(m_canvas->navigation().zoom() * 1000);
        const auto box = *document::displayedBox(m_document->fractal());
        attractor::Camera hole = m_canvas->camera();
        hole.centre = {box.min.x() + (box.max.x() - box.min.x()) * 0.5,
                       box.min.y() + (box.max.y() - box.min.y()) * 0.2};
        m_canvas->navigation().moveTo(hole);
        QTRY_VERIFY2(m_canvas->note().startsWith(nothing), qPrintable(m_canvas->note()));
        key(Qt::Key_F);
        QTRY_VERIFY(m_canvas->note().isEmpty());
    }

    // A warning is put away by a click or Esc and comes back when it is another one.
    void aWarningCanBePutAway() {
        document::Fractal fractal = m_document->fractal();
        ifs::ControlCage<2> cage;
        cage.rest = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        cage.current = {{0, 0}, {1, 0}, {0.45, 0.45}, {0, 1}};
        const document::Fractal before = fractal;
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("Notch"), fractal);
        m_canvas->fit();
        QTRY_VERIFY2(m_canvas->note().contains(QStringLiteral("folded")), qPrintable(m_canvas->note()));
        const auto box = [this] {
            for (const QGraphicsItem* item : scene().items())
                if (const auto* note = dynamic_cast<const view::NoteItem*>(item);
                    note && note->text() == m_canvas->note())
                    return note->box();
            return QRectF();
        };
        click(box().center());
        QVERIFY(m_canvas->note().isEmpty());
        QCOMPARE(steps(), 1);
        drag(vertex(2), {4, 3}); // it is still the same
        QTRY_VERIFY(m_bridge->isCurrent());
        QVERIFY(m_canvas->note().isEmpty());
        m_document->edit(QStringLiteral("Triangle"), before);
        m_document->edit(QStringLiteral("Notch"), fractal);
        QTRY_VERIFY(m_canvas->note().contains(QStringLiteral("folded")));
        key(Qt::Key_Escape);
        QVERIFY(m_canvas->note().isEmpty());
    }

    void theZoomIsShownAndTyped() {
        view::ZoomBox box(m_canvas.get());
        m_canvas->navigation().resetZoom();
        QCOMPARE(box.currentText(), QStringLiteral("100 %"));
        const Vector<2> centre = m_canvas->camera().centre;
        box.lineEdit()->setText(QStringLiteral("250%"));
        emit box.lineEdit()->returnPressed();
        QCOMPARE(m_canvas->camera().pixelsPerUnit, 250.0);
        QCOMPARE(m_canvas->camera().centre, centre);
        QCOMPARE(box.currentText(), QStringLiteral("250 %"));
        box.lineEdit()->setText(QStringLiteral("much"));
        emit box.lineEdit()->returnPressed(); // it stays, with the reason, to be mended
        QCOMPARE(box.currentText(), QStringLiteral("much"));
        QVERIFY(box.accessibleDescription().contains(QStringLiteral("not a number")));
        QCOMPARE(m_canvas->camera().pixelsPerUnit, 250.0);
        QVERIFY(box.lineEdit()->palette().color(QPalette::Text) != box.palette().color(QPalette::Text));
        QTest::keyClick(box.lineEdit(), Qt::Key_Escape);
        QCOMPARE(box.currentText(), QStringLiteral("250 %"));
        QVERIFY(box.accessibleDescription().isEmpty());
        box.lineEdit()->setText(QStringLiteral("-5 %"));
        emit box.lineEdit()->returnPressed();
        QVERIFY(box.accessibleDescription().contains(QStringLiteral("greater than 0")));
        emit box.lineEdit()->editingFinished();
        m_canvas->navigation().setZoom(1.5e9);
        QCOMPARE(box.currentText(), QStringLiteral("1.5e+11 %"));
        const QString thousandfold = QStringLiteral("100\u202f000 %");
        QVERIFY(box.findText(thousandfold) > 0);
        box.lineEdit()->setText(thousandfold);
        emit box.lineEdit()->returnPressed();
        QCOMPARE(m_canvas->navigation().zoom(), 1000.0);
        QCOMPARE(box.currentText(), thousandfold);
        QCOMPARE(view::ZoomBox::textOf(99999), QStringLiteral("1e+07 %"));
        emit box.activated(0);
        QVERIFY(m_canvas->navigation().isFitted());
        QCOMPARE(box.currentText(), view::ZoomBox::textOf(m_canvas->navigation().zoom()));
    }

    void aZoomPutsTheHintAway() {
        m_canvas->setHint(QStringLiteral("Drag a corner."));
        m_canvas->navigation().pan({3, 4});
        QVERIFY(!m_canvas->hint().isEmpty());
        QSignalSpy dismissed(m_canvas.get(), &view::CanvasView::hintDismissed);
        const QPointF p(123, 321);
        QWheelEvent wheel(p, m_canvas->viewport()->mapToGlobal(p), {}, QPoint(0, 120), Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_canvas->viewport(), &wheel);
        QVERIFY(m_canvas->hint().isEmpty());
        QCOMPARE(dismissed.size(), 1);
    }

    void wheelKeepsThePointUnderTheCursor() {
        const QPointF p(123, 321);
        for (const QPoint& angle : {QPoint(0, 120), QPoint(0, -360), QPoint(0, 15)})
            for (const QPoint& pixels : {QPoint(), QPoint(0, 37)}) {
                const Vector<2> world = view::worldAt(m_canvas->camera(), p);
                const double scale = m_canvas->camera().pixelsPerUnit;
                QWheelEvent wheel(p, m_canvas->viewport()->mapToGlobal(p), pixels, angle, Qt::NoButton, {},
                                  Qt::NoScrollPhase, false);
                QCoreApplication::sendEvent(m_canvas->viewport(), &wheel);
                QVERIFY(m_canvas->camera().pixelsPerUnit != scale);
                const QPointF now = view::pixelOf(m_canvas->camera(), world);
                QVERIFY(QLineF(now, p).length() < 1e-6);
            }
        m_canvas->navigation().resetZoom();
        QCOMPARE(m_canvas->camera().pixelsPerUnit, 100.0);
        for (int i = 0; i < 50; ++i)
            m_canvas->navigation().zoomBy(2);
        QVERIFY(m_canvas->camera().pixelsPerUnit > 1e12);
    }

    void wheelWithCtrlAndShiftTurnsAboutThePointer() {
        const QPointF p(123, 321);
        const auto turnWheel = [&](const QPoint& angle) {
            QWheelEvent wheel(p, m_canvas->viewport()->mapToGlobal(p), QPoint(), angle, Qt::NoButton,
                              Qt::ControlModifier | Qt::ShiftModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(m_canvas->viewport(), &wheel);
        };
        const attractor::Camera before = m_canvas->camera();
        const Vector<2> world = view::worldAt(before, p);
        turnWheel({0, 360});
        QCOMPARE(m_canvas->navigation().rotation(), 15.0);
        turnWheel({-240, 0}); // as some platforms report it with Shift
        QCOMPARE(m_canvas->navigation().rotation(), 5.0);
        QCOMPARE(m_canvas->camera().pixelsPerUnit, before.pixelsPerUnit);
        QVERIFY(QLineF(view::pixelOf(m_canvas->camera(), world), p).length() < 1e-6);
        m_canvas->navigation().resetRotation();
        QCOMPARE(m_canvas->camera().rotation, 0.0);
    }

    // Small twists belong to the pinch that zooms.
    void twistingFingersTurnTheView() {
        const auto gesture = [this](Qt::NativeGestureType type, double value) {
            const QPointF p(300, 200);
            QNativeGestureEvent event(type, QPointingDevice::primaryPointingDevice(), 2, p, p,
                                      m_canvas->viewport()->mapToGlobal(p), value, QPointF());
            QCoreApplication::sendEvent(m_canvas->viewport(), &event);
        };
        gesture(Qt::BeginNativeGesture, 0);
        gesture(Qt::RotateNativeGesture, 9);
        QCOMPARE(m_canvas->camera().rotation, 0.0);
        gesture(Qt::RotateNativeGesture, 21); // clockwise
        QCOMPARE(m_canvas->navigation().rotation(), -20.0);
        gesture(Qt::EndNativeGesture, 0);
        gesture(Qt::BeginNativeGesture, 0);
        gesture(Qt::RotateNativeGesture, -10);
        QCOMPARE(m_canvas->navigation().rotation(), -20.0);
    }

    void aTurnedViewIsWorkedInAsUsual() {
        const Vector<2> middle = view::worldAt(m_canvas->camera(), {320, 240});
        m_canvas->navigation().rotateBy(40);
        QVERIFY((view::worldAt(m_canvas->camera(), {320, 240}) - middle).norm() < 1e-12);
        m_canvas->fit();
        QCOMPARE(m_canvas->navigation().rotation(), 40.0);
        const auto box = *document::displayedBox(m_document->fractal());
        const QRectF shown = view::pixelsOf(m_canvas->camera(), box.min, box.max);
        QVERIFY(QRectF(m_canvas->viewport()->rect()).contains(shown));
        const QPointF before = at({Kind::Vertex, 0});
        drag(before.toPoint(), {25, -10});
        QVERIFY(QLineF(at({Kind::Vertex, 0}), before + QPointF(25, -10)).length() < 1e-6);
        QCOMPARE(steps(), 1);
        key(Qt::Key_Tab);
        const CanvasPart part = scene().selection().focused();
        const QPointF start = at(part);
        key(Qt::Key_Right); // on the screen, as before
        QVERIFY(QLineF(at(part), start + QPointF(1, 0)).length() < 1e-6);
        QTRY_VERIFY(m_bridge->isCurrent());
        QCOMPARE(m_bridge->frame()->camera.rotation, m_canvas->camera().rotation);
        m_canvas->navigation().resetRotation();
        QCOMPARE(m_canvas->camera().rotation, 0.0);
    }

    void middleButtonAndSpacePan() {
        const Vector<2> world = view::worldAt(m_canvas->camera(), {200, 200});
        press({200, 200}, {}, Qt::MiddleButton);
        QCOMPARE(cursor(), Qt::ClosedHandCursor);
        move({230, 180}, {}, Qt::MiddleButton);
        release({230, 180}, {}, Qt::MiddleButton);
        QVERIFY((view::worldAt(m_canvas->camera(), {230, 180}) - world).norm() < 1e-12);
        QTest::keyPress(m_canvas.get(), Qt::Key_Space);
        QCOMPARE(cursor(), Qt::OpenHandCursor);
        drag(vertex(0), {-30, 20});
        QTest::keyRelease(m_canvas.get(), Qt::Key_Space);
        QVERIFY((view::worldAt(m_canvas->camera(), {200, 200}) - world).norm() < 1e-12);
        QCOMPARE(steps(), 0);
    }

    void fingersDragAndPinch() {
        static const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        const auto touch = [&] { return QTest::touchEvent(m_canvas->viewport(), screen.get()); };
        const Vector<2> before = vertices()[1];
        const QPoint start = vertex(1) + QPoint(15, 0); // within the reach of a finger, not of a mouse
        touch().press(1, start, m_canvas->viewport());
        touch().move(1, start + QPoint(30, -20), m_canvas->viewport());
        touch().release(1, start + QPoint(30, -20), m_canvas->viewport());
        QVERIFY((vertices()[1] - before - view::worldOffset(m_canvas->camera(), {30, -20})).norm() < 1e-12);
        QCOMPARE(steps(), 1);
        const attractor::Camera camera = m_canvas->camera();
        touch().press(1, QPoint(200, 200), m_canvas->viewport());
        touch()
            .move(1, QPoint(200, 200), m_canvas->viewport())
            .press(2, QPoint(300, 200), m_canvas->viewport());
        touch()
            .move(1, QPoint(150, 220), m_canvas->viewport())
            .move(2, QPoint(350, 220), m_canvas->viewport());
        touch()
            .release(1, QPoint(150, 220), m_canvas->viewport())
            .release(2, QPoint(350, 220), m_canvas->viewport());
        QVERIFY(std::abs(m_canvas->camera().pixelsPerUnit / camera.pixelsPerUnit - 2) < 1e-9);
        QVERIFY((view::worldAt(m_canvas->camera(), {150, 220}) - view::worldAt(camera, {200, 200})).norm() <
                1e-9);
        QCOMPARE(steps(), 1);
    }
};

BARYCAGE_TEST(CanvasNavigationTest, QApplication);
#include "canvas_navigation_test.moc"
