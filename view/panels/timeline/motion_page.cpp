// SPDX-License-Identifier: MIT
#include "panels/timeline/motion_page.h"

#include <QAction>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <chrono>

namespace view {

namespace {

constexpr QSize pictureSize(64, 48);
constexpr std::chrono::milliseconds nextPicture{80};
constexpr std::chrono::milliseconds restBeforeDrawing{150}; // delay, so that nothing is drawn during a drag

QToolButton* tile(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setPopupMode(action->property("isChoice").toBool() ? QToolButton::InstantPopup
                                                               : QToolButton::MenuButtonPopup);
    button->setIconSize(pictureSize);
    button->setAutoRaise(true);
    button->setAccessibleName(action->text().remove(u'&').remove(u'…'));
    button->setFocusPolicy(Qt::StrongFocus);
    button->setMinimumWidth(14 * button->fontMetrics().averageCharWidth());
    return button;
}

} // namespace

MotionPage::MotionPage(const QList<QAction*>& actions, QWidget* parent) : QWidget(parent) {
    auto* tiles = new QHBoxLayout;
    tiles->setSpacing(4);
    for (QAction* action : actions) {
        m_tiles.push_back({tile(action), {}});
        tiles->addWidget(m_tiles.back().button);
    }
    tiles->addStretch(1);
    auto* keys = new QPushButton(tr("Make Keys"));
    keys->setToolTip(tr("Make a first key, and show the tracks"));
    keys->setAutoDefault(false);
    auto* how = new QLabel(tr("Or set a key, move the playhead, and change the fractal."));
    auto* below = new QHBoxLayout; // left-aligned, to be visible in a narrow window
    below->addWidget(how);
    below->addWidget(keys);
    below->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->addWidget(new QLabel(tr("Nothing moves yet. Choose a motion:")));
    column->addLayout(tiles);
    column->addLayout(below);
    column->addStretch(1);
    connect(keys, &QPushButton::clicked, this, &MotionPage::tableWanted);
    m_soon.setSingleShot(true);
    m_soon.setInterval(restBeforeDrawing);
    connect(&m_soon, &QTimer::timeout, this, &MotionPage::draw);
    m_after.setSingleShot(true);
    m_after.setInterval(0);
    connect(&m_after, &QTimer::timeout, this, &MotionPage::drawNext);
    m_clock.setInterval(nextPicture);
    connect(&m_clock, &QTimer::timeout, this, &MotionPage::advance);
}

void MotionPage::renew() {
    if (isVisible()) m_soon.start();
}

void MotionPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    renew();
}

void MotionPage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_soon.stop();
    m_after.stop();
    m_clock.stop();
}

void MotionPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) renew();
}

void MotionPage::draw() {
    m_next = 0;
    m_preview.reset();
    drawNext();
    // Still pictures if the desktop asks for no animations.
    if (style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) > 0) m_clock.start();
}

void MotionPage::drawNext() {
    if (m_next >= std::min(m_tiles.size(), m_motions.size())) return;
    if (QGuiApplication::mouseButtons() != Qt::NoButton) return m_soon.start(); // postponed during a drag
    m_after.start();
    if (!m_preview) {
        const Make& make = m_motions[m_next];
        const PreviewStyle shown{pictureSize, devicePixelRatioF(), palette().color(QPalette::ButtonText)};
        if (auto entry = make ? make() : std::nullopt) m_preview.emplace(*std::move(entry), shown);
    }
    if (m_preview && m_preview->findNext()) return;
    Tile& tile = m_tiles[m_next++];
    tile.pictures = m_preview ? m_preview->pictures() : std::vector<QPixmap>();
    m_preview.reset();
    tile.button->setIcon(tile.pictures.empty() ? tile.button->defaultAction()->icon()
                                               : QIcon(tile.pictures[m_frame]));
}

void MotionPage::advance() {
    m_frame = (m_frame + 1) % std::size_t(previewFrames);
    for (const Tile& tile : m_tiles)
        if (!tile.pictures.empty()) tile.button->setIcon(tile.pictures[m_frame]);
}

} // namespace view
