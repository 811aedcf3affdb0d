// SPDX-License-Identifier: MIT
#include "panels/collage/suggestion_list.h"

#include "document/edits/cage/cage_edits.h"
#include "widgets/layout/vertical_scroll_area.h"
#include "widgets/numbers/number_text.h"

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr int side = 72; // pixels of a picture
constexpr quint64 perSheet = 64;

QString textOf(const collage::Suggestion& one) {
    QString text = SuggestionList::tr("%n maps", nullptr, int(one.maps.size()));
    text += u'\n' + SuggestionList::tr("Mean distance %1 px").arg(roundedNumber(one.attractor.mean, 2));
    text += u'\n' + SuggestionList::tr("Overlap %1 %").arg(roundedNumber(100 * one.attractor.iou, 1));
    if (one.collage.bound)
        text +=
            u'\n' + SuggestionList::tr("Guaranteed within %1 px").arg(roundedNumber(*one.collage.bound, 1));
    return text;
}

} // namespace

SuggestionList::SuggestionList(QWidget* parent) : QListWidget(parent), m_thumbnails(new Thumbnails(this)) {
    setAccessibleName(tr("Suggestions"));
    setToolTip(tr("Click a suggestion to use it; undo goes back"));
    setIconSize({side, side});
    setVerticalScrollMode(ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_thumbnails->setSize(side, devicePixelRatioF());
    connect(m_thumbnails, &Thumbnails::ready, this, [this](quint64 key) {
        if (key / perSheet == m_sheet) showPicture(int(key % perSheet));
    });
    connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { emit chosen(row(item)); });
    connect(this, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { emit chosen(row(item)); });
    hide();
}

QSize SuggestionList::sizeHint() const {
    return {2 * side, 3 * (side + 8)};
}

void SuggestionList::show(const std::vector<collage::Suggestion>& suggestions,
                          std::vector<std::shared_ptr<const document::Fractal>> fractals) {
    forget();
    m_fractals = std::move(fractals);
    for (const collage::Suggestion& one : suggestions) {
        auto* item = new QListWidgetItem(textOf(one), this);
        item->setSizeHint({side, side + 8});
        showPicture(count() - 1);
    }
    setVisible(count() > 0);
    if (count() > 0) scrollIntoView(this);
}

void SuggestionList::highlight(const document::Fractal& current) {
    const auto used = std::ranges::find_if(m_fractals, [&](const auto& one) {
        return document::isSameSystem(*one, current) && document::isCageAlike(*one, current);
    });
    if (used != m_fractals.end()) return setCurrentRow(int(used - m_fractals.begin()));
    setCurrentItem(nullptr);
    clearSelection();
}

void SuggestionList::forget() {
    ++m_sheet;
    clear();
    m_fractals.clear();
    hide();
}

void SuggestionList::showPicture(int row) {
    if (row >= count() || row >= int(m_fractals.size())) return;
    const quint64 key = m_sheet * perSheet + quint64(row);
    const QPixmap pixmap = m_thumbnails->thumbnail(key, m_fractals[std::size_t(row)]).pixmap;
    if (!pixmap.isNull()) item(row)->setIcon(pixmap);
}

} // namespace view
