// SPDX-License-Identifier: MIT
#include "panels/appearance/palettes/gradient_editor.h"

#include "attractor/colour/palette_edits.h"
#include "io/file/background.h"
#include "io/file/save_file.h"
#include "io/palette/palette_reader.h"
#include "io/picture/decoding/picture_decoder.h"
#include "panels/appearance/controls/appearance_colour_button.h"
#include "panels/appearance/palettes/gradient_preview.h"
#include "panels/appearance/palettes/gradient_strip.h"
#include "panels/appearance/palettes/picture_palette_dialog.h"
#include "widgets/background/save_beside.h"
#include "widgets/background/wait_for.h"
#include "widgets/file_dialogs.h"
#include "widgets/flat_buttons.h"
#include "widgets/numbers/number_field.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QToolButton>
#include <QVBoxLayout>

namespace view {

namespace {

bool isPicture(const QString& path) {
    return io::pictureSuffixes().contains(QFileInfo(path).suffix().toLower());
}

} // namespace

GradientEditor::GradientEditor(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Palette editor"));
    m_strip = new GradientStrip(this);
    m_colour = new ColourButton(tr("Stop Colour"), ColourButton::Alpha::Adjustable, this);
    m_position = new NumberField(this);
    m_position->setAccessibleName(tr("Position of the stop"));
    m_position->setToolTip(tr("Position of the stop, from 0 to 1"));
    m_position->setRange({0.0, 1.0, NumberRange::Ends::Closed});
    m_position->setFixedWidth(m_position->minimumSizeHint().width() + 14);
    auto* add =
        flatButton(QStringLiteral("add"), tr("Add Stop"), tr("Add a stop after the selected one"), this);
    m_remove = flatButton(QStringLiteral("remove"), tr("Delete Stop"), tr("Delete the selected stop"), this);
    auto* turn = flatButton({}, tr("Reverse"), tr("Reverse the order of the colours"), this);
    auto* spread = flatButton({}, tr("Distribute"), tr("Space the stops evenly"), this);
    auto* open = flatButton(
        QStringLiteral("open"), tr("Load…"),
        tr("Load a palette from a .gpl, .ggr, .ugr or .map file, or take it from a picture"), this);
    auto* keep =
        flatButton(QStringLiteral("save-as"), tr("Save As…"), tr("Save the palette as a .gpl file"), this);

    auto* stopRow = new QHBoxLayout;
    stopRow->setSpacing(6);
    stopRow->addWidget(m_colour);
    stopRow->addWidget(m_position);
    stopRow->addWidget(add);
    stopRow->addWidget(m_remove);
    stopRow->addStretch();
    auto* wholeRow = new QHBoxLayout;
    wholeRow->setSpacing(6);
    wholeRow->addWidget(turn);
    wholeRow->addWidget(spread);
    wholeRow->addStretch();
    wholeRow->addWidget(open);
    wholeRow->addWidget(keep);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_strip);
    layout->addLayout(stopRow);
    layout->addLayout(wholeRow);

    connect(add, &QToolButton::clicked, m_strip, &GradientStrip::addAfterSelected);
    connect(m_remove, &QToolButton::clicked, m_strip, &GradientStrip::removeSelected);
    connect(turn, &QToolButton::clicked, this, &GradientEditor::reverse);
    connect(spread, &QToolButton::clicked, this, &GradientEditor::distribute);
    connect(open, &QToolButton::clicked, this, &GradientEditor::chooseAndLoad);
    connect(keep, &QToolButton::clicked, this, &GradientEditor::chooseAndSave);
    keep->setObjectName(QStringLiteral("save-palette"));
    connectEditors();
}

void GradientEditor::connectEditors() {
    connect(m_strip, &GradientStrip::tried, this, &GradientEditor::tried);
    connect(m_strip, &GradientStrip::accepted, this, &GradientEditor::accepted);
    connect(m_strip, &GradientStrip::rejected, this, &GradientEditor::rejected);
    connect(m_strip, &GradientStrip::selectionChanged, this, &GradientEditor::showSelected);
    connect(m_strip, &GradientStrip::colourWanted, m_colour, &QToolButton::click);
    connect(m_colour, &ColourButton::tried, this, [this](const attractor::Rgba& colour) {
        attractor::Palette changed = m_strip->gradient();
        changed.stops.at(m_strip->selected()).colour = colour;
        emit tried(tr("Change a colour of the palette"), changed);
    });
    connect(m_colour, &ColourButton::accepted, this, &GradientEditor::accepted);
    connect(m_colour, &ColourButton::rejected, this, &GradientEditor::rejected);
    connect(m_position, &NumberField::edited, this, [this](double position) {
        attractor::Palette changed = m_strip->gradient();
        moveStop(changed, m_strip->selected(), position);
        emit tried(tr("Move a stop of the palette"), changed);
    });
    connect(m_position, &NumberField::committed, this, &GradientEditor::accepted);
    connect(m_position, &NumberField::cancelled, this, &GradientEditor::rejected);
}

void GradientEditor::setGradient(const attractor::Palette& gradient) {
    m_strip->setGradient(gradient);
    showSelected();
}

