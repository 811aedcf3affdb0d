// SPDX-License-Identifier: MIT
#include "widgets/numbers/draggable_names.h"

#include "widgets/numbers/number_field.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPointer>

#include <cmath>

namespace view {

namespace {

constexpr double pixelsPerStep = 4;

// Watches one label; belongs to it.
class NameDrag : public QObject {
public:
    NameDrag(QLabel* name, NumberField* field) : QObject(name), m_name(name), m_field(field) {
        name->setCursor(Qt::SizeHorCursor);
        name->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched != m_name || !m_field || !m_field->isEnabled()) return false;
        switch (event->type()) {
        case QEvent::MouseButtonPress:
            return press(static_cast<QMouseEvent&>(*event));
        case QEvent::MouseMove:
            return move(static_cast<QMouseEvent&>(*event));
        case QEvent::MouseButtonRelease:
            return end(&NumberField::endSteps);
        case QEvent::KeyPress:
            return static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && end(&NumberField::cancelSteps);
        case QEvent::Hide:
            end(&NumberField::endSteps);
            return false;
        default:
            return false;
        }
    }

private:
    bool press(const QMouseEvent& event) {
        if (event.button() != Qt::LeftButton) return false;
        m_isHeld = true;
        m_last = event.globalPosition().x();
        m_rest = 0;
        m_name->grabKeyboard(); // receives Esc
        return true;
    }

    bool move(const QMouseEvent& event) {
        if (!m_isHeld) return false;
        m_rest += (event.globalPosition().x() - m_last) / pixelsPerStep;
        m_last = event.globalPosition().x();
        const double whole = std::trunc(m_rest);
        m_rest -= whole;
        if (whole != 0) m_field->takeSteps(int(whole), event.modifiers());
        return true;
    }

    bool end(void (NumberField::*how)()) {
        if (!m_isHeld) return false;
        m_isHeld = false;
        m_name->releaseKeyboard();
        (m_field->*how)();
        return true;
    }

    QLabel* m_name;
    QPointer<NumberField> m_field;
    bool m_isHeld = false;
    double m_last = 0; // last position of the pointer in pixels
    double m_rest = 0; // steps still to be taken
};

} // namespace

void makeNamesDraggable(QWidget* root) {
    constexpr auto isDraggable = "isDraggable"; // property of the label
    for (auto* label : root->findChildren<QLabel*>())
        if (auto* field = qobject_cast<NumberField*>(label->buddy());
            field && !label->property(isDraggable).toBool()) {
            label->setProperty(isDraggable, true);
            new NameDrag(label, field);
        }
}

} // namespace view
