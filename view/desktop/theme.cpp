// SPDX-License-Identifier: MIT
#include "desktop/theme.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOptionButton>
#include <QStyleOptionTab>
#include <QStyleOptionToolButton>
#include <QTabBar>
#include <QTableView>

#include <algorithm>
#include <utility>

namespace view {

namespace {

struct RoleColour {
    QPalette::ColorGroup group;
    QPalette::ColorRole role;
    QRgb light, dark;
};

constexpr RoleColour colours[] = {
    {QPalette::All, QPalette::Window, 0xffefefef, 0xff333337},
    {QPalette::All, QPalette::Base, 0xffffffff, 0xff1d1d20},
    {QPalette::All, QPalette::AlternateBase, 0xfff6f6f6, 0xff252528},
    {QPalette::All, QPalette::ToolTipBase, 0xffefefef, 0xff434348},
    {QPalette::All, QPalette::Button, 0xffefefef, 0xff434348},
    {QPalette::All, QPalette::Light, 0xffffffff, 0xff55555a},
    {QPalette::All, QPalette::Midlight, 0xffe4e4e4, 0xff424247},
    {QPalette::All, QPalette::Mid, 0xffb8b8b8, 0xff242427},
    {QPalette::All, QPalette::Dark, 0xff9f9f9f, 0xff19191b},
    {QPalette::All, QPalette::Shadow, 0xff767676, 0xff0e0e10},
    {QPalette::All, QPalette::WindowText, 0xff1c1c1c, 0xffe8e8e8},
    {QPalette::All, QPalette::Text, 0xff1c1c1c, 0xffe8e8e8},
    {QPalette::All, QPalette::ButtonText, 0xff1c1c1c, 0xffe8e8e8},
    {QPalette::All, QPalette::ToolTipText, 0xff1c1c1c, 0xffe8e8e8},
    {QPalette::All, QPalette::BrightText, 0xffffffff, 0xffffffff},
    {QPalette::All, QPalette::Highlight, 0xff2a6fb0, 0xff2f7ac2},
    {QPalette::All, QPalette::HighlightedText, 0xffffffff, 0xffffffff},
    {QPalette::All, QPalette::Link, 0xff1d5fa8, 0xff72b2f2},
    {QPalette::All, QPalette::LinkVisited, 0xff1d5fa8, 0xff72b2f2},
    {QPalette::Disabled, QPalette::WindowText, 0xff8c8c8c, 0xff808084},
    {QPalette::Disabled, QPalette::Text, 0xff8c8c8c, 0xff808084},
    {QPalette::Disabled, QPalette::ButtonText, 0xff8c8c8c, 0xff808084},
    {QPalette::Disabled, QPalette::HighlightedText, 0xff8c8c8c, 0xff808084},
    {QPalette::Disabled, QPalette::Highlight, 0xffb8b8b8, 0xff242427},
};

QPalette paletteOf(Preferences::Theme theme) {
    QPalette palette;
    for (const RoleColour& colour : colours)
        palette.setColor(colour.group, colour.role,
                         QColor::fromRgba(theme == Preferences::Theme::Dark ? colour.dark : colour.light));
    return palette;
}

const QString fusion = QStringLiteral("fusion");

// A cross, or a window in front of another, in the colour of text when it is drawn.
class TitleButtonEngine : public QIconEngine {
public:
    explicit TitleButtonEngine(bool closes) : m_closes(closes) {}
    QIconEngine* clone() const override { return new TitleButtonEngine(*this); }

    void paint(QPainter* painter, const QRect& area, QIcon::Mode, QIcon::State) override {
        const double side = std::min(area.width(), area.height()) * 0.6;
        QRectF box(0, 0, side, side);
        box.moveCenter(QRectF(area).center());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(QApplication::palette().color(QPalette::WindowText), std::max(1.2, side / 7)));
        painter->setBrush(Qt::NoBrush);
        if (m_closes) {
            painter->drawLine(box.topLeft(), box.bottomRight());
            painter->drawLine(box.topRight(), box.bottomLeft());
        } else {
            painter->drawRect(box.adjusted(0, side * 0.3, -side * 0.3, 0));
            painter->drawPolyline(QPolygonF{{box.left() + side * 0.3, box.top() + side * 0.3},
                                            {box.left() + side * 0.3, box.top()},
                                            box.topRight(),
                                            {box.right(), box.bottom() - side * 0.3},
                                            {box.right() - side * 0.3, box.bottom() - side * 0.3}});
        }
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap result(size);
        result.fill(Qt::transparent);
        QPainter painter(&result);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return result;
    }

private:
    bool m_closes;
};

// Fusion with clearer frames. Fusion draws those of check boxes and radio buttons a shade darker than the
// window, which is hardly visible in light themes and not at all in dark ones; the same holds for buttons
// that are on. Here they stand out at least by 3 to 1. Fusion's frame around the focus is hardly visible,
// either.
class ClearFusion : public QProxyStyle {
public:
    ClearFusion() : QProxyStyle(fusion) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        if ((element == PE_PanelButtonCommand || element == PE_PanelButtonTool) && option->state & State_On) {
            paintOn(*option, *painter);
            return;
        }
        // See drawControl().
        if (element == PE_FrameFocusRect && qobject_cast<const QTableView*>(widget)) return;
        if (element == PE_FrameFocusRect && isByKeys(*option, widget)) {
            paintFocus(*option, *painter);
            return;
        }
        const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
        if (!button || (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton)) {
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return;
        }
        QStyleOptionButton clear = *button;
        const QColor frame =
            mixed(clear.palette.color(QPalette::Window), clear.palette.color(QPalette::WindowText), 0.6);
        clear.palette.setColor(QPalette::Window, frame.lighter(fusionDarkens));
        QProxyStyle::drawPrimitive(element, &clear, painter, widget);
    }

