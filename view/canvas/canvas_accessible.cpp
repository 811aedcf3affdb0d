// SPDX-License-Identifier: MIT
#include "canvas/canvas_accessible.h"

#include "canvas/canvas_scene.h"
#include "canvas/canvas_view.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QPointer>

#include <algorithm>
#include <iterator>
#include <memory>

namespace view {

namespace {

int childIndex(const CanvasScene& scene, const CanvasPart& part) {
    const std::vector<CanvasPart> handles = scene.handles();
    const auto found = std::ranges::find(handles, part);
    return found == handles.end() ? -1 : int(found - handles.begin());
}

// What the arrow keys do, for clients that press no keys.
struct Move {
    Q_DECLARE_TR_FUNCTIONS(AccessibleHandle)
public:
    const char* name;
    const char* text;
    int key;
};
constexpr Move moves[] = {{"moveLeft", QT_TRANSLATE_NOOP("AccessibleHandle", "Move left"), Qt::Key_Left},
                          {"moveRight", QT_TRANSLATE_NOOP("AccessibleHandle", "Move right"), Qt::Key_Right},
                          {"moveUp", QT_TRANSLATE_NOOP("AccessibleHandle", "Move up"), Qt::Key_Up},
                          {"moveDown", QT_TRANSLATE_NOOP("AccessibleHandle", "Move down"), Qt::Key_Down}};

const Move* moveCalled(const QString& name) {
    const auto* found =
        std::ranges::find_if(moves, [&](const Move& move) { return name == QLatin1String(move.name); });
    return found == std::end(moves) ? nullptr : found;
}

class AccessibleHandle final : public QAccessibleInterface, public QAccessibleActionInterface {
public:
    AccessibleHandle(CanvasView* canvas, int index) : m_canvas(canvas), m_index(index) {}

    bool isValid() const override { return m_canvas && m_index < int(handles().size()); }
    QObject* object() const override { return nullptr; }
    QWindow* window() const override { return parent() ? parent()->window() : nullptr; }
    QAccessibleInterface* childAt(int, int) const override { return nullptr; }
    QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(m_canvas); }
    QAccessibleInterface* child(int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface*) const override { return -1; }
    void setText(QAccessible::Text, const QString&) override {}
    // Not Grip, which the accessibility bus of Linux knows as “unknown”.
    QAccessible::Role role() const override { return QAccessible::Graphic; }
    void* interface_cast(QAccessible::InterfaceType type) override {
        return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this)
                                                    : nullptr;
    }

    QStringList actionNames() const override {
        QStringList names{setFocusAction()};
        for (const Move& move : moves)
            names << QLatin1String(move.name);
        return names;
    }
    QString localizedActionName(const QString& name) const override {
        const Move* move = moveCalled(name);
        return move ? Move::tr(move->text) : QAccessibleActionInterface::localizedActionName(name);
    }
    QStringList keyBindingsForAction(const QString& name) const override {
        const Move* move = moveCalled(name);
        return move ? QStringList(QKeySequence(move->key).toString(QKeySequence::NativeText)) : QStringList();
    }
    void doAction(const QString& name) override {
        if (!isValid()) return;
        m_canvas->focusOn(part());
        const Move* move = moveCalled(name);
        if (!move) return;
        QKeyEvent press(QEvent::KeyPress, move->key, Qt::NoModifier);
        QCoreApplication::sendEvent(m_canvas, &press);
        QKeyEvent release(QEvent::KeyRelease, move->key, Qt::NoModifier);
        QCoreApplication::sendEvent(m_canvas, &release);
    }

    QString text(QAccessible::Text kind) const override {
        if (!isValid()) return {};
        const CanvasScene& scene = m_canvas->canvas();
        if (kind == QAccessible::Name) return scene.nameOf(part());
        return kind == QAccessible::Value || kind == QAccessible::Description ? scene.placeOf(part())
                                                                              : QString();
    }

    QRect rect() const override {
        if (!isValid()) return {};
        const QPoint middle =
            m_canvas->viewport()->mapToGlobal(m_canvas->canvas().positionOf(part()).toPoint());
        return QRect(middle - QPoint(12, 12), QSize(24, 24));
    }

    QAccessible::State state() const override {
        QAccessible::State state;
        if (!isValid()) {
            state.invalid = true;
            return state;
        }
        state.focusable = true;
        state.movable = true;
        state.invisible = !m_canvas->overlaysVisible();
        state.focused = m_canvas->hasFocus() && m_canvas->canvas().focused() == part();
        return state;
    }

private:
    std::vector<CanvasPart> handles() const { return m_canvas->canvas().handles(); }
    CanvasPart part() const { return handles()[std::size_t(m_index)]; }

    QPointer<CanvasView> m_canvas;
    int m_index;
};

class AccessibleCanvas final : public QAccessibleWidget {
public:
    explicit AccessibleCanvas(CanvasView* canvas)
        : QAccessibleWidget(canvas, QAccessible::Canvas), m_canvas(canvas) {}
    ~AccessibleCanvas() override {
        for (const QAccessible::Id id : m_children)
            QAccessible::deleteAccessibleInterface(id);
    }

    int childCount() const override { return int(m_canvas->canvas().handles().size()); }

    QAccessibleInterface* child(int index) const override {
        if (index < 0 || index >= childCount()) return nullptr;
        while (int(m_children.size()) <= index) {
            auto handle = std::make_unique<AccessibleHandle>(m_canvas, int(m_children.size()));
            m_children.push_back(QAccessible::registerAccessibleInterface(handle.release()));
        }
        return QAccessible::accessibleInterface(m_children[std::size_t(index)]);
    }

    int indexOfChild(const QAccessibleInterface* child) const override {
        for (int i = 0; i < int(m_children.size()); ++i)
            if (QAccessible::accessibleInterface(m_children[std::size_t(i)]) == child) return i;
        return -1;
    }

    QAccessibleInterface* childAt(int x, int y) const override {
        const QPoint position = m_canvas->viewport()->mapFromGlobal(QPoint(x, y));
        return child(childIndex(m_canvas->canvas(), m_canvas->canvas().partAt(position, Reach::Mouse)));
    }

    QAccessibleInterface* focusChild() const override {
        if (!m_canvas->hasFocus()) return nullptr;
        return child(childIndex(m_canvas->canvas(), m_canvas->canvas().focused()));
    }

private:
    CanvasView* m_canvas;
    mutable std::vector<QAccessible::Id> m_children; // made when first asked for
};

QAccessibleInterface* factory(const QString&, QObject* object) {
    auto* canvas = qobject_cast<CanvasView*>(object);
    return canvas ? new AccessibleCanvas(canvas) : nullptr;
}

} // namespace

void installCanvasAccessibility() {
    static const bool installed = [] {
        QAccessible::installFactory(&factory);
        return true;
    }();
    Q_UNUSED(installed)
}

void announceFocus(CanvasView& canvas) {
    const int place = childIndex(canvas.canvas(), canvas.canvas().focused());
    if (place < 0 || !QAccessible::isActive()) return;
    QAccessibleEvent event(&canvas, QAccessible::Focus);
    event.setChild(place);
    QAccessible::updateAccessibility(&event);
}

void announceMotion(CanvasView& canvas) {
    const CanvasScene& scene = canvas.canvas();
    const int place = childIndex(scene, scene.focused());
    if (place < 0 || !QAccessible::isActive()) return;
    QAccessibleValueChangeEvent event(&canvas, scene.placeOf(scene.focused()));
    event.setChild(place);
    QAccessible::updateAccessibility(&event);
}

} // namespace view
