// SPDX-License-Identifier: MIT
#include "dialogs/export/export_data_dialog.h"

#include "dialogs/column_orders.h"
#include "document/edits/cage/cage_edits.h"
#include "document/text/text.h"
#include "io/file/background.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_box.h"
#include "widgets/text/text_edit_workarounds.h"
#include "widgets/text/tooltip_text.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardItemModel>

#include <algorithm>
#include <chrono>

namespace view {

namespace {

using DataFormat = ExportDataDialog::Format;

const io::TextFormat* textIn(const DataFormat& format) {
    return std::get_if<io::TextFormat>(&format);
}

// The name of a format in the settings.
QString dataNameOf(const DataFormat& format) {
    if (const auto* text = textIn(format)) return io::suffixOf(*text);
    return format == DataFormat(io::PointFormat::Ply) ? QStringLiteral("points-ply")
                                                      : QStringLiteral("points-csv");
}

DataFormat dataFormatOf(const QString& name) {
    for (const io::PointFormat points : {io::PointFormat::Csv, io::PointFormat::Ply})
        if (name == dataNameOf(points)) return points;
    return io::textFormat(name).value_or(io::TextFormat::Flame);
}

std::shared_ptr<const document::Fractal> bakedOf(const document::Fractal& fractal) {
    const ifs::ControlCage<2>* cage = document::cage2(fractal);
    const bool isAffine = document::space(fractal) || (cage && cage->rest.size() == 3);
    if (!isAffine) return {};
    auto baked = document::baked(fractal);
    return baked ? std::make_shared<const document::Fractal>(*std::move(baked)) : nullptr;
}

} // namespace

ExportDataDialog::ExportDataDialog(document::Document* document, QWidget* parent)
    : ExportShell(QStringLiteral("data"), document->fractal().name, parent),
      m_fractal(document->fractal()),
      m_baked(bakedOf(m_fractal)) {
    setWindowTitle(tr("Export Data of “%1”").arg(titleText(m_fractal.name)));
    m_form = new QFormLayout;
    createOptions(m_form);
    m_preview = new TextEditWithWorkarounds<QPlainTextEdit>(this);
    m_preview->setReadOnly(true);
    m_preview->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_preview->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_preview->setAccessibleName(tr("Preview of the file"));
    m_preview->setWhatsThis(tr("The beginning of the file as it will be written."));
    lay(m_form, m_preview, Qt::Vertical);
    setStartHelp(tr("Asks for a file name and writes the file."));
    m_copy =
        addButton(tr("Copy &Text"), tr("Copies the whole text to the clipboard instead of writing a file."));
    connect(m_copy, &QPushButton::clicked, this, &ExportDataDialog::copy);
    connect(&m_previewed, &QFutureWatcherBase::finished, this, &ExportDataDialog::showPreview);
    resize(fontMetrics().averageCharWidth() * 90, fontMetrics().lineSpacing() * 26);
    update();
}

ExportDataDialog::~ExportDataDialog() = default;

void ExportDataDialog::createOptions(QFormLayout* form) {
    m_format = new QComboBox(this);
    m_format->setWhatsThis(
        tr("The program that will read the data; each format contains what that program understands."));
    for (const io::TextFormat text : io::textFormats)
        if (io::titleOf(text)) addChoice(m_format, Text::tr(io::titleOf(text)), Format(text));
    addChoice(m_format, tr("Points (.csv)"), Format(io::PointFormat::Csv));
    addChoice(m_format, tr("Points, coloured (.ply)"), Format(io::PointFormat::Ply));
    chooseFormat(dataFormatOf(last().format));
    m_columns = new ColumnOrders(tr("The order of the coefficients in each row; programs differ."), this);
    m_points = new WholeNumberBox(this);
    m_points->setWhatsThis(tr("How many points of the chaos game are written."));
    m_points->setRange(1, int(io::PointCloud::maxPoints));
    m_points->setValue(100'000);
    m_points->setSingleStep(100'000);
    m_points->setGroupSeparatorShown(true);
    m_turnY = new QCheckBox(tr("Flip &y so that the flame is the right way up"), this);
    m_turnY->setWhatsThis(tr("In flame programs, y points down. With this option, the flame looks as it does "
                             "here; without it, the numbers stay the same."));
    m_turnY->setChecked(true);
    m_bake = new QCheckBox(tr("&Bake the placement so that the maps draw the picture as shown"), this);
    m_bake->setWhatsThis(tr("With this option, the cage becomes part of the maps. Without it, the maps are "
                            "written as they are in the table."));
    m_bake->setChecked(true);
    form->addRow(tr("&Format:"), m_format);
    form->addRow(tr("C&olumns:"), m_columns);
    form->addRow(tr("&Points:"), m_points);
    form->addRow(QString(), m_turnY);
    form->addRow(QString(), m_bake);
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDataDialog::update);
    connect(m_columns, &ColumnOrders::changed, this, &ExportDataDialog::update);
    connect(m_turnY, &QCheckBox::toggled, this, &ExportDataDialog::update);
    connect(m_bake, &QCheckBox::toggled, this, &ExportDataDialog::update);
}

// Chooses this format or, if it cannot store the system, the first that can; the others of its kind are grey.
void ExportDataDialog::chooseFormat(const Format& remembered) {
    const auto holds = [this](const Format& format) {
        const auto* text = textIn(format);
        return !text || io::holds(*text, m_fractal);
    };
    auto* items = qobject_cast<QStandardItemModel*>(m_format->model());
    std::optional<Format> first;
    for (int row = 0; row < m_format->count(); ++row) {
        const auto format = m_format->itemData(row).value<Format>();
        items->item(row)->setEnabled(holds(format));
        if (!first && holds(format)) first = format;
    }
    chooseValue(m_format, holds(remembered) ? remembered : *first); // points are always possible
}

ExportDataDialog::Format ExportDataDialog::format() const {
    return chosenValue<Format>(m_format);
}

std::optional<io::TextFormat> ExportDataDialog::textFormat() const {
    const Format chosen = format();
    return textIn(chosen) ? std::optional(*textIn(chosen)) : std::nullopt;
}

io::PointFormat ExportDataDialog::pointFormat() const {
    return std::get<io::PointFormat>(format());
}

QString ExportDataDialog::suffix() const {
    if (const auto format = textFormat()) return io::suffixOf(*format);
    return pointFormat() == io::PointFormat::Ply ? QStringLiteral("ply") : QStringLiteral("csv");
}

std::shared_ptr<const document::Fractal> ExportDataDialog::fractalToExport() const {
    return m_baked && m_bake->isChecked() ? m_baked : std::make_shared<const document::Fractal>(m_fractal);
}

std::function<QByteArray()> ExportDataDialog::textMaker() const {
    io::TextOptions options;
    options.axis = m_turnY->isChecked() ? io::FlameAxis::Flipped : io::FlameAxis::AsWritten;
    options.columns = m_columns->columns();
    return [fractal = fractalToExport(), format = *textFormat(), options] {
        return io::textOf({fractal}, format, options);
    };
}

// The parts that the chosen format has no place for, as a sentence; empty when nothing is lost.
QString ExportDataDialog::loss() const {
    const auto format = textFormat();
    if (!format) return {};
    document::Fractal written = *fractalToExport();
    if (auto* shape = document::plane(written); shape && m_baked && m_bake->isChecked())
        shape->cage.reset(); // no longer needed
    if (auto* shape = document::space(written); shape && m_baked && m_bake->isChecked()) shape->cage.reset();
    return io::lossOf(*format, written).value_or(QString());
}

void ExportDataDialog::update() {
    const auto format = textFormat();
    const bool isTable = format && io::holdsOneSystem(*format);
    const bool isPlane = document::system2(m_fractal) != nullptr;
    m_form->setRowVisible(m_columns, isTable && isPlane);
    m_form->setRowVisible(m_points, !format);
    m_form->setRowVisible(m_turnY, format == io::TextFormat::Flame);
    m_form->setRowVisible(m_bake, format && m_baked);
    m_copy->setVisible(format.has_value());
    m_preview->setVisible(format.has_value());
    const bool isHeld = format ? io::holds(*format, m_fractal) : document::dimension(m_fractal) != 0;
    const QString obstacle = !isHeld              ? tr("This format can store only systems in the plane.")
                             : isTable && isPlane ? m_columns->obstacle()
                                                  : QString();
    m_isPossible = obstacle.isEmpty();
    enableButtons();
    m_copy->setEnabled(m_isPossible);
    say(!m_isPossible ? obstacle
        : !format     ? tr("The points of the chaos game as shown, without the first 14.")
                      : loss());
    if (format && m_isPossible) startPreview();
}

// Previews in the background, because the text of many maps takes long.
void ExportDataDialog::startPreview() {
    constexpr qsizetype maxShown = 8000; // bytes, since palettes are long
    constexpr std::chrono::milliseconds patience{30};
    const auto work = io::inBackground<QByteArray>(
        [make = textMaker()](QPromise<QByteArray>& result) { result.addResult(make().left(maxShown)); });
    m_previewed.setFuture(work);
    if (io::finishesWithin(patience, work)) showPreview();
}

void ExportDataDialog::showPreview() {
    const QFuture<QByteArray> text = m_previewed.future();
    if (text.isResultReadyAt(0)) m_preview->setPlainText(QString::fromUtf8(text.result()));
}

QString ExportDataDialog::chosenFile() {
    const QString path = chooseFile({.title = tr("Export Data"), .suffix = suffix()});
    if (!path.isEmpty()) remember({dataNameOf(format()), {}}, path);
    return path;
}

void ExportDataDialog::exportTo(const QString& path) {
    if (textFormat()) return writeText(textMaker()(), path);
    start(io::PointCloud{m_fractal, std::uint64_t(m_points->value()), 1, pointFormat()}, path);
}

void ExportDataDialog::copy() {
    QGuiApplication::clipboard()->setText(QString::fromUtf8(textMaker()()));
    say(withLoss(tr("The text was copied to the clipboard.")));
}

QString ExportDataDialog::sentenceFor(const io::ExportOutcome& outcome, const QString& path) const {
    const QString sentence = ExportShell::sentenceFor(outcome, path);
    return outcome.stopped || outcome.failure ? sentence : withLoss(sentence);
}

QString ExportDataDialog::withLoss(const QString& sentence) const {
    const QString lost = loss();
    return lost.isEmpty() ? sentence : sentence + u'\n' + lost;
}

} // namespace view