    // Marks the edge of the selected tab with a bar, because its shade is not visible in dark themes.
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        QProxyStyle::drawControl(element, option, painter, widget);
        // Shows the cell that takes the keys of a row selected as a whole.
        if (element == CE_ItemViewItem && option->state & State_HasFocus &&
            qobject_cast<const QTableView*>(widget))
            paintFocus(*option, *painter, 2);
        // Shows the focus of a list or table, even without a current row.
        if (element == CE_ShapedFrame && qobject_cast<const QAbstractItemView*>(widget) &&
            option->state & State_HasFocus && isByKeys(*option, widget))
            paintFocus(*option, *painter);
        const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
        if (element == CE_TabBarTabShape && tab && tab->state & State_Selected) paintEdge(*tab, *painter);
        if (element == CE_TabBarTabLabel && tab && tab->state & State_HasFocus &&
            tab->state & State_KeyboardFocusChange) {
            QStyleOption inside = *tab; // same distance as Fusion's own mark, which is hardly visible
            inside.rect = tab->rect.adjusted(4, 4, -4, -4);
            inside.state &= ~State_Selected; // background without highlight
            paintFocus(inside, *painter);
        }
    }

    // Moves the arrow of a menu, which Fusion puts into the corner below the text.
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override {
        const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
        if (control != CC_ToolButton || !button || !hasArrowBeside(*button)) {
            QProxyStyle::drawComplexControl(control, option, painter, widget);
            // Paints over the groove, which hides some of Fusion's own frame.
            if (control == CC_Slider && option->state & State_HasFocus && isByKeys(*option, widget))
                paintFocus(*option, *painter);
            return;
        }
        QStyleOptionToolButton plain = *button;
        plain.features.setFlag(QStyleOptionToolButton::HasMenu, false);
        QProxyStyle::drawComplexControl(control, &plain, painter, widget);
        QStyleOption arrow = *button;
        arrow.rect = visualRect(button->direction, button->rect,
                                {button->rect.right() - arrowSide - arrowMargin + 1,
                                 button->rect.center().y() - arrowSide / 2 + 1, arrowSide, arrowSide});
        proxy()->drawPrimitive(PE_IndicatorArrowDown, &arrow, painter, widget);
    }

    // Adds room for the menu arrow, which touches the text in Fusion.
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override {
        constexpr int gap = 6;
        const QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
        const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
        if (const auto* tool = qstyleoption_cast<const QStyleOptionToolButton*>(option);
            type == CT_ToolButton && tool && hasArrowBeside(*tool))
            return size + QSize(arrowSide + arrowMargin + gap, 0);
        const bool hasMenu =
            type == CT_PushButton && button && button->features.testFlag(QStyleOptionButton::HasMenu);
        return hasMenu ? size + QSize(gap, 0) : size;
    }

    // Replaces Fusion's dark grey icons, which ignore the background.
    QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                       const QWidget* widget) const override {
        if (which == SP_TitleBarCloseButton || which == SP_TitleBarNormalButton)
            return QIcon(new TitleButtonEngine(which == SP_TitleBarCloseButton));
        return QProxyStyle::standardIcon(which, option, widget);
    }

    // Suppresses Fusion's ticks and crosses, which do not match our icons.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* result) const override {
        return hint == SH_DialogButtonBox_ButtonsHaveIcons
                   ? 0
                   : QProxyStyle::styleHint(hint, option, widget, result);
    }

