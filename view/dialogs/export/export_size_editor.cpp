// SPDX-License-Identifier: MIT
#include "dialogs/export/export_size_editor.h"

#include "widgets/choices.h"
#include "widgets/icon.h"
#include "widgets/numbers/number_box.h"

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
#include <iterator>

namespace view {

namespace {

constexpr int maxSide = 100'000;
constexpr int printed = 300;              // dots per inch
constexpr int multiples[] = {1, 2, 4, 8}; // multiples of the size on the screen
using Unit = ExportSizeEditor::Unit;
enum Role { Size = Qt::UserRole, IsPaper, Multiple }; // data of a named size

QDoubleSpinBox* lengthField(const QString& name, QWidget* parent) {
    auto* field = new NumberBox(parent);
    field->setRange(0.01, maxSide);
    field->setKeyboardTracking(false);
    field->setAccessibleName(name);
    field->setWhatsThis(ExportSizeEditor::tr(
        "A length in the selected unit. The other side follows as long as the proportions are locked."));
    return field;
}

QComboBox* unitBox(QWidget* parent) {
    auto* box = new QComboBox(parent);
    addChoice(box, ExportSizeEditor::tr("pixels"), Unit::Pixels);
    addChoice(box, ExportSizeEditor::tr("mm"), Unit::Millimetres);
    addChoice(box, ExportSizeEditor::tr("inches"), Unit::Inches);
    box->setAccessibleName(ExportSizeEditor::tr("Unit of length"));
    box->setWhatsThis(ExportSizeEditor::tr("Pixels, or a length on paper at the given resolution."));
    return box;
}

QToolButton* lockButton(QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(icon(QStringLiteral("lock"))); // a text would widen the dialogs beyond small screens
    button->setAccessibleName(ExportSizeEditor::tr("Lock proportions"));
    button->setCheckable(true);
    button->setChecked(true);
    button->setToolTip(ExportSizeEditor::tr("Keep the proportions of the picture"));
    return button;
}

QToolButton* turnButton(QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(icon(QStringLiteral("turn")));
    button->setAccessibleName(ExportSizeEditor::tr("Portrait or landscape"));
    button->setToolTip(ExportSizeEditor::tr("Swap width and height"));
    return button;
}

int rounded(double pixels) {
    return std::clamp(int(std::lround(pixels)), 1, maxSide);
}

} // namespace

ExportSizeEditor::ExportSizeEditor(const QSize& screen, QWidget* parent)
    : QWidget(parent),
      m_screen(screen),
      m_pixels(screen),
      m_locked(screen),
      m_width(lengthField(tr("Width"), this)),
      m_height(lengthField(tr("Height"), this)),
      m_unit(unitBox(this)),
      m_named(new QComboBox(this)),
      m_lock(lockButton(this)),
      m_turn(turnButton(this)),
      m_resolution(new WholeNumberBox(this)) {
    setWhatsThis(tr("The size of the picture, in pixels or on paper."));
    addNamedSizes();
    m_named->setAccessibleName(tr("Named size"));
    m_named->setWhatsThis(tr("The size of the picture on the screen or a multiple of it, of a common screen, "
                             "or of a sheet of paper. Everything that the window shows stays in the picture; "
                             "if the proportions differ, the picture shows more around it."));
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
    scales->addWidget(m_named);
    scales->addWidget(m_turn);
    scales->addWidget(m_resolution);
    scales->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addLayout(scales);
    layout->addLayout(lengths);

    QWidget* before = m_named;
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_turn, m_resolution, m_width, m_height, m_unit, m_lock}) {
        setTabOrder(before, widget);
        before = widget;
    }

    connect(m_width, &QDoubleSpinBox::valueChanged, this, &ExportSizeEditor::takeWidth);
    connect(m_height, &QDoubleSpinBox::valueChanged, this, &ExportSizeEditor::takeHeight);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &ExportSizeEditor::showSize);
    connect(m_resolution, &QSpinBox::valueChanged, this, &ExportSizeEditor::showSize);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &ExportSizeEditor::changed);
    connect(m_resolution, &QSpinBox::valueChanged, this, &ExportSizeEditor::changed);
    connect(m_named, &QComboBox::activated, this, &ExportSizeEditor::takeNamedSize);
    connect(m_turn, &QToolButton::clicked, this, &ExportSizeEditor::turn);
    showSize();
}

// Sheets lie or stand as the picture on the screen does.
void ExportSizeEditor::addNamedSizes() {
    const auto add = [this](const QString& name, const QSize& size, bool isPaper = false) {
        addChoice(m_named, name, size);
        m_named->setItemData(m_named->count() - 1, isPaper, IsPaper);
    };
    for (const int factor : multiples) {
        add(factor == 1 ? tr("Same as on the screen") : tr("%1 × the screen").arg(factor), m_screen * factor);
        m_named->setItemData(m_named->count() - 1, factor, Multiple);
    }
    m_named->insertSeparator(m_named->count());
    add(tr("Full HD: 1920 × 1080"), {1920, 1080});
    add(tr("4K: 3840 × 2160"), {3840, 2160});
    add(tr("8K: 7680 × 4320"), {7680, 4320});
    add(tr("Square: 2048 × 2048"), {2048, 2048});
    m_named->insertSeparator(m_named->count());
    const auto sheet = [this](double longer, double shorter) {
        const QSize lying(rounded(longer * printed / 25.4), rounded(shorter * printed / 25.4));
        return m_screen.width() < m_screen.height() ? lying.transposed() : lying;
    };
    add(tr("A4 at 300 dpi"), sheet(297, 210), true);
    add(tr("A3 at 300 dpi"), sheet(420, 297), true);
    m_named->insertSeparator(m_named->count());
    addChoice(m_named, tr("Custom"), QSize());
}

