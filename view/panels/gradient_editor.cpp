// SPDX-License-Identifier: MIT
#include "panels/gradient_editor.h"

#include "attractor/palette_edits.h"
#include "dialogs/save_file_dialog.h"
#include "icon.h"
#include "io/palette_reader.h"
#include "io/save_file.h"
#include "panels/appearance_colour_button.h"
#include "panels/gradient_preview.h"
#include "panels/gradient_strip.h"
#include "panels/number_field.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace view {

GradientEditor::GradientEditor(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Palette editor"));
    m_strip = new GradientStrip(this);
    m_colour = new ColourButton(tr("Colour of the stop"), ColourButton::Alpha::Adjustable, this);
    m_position = new NumberField(this);
    m_position->setAccessibleName(tr("Position of the stop"));
    m_position->setToolTip(tr("Position of the stop, from 0 to 1"));
    m_position->setRange({0.0, 1.0, NumberRange::Ends::Closed});
    m_position->setFixedWidth(m_position->minimumSizeHint().width() + 14);
    auto* add = button(QStringLiteral("add"), tr("Add Stop"), tr("Add a stop after the chosen one"));
    m_remove = button(QStringLiteral("remove"), tr("Delete Stop"), tr("Delete the chosen stop"));
    auto* turn = button({}, tr("Reverse"), tr("Turn the palette round"));
    auto* spread = button({}, tr("Distribute"), tr("Put the stops at equal distances"));
    auto* open =
        button(QStringLiteral("open"), tr("Load…"), tr("Load a palette from a .gpl, .ugr or .map file"));
    auto* keep = button(QStringLiteral("save-as"), tr("Save As…"), tr("Save the palette as a .gpl file"));

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
    connect(add, &QToolButton::clicked, m_strip, &GradientStrip::addAfterSelected);
    connect(m_remove, &QToolButton::clicked, m_strip, &GradientStrip::removeSelected);
    connect(turn, &QToolButton::clicked, this, &GradientEditor::reverse);
    connect(spread, &QToolButton::clicked, this, &GradientEditor::distribute);
    connect(open, &QToolButton::clicked, this, &GradientEditor::chooseFile);
    connect(keep, &QToolButton::clicked, this, [this] {
        const QString name = QString::fromStdString(m_strip->gradient().name);
        const QString path = chooseFileToSave(
            this, tr("Save Palette"), (name.isEmpty() ? tr("palette") : name) + QStringLiteral(".gpl"),
            tr("GIMP palettes (*.gpl)"), QStringLiteral("gpl"));
        if (!path.isEmpty()) save(path);
    });
}

QToolButton* GradientEditor::button(const QString& iconName, const QString& text, const QString& tip) {
    auto* made = new QToolButton(this);
    if (iconName.isEmpty())
        made->setText(text);
    else
        made->setIcon(icon(iconName));
    made->setIconSize({18, 18});
    made->setAutoRaise(true);
    made->setAccessibleName(text);
    made->setToolTip(tip);
    return made;
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

void GradientEditor::chooseFile() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Load Palette"), {}, tr("Palettes (*.gpl *.ugr *.gradient *.map);;All files (*)"));
    if (!path.isEmpty()) load(path);
}

void GradientEditor::load(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    const io::Loaded loaded = io::loadFile(path);
    if (loaded.failure) return emit message(*loaded.failure);
    const io::PaletteFile file = io::readPalettes(loaded.bytes, QFileInfo(path).completeBaseName());
    if (!file.problems.isEmpty()) {
        const document::Problem& problem = file.problems.back();
        emit message(problem.line > 0 ? tr("%1, line %2: %3").arg(name).arg(problem.line).arg(problem.message)
                                      : tr("%1: %2").arg(name, problem.message));
    }
    if (file.palettes.size() == 1)
        apply(tr("Load the palette %1").arg(name), file.palettes.front());
    else if (!file.palettes.empty())
        chooseAmong(file.palettes);
}

void GradientEditor::chooseAmong(const std::vector<attractor::Palette>& palettes) {
    QDialog dialog(this);
    dialog.setWindowTitle(tr("Load Palette"));
    auto* list = new QListWidget(&dialog);
    list->setAccessibleName(tr("Palettes of the file"));
    list->setWhatsThis(tr("The palettes that the file holds. Choose one."));
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
    const io::Failure failure = io::saveFile(path, io::writeGimpPalette(m_strip->gradient()));
    emit message(failure ? *failure : tr("Saved %1.").arg(QFileInfo(path).fileName()));
}

} // namespace view
