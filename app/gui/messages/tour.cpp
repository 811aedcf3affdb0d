// SPDX-License-Identifier: MIT
#include "messages/tour.h"

#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "desktop/settings.h"
#include "panels/maps/maps_panel.h"

#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QToolBar>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

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
                       "Each row of this table is a map that makes a smaller copy of the whole; the picture "
                       "is all the copies together. Double-click a number and type another: the copy moves "
                       "as you type. ‖A‖ is the largest factor by which a map stretches distances. As long "
                       "as it is less than 1, the map contracts. Press Ctrl+Z to undo your changes."),
     view::MapsModel::Contraction},
    {"maps", QT_TRANSLATE_NOOP("Tour", "Fixed point"),
     QT_TRANSLATE_NOOP(
         "Tour",
         "A map that contracts leaves exactly one point unchanged: its fixed point. Switch off all maps but "
         "two with the eyes on the left of the table, and see how little of the picture is left. With "
         "a single map, only its fixed point is left. Press Ctrl+Z to bring the maps back."),
     view::MapsModel::Enabled},
    {"construction", QT_TRANSLATE_NOOP("Tour", "Chaos game"),
     QT_TRANSLATE_NOOP("Tour", "Press Chaos Game, then Play. A single point jumps around, each time by a map "
                               "chosen at random, and leaves a dot where it lands. Make it faster: whatever "
                               "random numbers come up, the dots fill the same picture, the attractor.")},
    {"appearance", QT_TRANSLATE_NOOP("Tour", "Address"),
     QT_TRANSLATE_NOOP(
         "Tour", "The map of the last jump to a point, the map of the jump before it, and so on: these "
                 "numbers are the address of the point. Choose Colour by: Address. Points whose addresses "
                 "begin with the same numbers are close together, and now they have similar colours.")},
    {"", QT_TRANSLATE_NOOP("Tour", "Barycentric coordinates"),
     QT_TRANSLATE_NOOP(
         "Tour",
         "Every point of the picture is a weighted mean of the three corners of the triangle. Drag a corner: "
         "the points keep their weights, and the whole fractal follows. Squeeze the triangle flat and open "
         "it again: nothing is lost. The weights under the pointer are shown in the status bar.")},
    {"analysis", QT_TRANSLATE_NOOP("Tour", "Dimension"),
     QT_TRANSLATE_NOOP("Tour",
                       "How much of the plane does the attractor fill? A curve has dimension 1, an area has "
                       "dimension 2, and most attractors are in between. Change a map and look here again. "
                       "This is the end of the tour; the user guide in the Help menu tells you more.")},
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
    : MessageBanner(host),
      m_mark(new Mark(host)),
      m_progress(new QLabel(this)),
      m_title(createTitle()),
      m_text(new QLabel(this)),
      m_back(new QPushButton(tr("&Back"), this)),
      m_next(new QPushButton(this)),
      m_close(new QPushButton(this)) {
    setObjectName(QStringLiteral("tour"));
    setAccessibleName(tr("Tour"));
    m_text->setWordWrap(true);
    m_progress->setForegroundRole(QPalette::PlaceholderText);

    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_progress);
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

// That of the longest step, so that the buttons stay under the pointer.
void Tour::keepSize(bool asking) {
    const auto widthOf = [this](const QString& text) {
        return m_next->fontMetrics().horizontalAdvance(text);
    };
    m_next->setMinimumWidth(std::max(widthOf(tr("&Next")), widthOf(tr("&Done"))) + 2 * margin);
    int tallest = 0;
    const QRect column(0, 0, maxWidth - 2 * margin, 10'000);
    for (const Step& each : steps) {
        const QRect needed = m_text->fontMetrics().boundingRect(column, Qt::TextWordWrap, tr(each.text));
        tallest = std::max(tallest, needed.height());
    }
    m_text->setMinimumHeight(asking ? 0 : tallest + m_text->fontMetrics().lineSpacing());
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
}

void Tour::showStep(int step) {
    leaveStep();
    m_step = step;
    view::store(offeredKey(), true);
    const bool asking = step < 0;
    if (asking) {
        m_title->setText(tr("New here?"));
        m_text->setText(tr("Six short steps show you what an attractor is while you drag one. You can also "
                           "take the tour later: it is in the Help menu."));
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
            canvas->options().setOverlaysVisible(true);
            canvas->setTool(view::CanvasView::Tool::Cage);
            m_target = canvas;
        }
    }
    if (auto* canvas = host()->findChild<view::CanvasView*>(); canvas && !asking) canvas->dismissHint();
    if (m_target) follow(m_target);
    if (auto* canvas = host()->findChild<view::CanvasView*>(); canvas && asking) follow(canvas->viewport());
    if (auto* maps = host()->findChild<view::MapsPanel*>(); maps && !asking && steps[step].column >= 0)
        QTimer::singleShot(0, maps, [maps, step] { maps->reveal(steps[step].column); });
    m_progress->setText(asking ? QString() : tr("%1 of %2").arg(step + 1).arg(stepCount));
    m_back->setVisible(step > 0);
    keepSize(asking);
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
    return MessageBanner::eventFilter(watched, event);
}

QPoint Tour::freeCorner() const {
    constexpr int reach = 40; // of a corner, with the round handle beside it
    QRect room = canvasRect();
    if (const auto* bar = host()->findChild<QToolBar*>(QStringLiteral("construction"));
        bar && bar->isHidden())
        room.setBottom(room.bottom() - bar->sizeHint().height()); // a step shows it
    std::vector<QPoint> handles;
    if (const auto* canvas = host()->findChild<view::CanvasView*>(); canvas && canvas->isVisible())
        if (const auto& cage = canvas->canvas().handles().cage())
            for (const QPointF& corner : view::pixelsOf(canvas->camera(), cage->current))
                handles.push_back(canvas->viewport()->mapTo(host(), corner.toPoint()));
    const int left = room.left() + margin;
    const int right = room.right() - margin - width();
    const int top = room.top() + margin;
    const int bottom = room.bottom() - hintHeight - height();
    const auto covered = [&](const QPoint& place) {
        const QRect card = QRect(place, size()).adjusted(-reach, -reach, reach, reach);
        return std::ranges::count_if(handles, [&](const QPoint& handle) { return card.contains(handle); }) +
               (place.y() < top ? std::ssize(handles) + 1 : 0); // it would not fit in there
    };
    return std::ranges::min(
        {QPoint(right, top), QPoint(left, bottom), QPoint(left, top), QPoint(right, bottom)}, {}, covered);
}

// In one place and of one height for all steps, so that the buttons stay under the pointer.
QPoint Tour::topLeft() {
    if (!m_target) return MessageBanner::topLeft();
    const QRect pointed(m_target->mapTo(host(), QPoint()), m_target->size());
    m_mark->setGeometry(pointed.adjusted(-gap, -gap, gap, gap).intersected(host()->rect()));
    m_mark->raise();
    // Whether a bar takes some of its height or not.
    const std::array room{canvasRect().left(), canvasRect().width(), host()->height(), height()};
    if (std::exchange(m_room, room) != room) m_place = freeCorner();
    return m_place;
}