void ExportSizeEditor::turn() {
    m_locked = m_locked.transposed();
    setPixels(m_pixels.transposed());
}

void ExportSizeEditor::takeNamedSize() {
    const QSize size = m_named->currentData(Size).toSize();
    if (!size.isValid()) return; // custom
    const bool isPaper = m_named->currentData(IsPaper).toBool();
    if (isPaper) m_resolution->setValue(printed);
    if (isPaper && !isOnPaper()) chooseValue(m_unit, Unit::Millimetres);
    if (!isPaper) chooseValue(m_unit, Unit::Pixels);
    m_locked = size;
    setPixels(size);
}

double ExportSizeEditor::dotsPerInch() const {
    return m_resolution->value();
}

bool ExportSizeEditor::isOnPaper() const {
    return chosenValue<Unit>(m_unit) != Unit::Pixels;
}

QString ExportSizeEditor::choice() const {
    const int multiple = m_named->currentData(Multiple).toInt(); // 0: independent of the screen
    QStringList numbers;
    for (const int number : {multiple, m_pixels.width(), m_pixels.height(), int(chosenValue<Unit>(m_unit)),
                             m_resolution->value()})
        numbers << QString::number(number);
    return numbers.join(u' ');
}

void ExportSizeEditor::choose(const QString& choice) {
    QList<int> numbers;
    for (const QString& text : choice.split(u' ', Qt::SkipEmptyParts))
        numbers << text.toInt();
    if (numbers.size() != 5 || numbers[1] < 1 || numbers[2] < 1) return;
    const bool isByScreen = std::ranges::find(multiples, numbers[0]) != std::end(multiples);
    const QSize size = isByScreen ? m_screen * numbers[0] : QSize(numbers[1], numbers[2]);
    m_resolution->setValue(numbers[4]);
    chooseValue(m_unit, std::clamp(Unit(numbers[3]), Unit::Pixels, Unit::Inches));
    m_locked = size;
    setPixels(size);
}

void ExportSizeEditor::chooseLargestSheet() {
    int largest = -1;
    const auto area = [this](int row) {
        const QSize size = m_named->itemData(row, Size).toSize();
        return size.width() * size.height();
    };
    for (int row = 0; row < m_named->count(); ++row)
        if (m_named->itemData(row, IsPaper).toBool() && (largest < 0 || area(row) > area(largest)))
            largest = row;
    m_named->setCurrentIndex(largest);
    takeNamedSize();
}

void ExportSizeEditor::chooseMillimetres() {
    chooseValue(m_unit, Unit::Millimetres);
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
    switch (chosenValue<Unit>(m_unit)) {
    case Unit::Pixels:
        break;
    case Unit::Millimetres:
        return dotsPerInch() / 25.4;
    case Unit::Inches:
        return dotsPerInch();
    }
    return 1;
}

void ExportSizeEditor::showSize() {
    const QSignalBlocker width(m_width);
    const QSignalBlocker height(m_height);
    const auto unit = chosenValue<Unit>(m_unit);
    const int decimals = unit == Unit::Pixels ? 0 : unit == Unit::Millimetres ? 1 : 2;
    for (QDoubleSpinBox* field : {m_width, m_height})
        field->setDecimals(decimals);
    m_width->setValue(m_pixels.width() / unitInPixels());
    m_height->setValue(m_pixels.height() / unitInPixels());
    if (chooseValue(m_named, m_pixels)) return;
    // True for a sheet chosen for a screen of the other orientation.
    const bool isTurnedSheet =
        chooseValue(m_named, m_pixels.transposed()) && m_named->currentData(IsPaper).toBool();
    if (!isTurnedSheet) chooseValue(m_named, QSize());
}

QSize ExportSizeEditor::inShape(double factor) const {
    const double most = double(maxSide) / std::max(m_locked.width(), m_locked.height());
    const double within = std::min(factor, most);
    return {rounded(within * m_locked.width()), rounded(within * m_locked.height())};
}

void ExportSizeEditor::takeWidth(double width) {
    const int pixels = rounded(width * unitInPixels());
    setPixels(m_lock->isChecked() ? inShape(double(pixels) / m_locked.width())
                                  : QSize(pixels, m_pixels.height()));
}

void ExportSizeEditor::takeHeight(double height) {
    const int pixels = rounded(height * unitInPixels());
    setPixels(m_lock->isChecked() ? inShape(double(pixels) / m_locked.height())
                                  : QSize(m_pixels.width(), pixels));
}

} // namespace view
