// SPDX-License-Identifier: MIT
#include "panels/appearance/palettes/palette_browser.h"

#include "attractor/colour/palette_edits.h"
#include "desktop/settings.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "panels/appearance/palettes/gradient_preview.h"
#include "panels/appearance/palettes/palette_filter.h"
#include "panels/appearance/palettes/palette_titles.h"
#include "widgets/flat_buttons.h"
#include "widgets/numbers/number_field.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QStandardItemModel>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

namespace view {

namespace {

constexpr QSize previewSize(152, 22);
constexpr int above = 6; // free pixels above a preview
constexpr int columns = 3;
constexpr int rows = 7; // rows visible at first
constexpr int previewHeight = 28;
const QString favouritesKey = QStringLiteral("palettes/favourites");

// The same colours when it is selected.
QIcon previewOf(const attractor::Palette& palette) {
    QIcon icon;
    for (const qreal ratio : {1.0, 2.0}) {
        QPixmap tile((previewSize + QSize(0, above)) * ratio);
        tile.setDevicePixelRatio(ratio);
        tile.fill(Qt::transparent);
        QPainter(&tile).drawPixmap(0, above, gradientPixmap(palette, previewSize, ratio));
        for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected})
            icon.addPixmap(tile, mode);
    }
    return icon;
}

} // namespace

PaletteBrowser::PaletteBrowser(const attractor::Palette& present, QWidget* parent)
    : QDialog(parent), m_present(present), m_favourites(stored(favouritesKey).toStringList()) {
    setWindowTitle(tr("Palettes"));
    setWhatsThis(tr("All palettes: search them, mark favourites, and adjust the one that is selected."));
    m_model = new QStandardItemModel(this);
    m_filtered = new PaletteFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(8);
    layout->addLayout(createSearchRow());
    createList();
    layout->addWidget(m_list, 1);
    layout->addLayout(createAdjustments());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_use = buttons->addButton(tr("&Use This Palette"), QDialogButtonBox::AcceptRole);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill();
    choose();
    m_search->setFocus();
}

QLayout* PaletteBrowser::createSearchRow() {
    m_search = new QLineEdit(this);
    m_search->setPlaceholderText(tr("Search palettes"));
    m_search->setAccessibleName(tr("Search palettes"));
    m_search->setClearButtonEnabled(true);
    m_onlyFavourites = new QCheckBox(tr("&Favourites Only"), this);
    m_onlyFavourites->setWhatsThis(tr("Shows only the palettes that you marked with the star."));
    auto* row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_search, 1);
    row->addWidget(m_onlyFavourites);
    connect(m_search, &QLineEdit::textChanged, m_filtered, &PaletteFilter::setWords);
    connect(m_search, &QLineEdit::textChanged, this, &PaletteBrowser::chooseFound);
    connect(m_onlyFavourites, &QCheckBox::toggled, m_filtered, &PaletteFilter::setOnlyFavourites);
    connect(m_onlyFavourites, &QCheckBox::toggled, this, &PaletteBrowser::chooseFound);
    return row;
}

void PaletteBrowser::createList() {
    m_list = new QListView(this);
    m_list->setAccessibleName(tr("Palettes"));
    m_list->setWhatsThis(tr("Palettes made in Oklab, whose steps look equally large. Select one to see it on "
                            "the fractal; double-click it to keep it."));
    m_filtered->setSourceModel(m_model);
    m_list->setModel(m_filtered);
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setUniformItemSizes(true);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setIconSize(previewSize + QSize(0, above));
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setTextElideMode(Qt::ElideRight);
    const QSize cell(previewSize.width() + 16, previewSize.height() + above + fontMetrics().height() + 12);
    m_list->setGridSize(cell);
    const int scrollBar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, m_list);
    m_list->setMinimumSize(2 * cell.width() + 2 * m_list->frameWidth() + scrollBar + 4, 3 * cell.height());
    resize(columns * cell.width() + 2 * m_list->frameWidth() + scrollBar + 30, rows * cell.height() + 200);
    m_whyEmpty = new QLabel(m_list->viewport());
    m_whyEmpty->setAlignment(Qt::AlignCenter);
    m_whyEmpty->setWordWrap(true);
    m_whyEmpty->setEnabled(false); // same look as a placeholder
    m_whyEmpty->hide();
    auto* cover = new QVBoxLayout(m_list->viewport());
    cover->addWidget(m_whyEmpty);
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PaletteBrowser::choose);
    connect(m_list, &QListView::doubleClicked, this, &QDialog::accept);
}

QLayout* PaletteBrowser::createAdjustments() {
    m_preview = new QLabel(this);
    m_preview->setFixedHeight(previewHeight);
    m_preview->setMinimumWidth(1);
    m_preview->setAccessibleName(tr("The palette as it will be used"));
    m_favourite = flatButton(QStringLiteral("favourite"), tr("Favourite"),
                             tr("Mark the selected palette as a favourite (Ctrl+D)"), this);
    m_favourite->setCheckable(true);
    connect(m_favourite, &QToolButton::clicked, this, &PaletteBrowser::setFavourite);
    auto* shortcut = new QShortcut(Qt::CTRL | Qt::Key_D, this);
    connect(shortcut, &QShortcut::activated, m_favourite, &QToolButton::click);
    createSlider(m_hue, tr("Hue"), -180, 180);
    m_hue.slider->field()->setDegrees();
    m_hue.slider->setToolTip(tr("Rotate all hues by this many degrees; the lightness stays the same"));
    createSlider(m_shift, tr("Shift"), 0, 1);
    m_shift.slider->setToolTip(tr("Start farther along the palette; the part before moves to the end"));
    m_reversed = new QCheckBox(tr("&Reversed"), this);
    connect(m_reversed, &QCheckBox::toggled, this, &PaletteBrowser::adjust);
    auto* shown = new QHBoxLayout;
    shown->setSpacing(6);
    shown->addWidget(m_preview, 1);
    shown->addWidget(m_favourite);
    auto* form = new QFormLayout;
    form->setVerticalSpacing(8);
    form->setHorizontalSpacing(16);
    form->addRow(shown);
    form->addRow(m_hue.slider->field()->accessibleName(), m_hue.slider);
    form->addRow(m_shift.slider->field()->accessibleName(), m_shift.slider);
    form->addRow(QString(), m_reversed);
    return form;
}

