// SPDX-License-Identifier: MIT
#include "tour.h"

#include "canvas/canvas_view.h"
#include "panels/maps_panel.h"
#include "settings.h"

#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QToolBar>

#include <iterator>

namespace {

constexpr int gap = 3; // between the frame and its target

// The canvas, a panel or a bar of the window, by its object name.
struct Step {
    const char* target; // empty: the canvas
    const char* title;
    const char* text;
    int column = -1; // of the table of maps, that is spoken of
};

constexpr Step steps[] = {
    {"maps", QT_TRANSLATE_NOOP("Tour", "Contraction"),
     QT_TRANSLATE_NOOP("Tour",
                       "Every row of this table is a map that makes a smaller copy of the whole, and the "
                       "picture is all copies together. Double-click a number and type another: the copy "
                       "moves as you type. ‖A‖ is the most by which a map stretches. While it is less than "
                       "1, the map contracts. Ctrl+Z takes everything back."),
     view::MapsModel::Contraction},
    {"maps", QT_TRANSLATE_NOOP("Tour", "Fixed point"),
     QT_TRANSLATE_NOOP(
         "Tour",
         "A map that contracts leaves exactly one point where it is: its fixed point. Switch "
         "off all maps but two by the boxes on the left of the table, and see how little is left of the "
         "picture. With one map alone nothing is left but its fixed point. Ctrl+Z brings "
         "the maps back."),
     view::MapsModel::Enabled},
    {"arising", QT_TRANSLATE_NOOP("Tour", "Chaos game"),
     QT_TRANSLATE_NOOP("Tour",
                       "Press Chaos Game and then the triangle that starts it. One point jumps about, each "
                       "time by a map drawn at random, and leaves a dot where it lands. Let it go faster: "
                       "whatever the dice say, the dots fill the same picture, the attractor.")},
    {"appearance", QT_TRANSLATE_NOOP("Tour", "Address"),
     QT_TRANSLATE_NOOP("Tour",
                       "The map that made the last jump to a point, the one before it, and so on: these "
                       "numbers are the address of the point. Choose Colour by: Address. Points whose "
                       "addresses begin alike lie close together, and now they look alike.")},
    {"", QT_TRANSLATE_NOOP("Tour", "Barycentric coordinates"),
     QT_TRANSLATE_NOOP("Tour",
                       "Every point of the picture is a weighted mean of the three corners of the triangle. "
                       "Take a corner and pull: the points keep their weights, and the whole fractal "
                       "follows. Squeeze the triangle flat and open it again: nothing is lost. The weights "
                       "at the pointer stand at the bottom of the window.")},
    {"analysis", QT_TRANSLATE_NOOP("Tour", "Dimension"),
     QT_TRANSLATE_NOOP("Tour",
                       "How much of the plane does the attractor fill? The dimension of a curve is 1, that "
                       "of an area is 2, and most attractors lie between the two. Change a map and look "
                       "here again. That was the tour; the user guide under Help tells the rest.")},
};
constexpr int stepCount = int(std::size(steps));

QString offeredKey() {
    return QStringLiteral("hints/tour");
}

// A frame that lets every click through.
class Mark : public QWidget {
public:
    explicit Mark(QWidget* parent) : QWidget(parent) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
        setFocusPolicy(Qt::NoFocus);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 3));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 6, 6);
    }
};

} // namespace

void Tour::start(QMainWindow* window) {
    for (Tour* old : window->findChildren<Tour*>(Qt::FindDirectChildrenOnly))
        delete old;
    (new Tour(window))->showStep(0);
}

bool Tour::offer(QMainWindow* window) {
    if (view::stored(offeredKey(), false).toBool()) return false;
    (new Tour(window))->showStep(-1);
    return true;
}