void GradientEditor::showSelected() {
    const auto& stops = m_strip->gradient().stops;
    if (m_strip->selected() >= stops.size()) return;
    const auto& stop = stops[m_strip->selected()];
    m_colour->setColour(stop.colour);
    m_position->setValue(stop.position);
    const bool inner = canMove(m_strip->gradient(), m_strip->selected());
    m_position->setEnabled(inner);
    m_remove->setEnabled(inner);
}

void GradientEditor::apply(const QString& what, const attractor::Palette& gradient) {
    emit tried(what, gradient);
    emit accepted();
}

void GradientEditor::reverse() {
    attractor::Palette changed = m_strip->gradient();
    attractor::reverse(changed);
    apply(tr("Reverse the palette"), changed);
}

void GradientEditor::distribute() {
    attractor::Palette changed = m_strip->gradient();
    attractor::distribute(changed);
    apply(tr("Distribute the stops of the palette"), changed);
}

void GradientEditor::chooseAndLoad() {
    const QString path =
        chooseFileToOpen(this, tr("Load Palette"),
                         tr("Palettes and pictures (%1);;All files (*)")
                             .arg(QStringLiteral("*.gpl *.ggr *.ugr *.gradient *.map ") + namesOfPictures()));
    if (!path.isEmpty()) load(path);
}

void GradientEditor::chooseAndSave() {
    const QString name = QString::fromStdString(m_strip->gradient().name);
    const QString path = chooseFileToSave(
        this, tr("Save Palette"), suggestedName(name.isEmpty() ? tr("palette") : name, QStringLiteral("gpl")),
        tr("GIMP palettes (*.gpl)"), QStringLiteral("gpl"));
    if (!path.isEmpty()) save(path);
}

void GradientEditor::load(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    struct Reading {
        io::Failure failure;
        io::PaletteFile file;
        QImage picture; // valid if the file is a picture
    };
    std::stop_source stop;
    auto reading = io::inBackground<Reading>(io::Lane::Reading, [path, token = stop.get_token()](
                                                                    QPromise<Reading>& promise) {
        const io::Loaded loaded = io::loadFile(path);
        Reading result{loaded.failure, {}, {}};
        if (!loaded.failure && isPicture(path)) {
            io::DecodedPicture decoded = io::decodedPicture(loaded.bytes, io::LargePicture::Refused, token);
            result.picture = std::move(decoded.image);
            result.failure = decoded.flaw;
        } else if (!loaded.failure) {
            result.file = io::readPalettes(loaded.bytes, QFileInfo(path).completeBaseName());
        }
        promise.addResult(std::move(result));
    });
    if (!waitFor(QFuture<void>(reading), tr("Reading “%1”…").arg(name), this)) {
        stop.request_stop();
        return;
    }
    const auto [failure, file, picture] = reading.takeResult();
    if (failure) return emit message(*failure);
    if (!picture.isNull()) return takeFrom(picture);
    if (!file.problems.isEmpty()) {
        const document::Problem& problem = file.problems.back();
        emit message(problem.line > 0
                         ? tr("%1, line %2: %3").arg(name, QString::number(problem.line), problem.message)
                         : tr("%1: %2").arg(name, problem.message));
    }
    if (file.palettes.size() == 1)
        apply(tr("Load the palette %1").arg(name), file.palettes.front());
    else if (!file.palettes.empty())
        chooseAmong(file.palettes);
}

void GradientEditor::takeFrom(const QImage& picture) {
    PicturePaletteDialog dialog(picture, this);
    const QString what = tr("Take the palette from a picture");
    connect(&dialog, &PicturePaletteDialog::tried, this,
            [&](const attractor::Palette& palette) { emit tried(what, palette); });
    emit tried(what, dialog.taken());
    if (dialog.exec() == QDialog::Accepted)
        emit accepted();
    else
        emit rejected();
}

void GradientEditor::chooseAmong(const std::vector<attractor::Palette>& palettes) {
    QDialog dialog(this);
    dialog.setWindowTitle(tr("Load Palette"));
    auto* list = new QListWidget(&dialog);
    list->setAccessibleName(tr("Palettes of the file"));
    list->setWhatsThis(tr("The palettes in the file. Select one."));
    constexpr QSize size(112, 14);
    list->setIconSize(size);
    for (const attractor::Palette& palette : palettes)
        new QListWidgetItem(QIcon(gradientPixmap(palette, size, devicePixelRatioF())),
                            QString::fromStdString(palette.name), list);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    auto* layout = new QVBoxLayout(&dialog);
    layout->addWidget(list);
    layout->addWidget(buttons);
    dialog.resize(360, 420);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    connect(list, &QListWidget::itemActivated, &dialog, &QDialog::accept);
    connect(list, &QListWidget::currentRowChanged, this, [&](int row) {
        if (row >= 0) emit tried(tr("Load a palette"), palettes[std::size_t(row)]);
    });
    list->setCurrentRow(0);
    if (dialog.exec() == QDialog::Accepted)
        emit accepted();
    else
        emit rejected();
}

void GradientEditor::save(const QString& path) {
    const QPointer self(this);
    const auto [isCancelled, failure] = saveBeside(path, io::writeGimpPalette(m_strip->gradient()), this);
    if (!self || isCancelled) return;
    emit message(failure ? *failure : tr("Saved %1.").arg(QFileInfo(path).fileName()));
}

} // namespace view