void PaletteBrowser::createSlider(Adjustment& adjustment, const QString& name, double min, double max) {
    auto* slider = new AppearanceSlider(name, min, max, AppearanceSlider::Scale::Linear, this);
    adjustment.slider = slider;
    const auto set = [this, &adjustment, slider](double value) {
        adjustment.value = value;
        slider->setValue(value);
        adjust();
    };
    slider->setRange(min, max);
    slider->setValue(0);
    connect(slider, &AppearanceSlider::tried, this, set);
    connect(slider, &AppearanceSlider::accepted, this, [&adjustment] { adjustment.kept = adjustment.value; });
    connect(slider, &AppearanceSlider::rejected, this, [&adjustment, set] { set(adjustment.kept); });
}

void PaletteBrowser::fill() {
    int present = -1;
    for (const TitledPalette& titled : titledPalettes()) {
        auto* item = new QStandardItem(previewOf(titled.palette), titled.title);
        item->setData(QString::fromStdString(titled.palette.name), PaletteFilter::nameRole);
        m_model->appendRow(item);
        if (titled.palette == m_present) present = int(m_palettes.size());
        m_palettes.push_back(titled.palette);
        showFavourite(int(m_palettes.size()) - 1);
    }
    if (present < 0) return;
    const QModelIndex index = m_filtered->mapFromSource(m_model->index(present, 0));
    m_list->setCurrentIndex(index);
    m_list->scrollTo(index, QAbstractItemView::PositionAtCenter);
}

// A favourite is marked before its title.
void PaletteBrowser::showFavourite(int row) {
    QStandardItem* item = m_model->item(row);
    const bool is = m_favourites.contains(item->data(PaletteFilter::nameRole).toString());
    const QString star = QStringLiteral("★ ");
    QString text = item->text();
    if (text.startsWith(star)) text.remove(0, star.size());
    item->setData(is, PaletteFilter::favouriteRole);
    item->setText(is ? star + text : text);
    item->setData(is ? tr("%1, a favourite").arg(text) : text, Qt::AccessibleTextRole);
}

void PaletteBrowser::setFavourite(bool isFavourite) {
    const int row = chosen();
    if (row < 0) return;
    const QString name = m_model->item(row)->data(PaletteFilter::nameRole).toString();
    m_favourites.removeAll(name);
    if (isFavourite) m_favourites << name;
    store(favouritesKey, m_favourites);
    showFavourite(row);
    chooseFound();
}

// Keeps a match selected while the list is searched, so that Enter uses it.
void PaletteBrowser::chooseFound() {
    m_whyEmpty->setVisible(m_filtered->rowCount() == 0);
    m_whyEmpty->setText(m_search->text().isEmpty()
                            ? tr("No favourites yet. Select a palette and press Ctrl+D.")
                            : tr("No matches"));
    const bool isNarrowed = !m_search->text().isEmpty() || m_onlyFavourites->isChecked();
    if (isNarrowed && chosen() < 0 && m_filtered->rowCount() > 0)
        m_list->setCurrentIndex(m_filtered->index(0, 0));
    else if (chosen() >= 0)
        m_list->scrollTo(m_list->currentIndex());
}

int PaletteBrowser::chosen() const {
    const QModelIndexList selected = m_list->selectionModel()->selectedIndexes();
    return selected.isEmpty() ? -1 : m_filtered->mapToSource(selected.front()).row();
}

bool PaletteBrowser::hasChosen() const {
    return chosen() >= 0;
}

QString PaletteBrowser::title() const {
    const int row = chosen();
    return row < 0 ? paletteTitle(m_present) : paletteTitle(m_palettes[std::size_t(row)]);
}

void PaletteBrowser::choose() {
    const int row = chosen();
    m_favourite->setEnabled(row >= 0);
    m_favourite->setChecked(row >= 0 && m_model->item(row)->data(PaletteFilter::favouriteRole).toBool());
    adjust();
}

void PaletteBrowser::adjust() {
    paintPreview();
    m_use->setEnabled(!(palette() == m_present));
    emit tried();
}

attractor::Palette PaletteBrowser::palette() const {
    const int row = chosen();
    attractor::Palette made = row < 0 ? m_present : m_palettes[std::size_t(row)];
    if (m_reversed->isChecked()) attractor::reverse(made);
    attractor::shift(made, m_shift.value);
    attractor::turnHue(made, m_hue.value);
    return made;
}

void PaletteBrowser::paintPreview() {
    m_preview->setPixmap(gradientPixmap(palette(), m_preview->size(), devicePixelRatioF()));
}

void PaletteBrowser::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    layout()->activate();
    paintPreview();
}

} // namespace view