Tour::Tour(QMainWindow* host)
    : Card(host),
      m_mark(new Mark(host)),
      m_place(new QLabel(this)),
      m_title(createTitle()),
      m_text(new QLabel(this)),
      m_back(new QPushButton(tr("&Back"), this)),
      m_next(new QPushButton(this)),
      m_close(new QPushButton(this)) {
    setObjectName(QStringLiteral("tour"));
    setAccessibleName(tr("Tour"));
    m_text->setWordWrap(true);
    m_place->setForegroundRole(QPalette::PlaceholderText);

    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_place);
    QBoxLayout* buttons = createButtons();
    buttons->addWidget(m_close);
    buttons->addStretch();
    buttons->addWidget(m_back);
    buttons->addWidget(m_next);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin - 2, margin, margin - 2);
    layout->setSpacing(10);
    layout->addLayout(head);
    layout->addWidget(m_text);
    layout->addLayout(buttons);

    connect(m_back, &QPushButton::clicked, this, [this] { showStep(m_step - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] {
        if (m_step + 1 < stepCount)
            showStep(m_step + 1);
        else
            close();
    });
    connect(m_close, &QPushButton::clicked, this, &QWidget::close);
}

Tour::~Tour() {
    leaveStep();
    delete m_mark;
}

void Tour::leaveStep() {
    if (m_target) unfollow(m_target);
    if (auto* bar = qobject_cast<QToolBar*>(m_target.data()); bar && m_barWasHidden) bar->hide();
    m_target = nullptr;
    m_barWasHidden = false;
}

void Tour::showStep(int step) {
    leaveStep();
    m_step = step;
    view::store(offeredKey(), true);
    const bool asking = step < 0;
    if (asking) {
        m_title->setText(tr("New here?"));
        m_text->setText(
            tr("Six short steps show what an attractor is, by pulling on one. You can take the tour "
               "later, too: it is in the Help menu."));
    } else {
        const Step& now = steps[step];
        m_title->setText(tr(now.title));
        m_text->setText(tr(now.text));
        const QString name = QString::fromLatin1(now.target);
        if (auto* dock = host()->findChild<QDockWidget*>(name); dock && !name.isEmpty()) {
            dock->show();
            dock->raise();
            m_target = dock;
        } else if (auto* bar = host()->findChild<QToolBar*>(name); bar && !name.isEmpty()) {
            m_barWasHidden = bar->isHidden();
            bar->show();
            m_target = bar;
        } else if (auto* canvas = host()->findChild<view::CanvasView*>()) {
            canvas->setOverlaysVisible(true);
            canvas->setTool(view::CanvasView::Tool::Cage);
            m_target = canvas;
        }
    }
    if (m_target) follow(m_target);
    if (auto* canvas = host()->findChild<view::CanvasView*>(); canvas && asking) follow(canvas->viewport());
    if (auto* maps = host()->findChild<view::MapsPanel*>(); maps && !asking && steps[step].column >= 0)
        QTimer::singleShot(0, maps, [maps, step] { maps->reveal(steps[step].column); });
    m_place->setText(asking ? QString() : tr("%1 of %2").arg(step + 1).arg(stepCount));
    m_back->setVisible(step > 0);
    m_next->setText(asking ? tr("&Start the Tour") : step + 1 == stepCount ? tr("&Done") : tr("&Next"));
    m_next->setDefault(true);
    m_next->setFocus(); // so that Return goes on
    m_close->setText(asking ? tr("Not Now") : tr("Close"));
    m_close->setVisible(step + 1 < stepCount);
    m_mark->setVisible(m_target != nullptr);
    appear(m_text->text());
}

// Who begins on his own does not want to be asked any more.
bool Tour::eventFilter(QObject* watched, QEvent* event) {
    if (m_step < 0 && event->type() == QEvent::MouseButtonPress) close();
    return Card::eventFilter(watched, event);
}

// On the canvas, at the side of the target; in its upper left corner where the target is the canvas.
QPoint Tour::corner() {
    if (!m_target) return Card::corner();
    const QRect pointed(m_target->mapTo(host(), QPoint()), m_target->size());
    m_mark->setGeometry(pointed.adjusted(-gap, -gap, gap, gap).intersected(host()->rect()));
    m_mark->raise();
    const QRect room = this->room();
    QPoint corner = room.topLeft() + QPoint(margin, margin);
    if (pointed.left() >= room.right()) corner.setX(room.right() - margin - width());
    if (pointed.top() >= room.bottom() || m_target == host()->centralWidget())
        corner.setY(room.bottom() - noteRoom - height());
    return corner;
}
