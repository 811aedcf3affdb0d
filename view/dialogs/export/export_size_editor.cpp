// SPDX-License-Identifier: MIT
#include "dialogs/export/export_size_editor.h"

#include <QComboBox>
#include <QDoubleSpinBox>
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

constexpr int maxSide = 100'000;
enum Unit { Pixels, Millimetres, Inches };

// A comma is the decimal point here as in the other fields.
class LengthField : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;
    QValidator::State validate(QString& text, int& position) const override {
        return QDoubleSpinBox::validate(text.replace(u',', u'.'), position);
    }
};

QDoubleSpinBox* lengthField(const QString& name, QWidget* parent) {
    auto* field = new LengthField(parent);
    field->setLocale(QLocale::c());
    field->setRange(0.01, maxSide);
    field->setKeyboardTracking(false);
    field->setAccessibleName(name);
    field->setWhatsThis(ExportSizeEditor::tr(
        "A length in the selected unit. The other side follows as long as the proportions are kept."));
    return field;
}

int rounded(double pixels) {
    return std::clamp(int(std::lround(pixels)), 1, maxSide);
}

} // namespace

ExportSizeEditor::ExportSizeEditor(const QSize& screen, QWidget* parent)
    : QWidget(parent),
      m_screen(screen),
      m_pixels(screen),
      m_width(lengthField(tr("Width"), this)),
      m_height(lengthField(tr("Height"), this)),
      m_unit(new QComboBox(this)),
      m_scale(new QComboBox(this)),
      m_lock(new QToolButton(this)),
      m_resolution(new QSpinBox(this)) {
    m_unit->addItems({tr("pixels"), tr("mm"), tr("inches")});
    m_unit->setAccessibleName(tr("Unit of length"));
    m_unit->setWhatsThis(tr("Pixels, or a length on paper at the given resolution."));
    for (const int factor : {1, 2, 4, 8})
        m_scale->addItem(factor == 1 ? tr("Same as on the screen") : tr("%1 × the screen").arg(factor),
                         factor);
    m_scale->addItem(tr("Custom"), 0);
    m_scale->setAccessibleName(tr("Size relative to the screen"));
    m_scale->setWhatsThis(tr("The size of the picture on the screen, or a multiple of it."));
    m_lock->setText(tr("Lock proportions"));
    m_lock->setCheckable(true);
    m_lock->setChecked(true);
    m_lock->setToolTip(tr("Keep the proportions of the picture on the screen"));
    m_resolution->setRange(1, 9600);
    m_resolution->setValue(300);
    m_resolution->setSuffix(tr(" dpi"));
    m_resolution->setAccessibleName(tr("Resolution in dots per inch"));
    m_resolution->setWhatsThis(tr("The number of pixels per inch of paper: 300 is usual for print."));

    auto* lengths = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_width, new QLabel(QStringLiteral("×"), this),
                                                           m_height, m_unit, m_lock})
        lengths->addWidget(widget);
    lengths->addStretch();
    auto* scales = new QHBoxLayout;
    scales->addWidget(m_scale);
    scales->addWidget(m_resolution);
    scales->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addLayout(scales);
    layout->addLayout(lengths);

    connect(m_width, &QDoubleSpinBox::valueChanged, this, &ExportSizeEditor::takeWidth);
    connect(m_height, &QDoubleSpinBox::valueChanged, this, &ExportSizeEditor::takeHeight);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &ExportSizeEditor::showSize);
    connect(m_resolution, &QSpinBox::valueChanged, this, &ExportSizeEditor::showSize);
    connect(m_scale, &QComboBox::activated, this, [this] {
        if (const int factor = m_scale->currentData().toInt()) setPixels(m_screen * factor);
    });
    showSize();
}

double ExportSizeEditor::dotsPerInch() const {
    return m_resolution->value();
}

void ExportSizeEditor::setResolutionVisible(bool visible) {
    m_resolution->setVisible(visible);
}

void ExportSizeEditor::setPixels(const QSize& size) {
    m_pixels = {rounded(size.width()), rounded(size.height())};
    showSize();
    emit changed();
}

double ExportSizeEditor::unitInPixels() const {
    switch (m_unit->currentIndex()) {
    case Millimetres:
        return dotsPerInch() / 25.4;
    case Inches:
        return dotsPerInch();
    default:
        return 1;
    }
}

void ExportSizeEditor::showSize() {
    const QSignalBlocker width(m_width);
    const QSignalBlocker height(m_height);
    const int decimals = m_unit->currentIndex() == Pixels ? 0 : m_unit->currentIndex() == Millimetres ? 1 : 2;
    for (QDoubleSpinBox* field : {m_width, m_height})
        field->setDecimals(decimals);
    m_width->setValue(m_pixels.width() / unitInPixels());
    m_height->setValue(m_pixels.height() / unitInPixels());
    int scale = m_scale->count() - 1;
    for (int i = 0; i < m_scale->count() - 1; ++i)
        if (m_pixels == m_screen * m_scale->itemData(i).toInt()) scale = i;
    m_scale->setCurrentIndex(scale);
}

void ExportSizeEditor::takeWidth(double width) {
    const int pixels = rounded(width * unitInPixels());
    const int height = m_lock->isChecked() ? rounded(double(pixels) * m_screen.height() / m_screen.width())
                                           : m_pixels.height();
    setPixels({pixels, height});
}

void ExportSizeEditor::takeHeight(double height) {
    const int pixels = rounded(height * unitInPixels());
    const int width = m_lock->isChecked() ? rounded(double(pixels) * m_screen.width() / m_screen.height())
                                          : m_pixels.width();
    setPixels({width, pixels});
}

} // namespace view
