// SPDX-License-Identifier: MIT
#include "panels/lesson/lesson_card.h"

#include "document/lesson/lesson.h"
#include "widgets/whats_this.h"

#include <QAccessible>
#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

// Lines of text in the height of the window; readable from the back of a room.
constexpr double linesInHeight = 34;
constexpr double lettersInWidth = 32;
constexpr double titleScale = 1.35;
constexpr double smallScale = 0.75;
constexpr double longestEnlarged =
    500; // characters; longer texts get a smaller font, down to that of the window

QLabel* plainLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

} // namespace

LessonCard::LessonCard(QWidget* parent)
    : QFrame(parent),
      m_lesson(plainLabel(this)),
      m_progress(plainLabel(this)),
      m_title(plainLabel(this)),
      m_text(plainLabel(this)),
      m_scroll(new QScrollArea(this)),
      m_back(new QPushButton(tr("&Back"), this)),
      m_next(new QPushButton(this)),
      m_end(new QPushButton(tr("&End"), this)) {
    setAccessibleName(tr("Lesson"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    m_progress->setWordWrap(false);
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_text->setMargin(0);
    m_scroll->setWidget(m_text);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setAccessibleName(tr("Text of the step"));
    m_scroll->viewport()->setAutoFillBackground(false);
    m_text->setAutoFillBackground(false);
    for (QLabel* label : {m_lesson, m_progress})
        label->setForegroundRole(QPalette::PlaceholderText);
    m_back->setObjectName(QStringLiteral("back"));
    m_next->setObjectName(QStringLiteral("next"));
    m_end->setObjectName(QStringLiteral("end"));
    m_back->setToolTip(tr("Show the previous step (Page Up)"));
    m_next->setToolTip(tr("Show the next step (Page Down)"));
    m_end->setToolTip(tr("End the lesson and return to the window as it was (Esc)"));

    auto* head = new QHBoxLayout;
    head->addWidget(m_lesson, 1);
    head->addWidget(m_progress, 0, Qt::AlignTop);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_end);
    buttons->addStretch();
    buttons->addWidget(m_back);
    buttons->addWidget(m_next);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 20);
    layout->setSpacing(14);
    layout->addLayout(head);
    layout->addWidget(m_title);
    layout->addWidget(m_scroll, 1);
    layout->addLayout(buttons);
    setWhatsThis(tr("A lesson in progress: the text of the current step, and buttons to go to the others."));
    explainByTips(this);
    connect(m_back, &QPushButton::clicked, this, &LessonCard::backRequested);
    connect(m_next, &QPushButton::clicked, this,
            [this] { m_isLast ? emit endRequested() : emit nextRequested(); });
    connect(m_end, &QPushButton::clicked, this, &LessonCard::endRequested);
    for (QWidget* part : std::initializer_list<QWidget*>{m_back, m_next, m_end, m_scroll})
        part->installEventFilter(this);
}

void LessonCard::takeFocus() {
    m_next->setFocus();
}

void LessonCard::showStep(const document::Lesson& lesson, int step) {
    const document::LessonStep& shown = lesson.steps[step];
    m_isFirst = step == 0;
    m_isLast = step + 1 == lesson.steps.size();
    m_lesson->setText(lesson.title);
    m_progress->setText(tr("%1 of %2").arg(step + 1).arg(lesson.steps.size()));
    m_title->setText(shown.title);
    m_title->setVisible(!shown.title.isEmpty());
    m_text->setText(shown.text);
    m_next->setText(m_isLast ? tr("&Done") : tr("&Next"));
    if (m_isFirst && m_back->hasFocus()) takeFocus();
    m_back->setEnabled(!m_isFirst);
    m_end->setVisible(!m_isLast);
    m_scroll->verticalScrollBar()->setValue(0);
    adaptLetters();
    setAccessibleDescription(shown.title + QStringLiteral(". ") + shown.text);
    QAccessibleEvent event(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

void LessonCard::adaptLetters() {
    const QFont base = QApplication::font(this);
    const double usual = QFontMetricsF(base).lineSpacing();
    const double width = QFontMetricsF(base).averageCharWidth();
    double scale = std::min(height() / (linesInHeight * usual), this->width() / (lettersInWidth * width));
    scale *= std::min(1.0, std::sqrt(longestEnlarged / std::max(1.0, double(m_text->text().size()))));
    scale = std::clamp(scale, 1.0, 4.0);
    const auto scaled = [&](QLabel* label, double by) {
        QFont font = base;
        if (font.pointSizeF() > 0)
            font.setPointSizeF(font.pointSizeF() * std::max(1.0, by * scale));
        else
            font.setPixelSize(int(font.pixelSize() * std::max(1.0, by * scale)));
        font.setBold(label == m_title);
        if (label->font() != font) label->setFont(font);
    };
    scaled(m_text, 1);
    scaled(m_title, titleScale);
    scaled(m_lesson, smallScale);
    scaled(m_progress, smallScale);
}

void LessonCard::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    adaptLetters();
}

void LessonCard::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::FontChange) adaptLetters();
}

bool LessonCard::takeKey(int key) {
    switch (key) {
    case Qt::Key_Right:
        if (!m_isLast) emit nextRequested();
        return true;
    case Qt::Key_Left:
        if (!m_isFirst) emit backRequested();
        return true;
    default:
        return false;
    }
}

// Buttons would pass the arrow keys among themselves.
bool LessonCard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && takeKey(static_cast<QKeyEvent*>(event)->key())) return true;
    return QFrame::eventFilter(watched, event);
}

} // namespace view
