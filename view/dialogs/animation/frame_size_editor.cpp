// SPDX-License-Identifier: MIT
#include "dialogs/animation/frame_size_editor.h"

#include "widgets/choices.h"
#include "widgets/icon.h"
#include "widgets/numbers/number_box.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr int leastSide = 16;
constexpr int mostSide = 16'384;

QSpinBox* sideBox(const QString& name, const QString& explanation, QWidget* parent) {
    auto* box = new WholeNumberBox(parent);
    box->setRange(leastSide, mostSide);
    box->setKeyboardTracking(false); // a half-typed side would change the other one
    box->setAccessibleName(name);
    box->setWhatsThis(explanation);
    return box;
}

int scaled(int side, int from, int to) {
    return std::clamp(int(std::lround(double(side) * to / std::max(from, 1))), leastSide, mostSide);
}

} // namespace

FrameSizeEditor::FrameSizeEditor(QWidget* parent)
    : QWidget(parent),
      m_named(new QComboBox(this)),
      m_width(sideBox(tr("Width"), tr("The width of the frames in pixels."), this)),
      m_height(sideBox(tr("Height"), tr("The height of the frames in pixels."), this)),
      m_lock(new QToolButton(this)),
      m_turn(new QToolButton(this)) {
    addNamedSizes();
    m_named->setAccessibleName(tr("Named size"));
    m_named->setWhatsThis(tr("Usual sizes of videos."));
    m_lock->setIcon(icon(QStringLiteral("lock")));
    m_lock->setAccessibleName(tr("Lock proportions"));
    m_lock->setToolTip(tr("Keep the proportions of the frames"));
    m_lock->setCheckable(true);
    m_lock->setChecked(true);
    m_turn->setIcon(icon(QStringLiteral("turn")));
    m_turn->setAccessibleName(tr("Portrait or landscape"));
    m_turn->setToolTip(tr("Swap width and height"));
    auto* sides = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_width, new QLabel(QStringLiteral("×"), this),
                                                           m_height, m_lock, m_turn})
        sides->addWidget(widget);
    sides->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_named, 0, Qt::AlignLeft);
    layout->addLayout(sides);
    setFocusProxy(m_named);
    connect(m_width, &QSpinBox::valueChanged, this, &FrameSizeEditor::takeWidth);
    connect(m_height, &QSpinBox::valueChanged, this, &FrameSizeEditor::takeHeight);
    connect(m_lock, &QToolButton::toggled, this, [this] { m_locked = size(); });
    connect(m_turn, &QToolButton::clicked, this, [this] {
        setFrameSize(size().transposed());
        emit edited();
    });
    connect(m_named, &QComboBox::activated, this, [this] {
        const auto named = chosenValue<QSize>(m_named);
        if (!named.isValid()) return; // custom
        setFrameSize(named);
        emit edited();
    });
    setFrameSize({1920, 1080});
}

void FrameSizeEditor::addNamedSizes() {
    addChoice(m_named, tr("Full HD: 1920 × 1080"), QSize(1920, 1080));
    addChoice(m_named, tr("HD: 1280 × 720"), QSize(1280, 720));
    addChoice(m_named, tr("4K: 3840 × 2160"), QSize(3840, 2160));
    m_named->insertSeparator(m_named->count());
    addChoice(m_named, tr("Square: 1080 × 1080"), QSize(1080, 1080));
    addChoice(m_named, tr("Portrait: 1080 × 1920"), QSize(1080, 1920));
    addChoice(m_named, tr("For a message: 640 × 360"), QSize(640, 360));
    m_named->insertSeparator(m_named->count());
    addChoice(m_named, tr("Custom"), QSize());
}

QSize FrameSizeEditor::size() const {
    return {m_width->value(), m_height->value()};
}

void FrameSizeEditor::setFrameSize(const QSize& size) {
    m_locked = size;
    show(size);
}

void FrameSizeEditor::show(const QSize& size) {
    {
        const QSignalBlocker width(m_width), height(m_height);
        m_width->setValue(size.width());
        m_height->setValue(size.height());
    }
    if (!chooseValue(m_named, this->size())) chooseValue(m_named, QSize());
    emit changed();
}

void FrameSizeEditor::takeWidth(int width) {
    show({width,
          m_lock->isChecked() ? scaled(m_locked.height(), m_locked.width(), width) : m_height->value()});
    emit edited();
}

void FrameSizeEditor::takeHeight(int height) {
    show({m_lock->isChecked() ? scaled(m_locked.width(), m_locked.height(), height) : m_width->value(),
          height});
    emit edited();
}

} // namespace view