private:
    static constexpr int arrowSide = 8, arrowMargin = 3;

    // Returns true if the menu arrow is beside the text.
    static bool hasArrowBeside(const QStyleOptionToolButton& button) {
        const bool isBeside = button.toolButtonStyle == Qt::ToolButtonTextBesideIcon ||
                              button.toolButtonStyle == Qt::ToolButtonTextOnly;
        return isBeside && !button.text.isEmpty() &&
               button.features.testFlag(QStyleOptionToolButton::HasMenu) &&
               !button.features.testFlag(QStyleOptionToolButton::MenuButtonPopup);
    }

    // Paints a checked button, which Fusion makes only a shade darker than an unchecked one. A thick frame
    // marks the keyboard focus.
    static void paintOn(const QStyleOption& option, QPainter& painter) {
        const QColor button = option.palette.color(QPalette::Button);
        const QColor highlight = option.palette.color(QPalette::Highlight);
        const bool pointedAt = option.state & State_MouseOver && option.state & State_Enabled;
        const bool hasFocus = option.state & State_HasFocus && option.state & State_KeyboardFocusChange;
        const QColor text = option.palette.color(QPalette::ButtonText);
        const double width = hasFocus ? 2 : 1;
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(hasFocus ? text : mixed(highlight, text, 0.5), width));
        painter.setBrush(mixed(button, highlight, pointedAt ? 0.45 : 0.35));
        const double inset = width / 2;
        painter.drawRoundedRect(QRectF(option.rect).adjusted(inset, inset, -inset, -inset), 2, 2);
        painter.restore();
    }

    // True for keyboard focus. Item views set the flag for every item with the focus.
    static bool isByKeys(const QStyleOption& option, const QWidget* widget) {
        return qobject_cast<const QAbstractItemView*>(widget)
                   ? widget->window()->testAttribute(Qt::WA_KeyboardFocusChange)
                   : bool(option.state & State_KeyboardFocusChange);
    }

    static void paintFocus(const QStyleOption& option, QPainter& painter, double width = 1) {
        const QColor colour = option.state & State_Selected
                                  ? option.palette.color(QPalette::HighlightedText) // on the highlight
                                  : mixed(option.palette.color(QPalette::Highlight),
                                          option.palette.color(QPalette::WindowText), 0.5);
        const double inset = width / 2;
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(colour, width));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(option.rect).adjusted(inset, inset, -inset, -inset), 2, 2);
        painter.restore();
    }

    // Paints the edge opposite to the page of the tab.
    static void paintEdge(const QStyleOptionTab& tab, QPainter& painter) {
        constexpr int width = 3;
        QRect edge = tab.rect.adjusted(1, 1, -1, -1);
        switch (tab.shape) {
        case QTabBar::RoundedEast:
        case QTabBar::TriangularEast:
            edge.setLeft(edge.right() - width + 1);
            break;
        case QTabBar::RoundedWest:
        case QTabBar::TriangularWest:
            edge.setRight(edge.left() + width - 1);
            break;
        case QTabBar::RoundedSouth:
        case QTabBar::TriangularSouth:
            edge.setTop(edge.bottom() - width + 1);
            break;
        default:
            edge.setBottom(edge.top() + width - 1);
        }
        painter.fillRect(edge, mixed(tab.palette.color(QPalette::Highlight),
                                     tab.palette.color(QPalette::WindowText), 0.3F));
    }

    static constexpr int fusionDarkens = 127; // per cent, from the window's colour to the frame's

    static QColor mixed(const QColor& from, const QColor& to, float share) {
        const auto mix = [share](float a, float b) { return a + share * (b - a); };
        return QColor::fromRgbF(mix(from.redF(), to.redF()), mix(from.greenF(), to.greenF()),
                                mix(from.blueF(), to.blueF()));
    }
};

} // namespace

void completePalette() {
    QPalette palette = QApplication::palette();
    QColor quiet = palette.color(QPalette::Active, QPalette::Text);
    quiet.setAlpha(150);
    if (palette.color(QPalette::Active, QPalette::PlaceholderText) == quiet) return;
    palette.setColor(QPalette::PlaceholderText, quiet);
    QApplication::setPalette(palette);
}

void applyTheme(Preferences::Theme theme) {
    static const QString desktopStyle = QApplication::style()->name();
    static QString applied;
    const bool own = theme != Preferences::Theme::Desktop;
    // Fusion is the only style of the toolkit that takes every colour from the palette.
    if (const QString style = own ? fusion : desktopStyle; style != std::exchange(applied, style)) {
        if (style.compare(fusion, Qt::CaseInsensitive) == 0)
            QApplication::setStyle(new ClearFusion);
        else
            QApplication::setStyle(style);
    }
    QApplication::setPalette(own ? paletteOf(theme) : QPalette());
    completePalette();
}

} // namespace view
