// SPDX-License-Identifier: MIT
#include "canvas/canvas_accessible.h"

#include "canvas/scene/canvas_scene.h"
#include "canvas/scene/handle_text.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QGraphicsView>
#include <QKeyEvent>
#include <QPointer>

#include <algorithm>
#include <iterator>
#include <memory>

namespace view {

namespace {

// nullptr while the view is being taken down.
CanvasScene* sceneOf(const QGraphicsView* view) {
    return view ? qobject_cast<CanvasScene*>(view->scene()) : nullptr;
}

std::vector<CanvasPart> handlesOf(const QGraphicsView* view) {
    const CanvasScene* scene = sceneOf(view);
    return scene ? scene->handles().parts() : std::vector<CanvasPart>();
}

int childIndex(const QGraphicsView* view, const CanvasPart& part) {
    const std::vector<CanvasPart> handles = handlesOf(view);
    const auto found = std::ranges::find(handles, part);
    return found == handles.end() ? -1 : int(found - handles.begin());
}

int focusedIndex(const QGraphicsView* view) {
    const CanvasScene* scene = sceneOf(view);
    return scene ? childIndex(view, scene->selection().focused()) : -1;
}

// Moves by the arrow keys, for clients that press no keys.
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
    AccessibleHandle(QGraphicsView* view, int index) : m_view(view), m_index(index) {}

    bool isValid() const override { return m_index < int(handlesOf(m_view).size()); }
    QObject* object() const override { return nullptr; }
    QWindow* window() const override { return parent() ? parent()->window() : nullptr; }
    QAccessibleInterface* childAt(int, int) const override { return nullptr; }
    QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(m_view); }
    QAccessibleInterface* child(int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface*) const override { return -1; }
    void setText(QAccessible::Text, const QString&) override {}
    // Graphic instead of Grip, which the accessibility bus of Linux reports as “unknown”.
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
        m_view->setFocus(Qt::TabFocusReason);
        sceneOf(m_view)->selection().setFocused(part());
        const Move* move = moveCalled(name);
        if (!move) return;
        QKeyEvent press(QEvent::KeyPress, move->key, Qt::NoModifier);
        QCoreApplication::sendEvent(m_view, &press);
        QKeyEvent release(QEvent::KeyRelease, move->key, Qt::NoModifier);
        QCoreApplication::sendEvent(m_view, &release);
    }

    QString text(QAccessible::Text kind) const override {
        if (!isValid()) return {};
        const CanvasScene& scene = *sceneOf(m_view);
        if (kind == QAccessible::Name) return nameOf(scene.handles(), part());
        return kind == QAccessible::Value || kind == QAccessible::Description
                   ? valueOf(scene.handles(), scene.camera(), part())
                   : QString();
    }

    QRect rect() const override {
        if (!isValid()) return {};
        const QPoint middle = m_view->viewport()->mapToGlobal(sceneOf(m_view)->positionOf(part()).toPoint());
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
        state.invisible = !sceneOf(m_view)->overlaysVisible();
        state.focused = m_view->hasFocus() && sceneOf(m_view)->selection().focused() == part();
        return state;
    }

private:
    CanvasPart part() const { return handlesOf(m_view)[std::size_t(m_index)]; }

    QPointer<QGraphicsView> m_view;
    int m_index;
};

class AccessibleCanvas final : public QAccessibleWidget {
public:
    explicit AccessibleCanvas(QGraphicsView* view)
        : QAccessibleWidget(view, QAccessible::Canvas), m_view(view) {}
    ~AccessibleCanvas() override {
        for (const QAccessible::Id id : m_children)
            QAccessible::deleteAccessibleInterface(id);
    }

    int childCount() const override { return int(handlesOf(m_view).size()); }

    QAccessibleInterface* child(int index) const override {
        if (index < 0 || index >= childCount()) return nullptr;
        while (int(m_children.size()) <= index) {
            auto handle = std::make_unique<AccessibleHandle>(m_view, int(m_children.size()));
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
        const CanvasScene* scene = sceneOf(m_view);
        const QPoint position = m_view->viewport()->mapFromGlobal(QPoint(x, y));
        return scene ? child(childIndex(m_view, scene->partAt(position, Reach::Mouse))) : nullptr;
    }

    QAccessibleInterface* focusChild() const override {
        return m_view->hasFocus() ? child(focusedIndex(m_view)) : nullptr;
    }

private:
    QGraphicsView* m_view;
    mutable std::vector<QAccessible::Id> m_children; // created on demand
};

QAccessibleInterface* factory(const QString&, QObject* object) {
    auto* view = qobject_cast<QGraphicsView*>(object);
    return sceneOf(view) ? new AccessibleCanvas(view) : nullptr;
}

} // namespace

void installCanvasAccessibility() {
    static const bool installed = [] {
        QAccessible::installFactory(&factory);
        return true;
    }();
    Q_UNUSED(installed)
}

void announceFocus(QGraphicsView& view) {
    const int index = QAccessible::isActive() ? focusedIndex(&view) : -1;
    if (index < 0) return;
    QAccessibleEvent event(&view, QAccessible::Focus);
    event.setChild(index);
    QAccessible::updateAccessibility(&event);
}

void announceMotion(QGraphicsView& view) {
    const int index = QAccessible::isActive() ? focusedIndex(&view) : -1;
    if (index < 0) return;
    const CanvasScene& scene = *sceneOf(&view);
    QAccessibleValueChangeEvent event(&view,
                                      valueOf(scene.handles(), scene.camera(), scene.selection().focused()));
    event.setChild(index);
    QAccessible::updateAccessibility(&event);
}

} // namespace view
