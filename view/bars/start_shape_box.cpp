// SPDX-License-Identifier: MIT
#include "bars/start_shape_box.h"

#include "bridges/steps_bridge.h"
#include "widgets/choices.h"
#include "widgets/file_dialogs.h"
#include "widgets/text/tooltip_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

namespace view {

namespace {

using Start = StepsBridge::Start;

constexpr int maxLetters = 3;

} // namespace

StartShapeBox::StartShapeBox(StepsBridge* steps, QWidget* parent)
    : QWidget(parent), m_steps(steps), m_choice(new QComboBox(this)), m_letter(new QLineEdit(this)) {
    auto* label = new QLabel(tr("&From"), this);
    label->setBuddy(m_choice);
    addChoice(m_choice, tr("The Cage"), Start::Cage);
    addChoice(m_choice, tr("A Square"), Start::Square);
    addChoice(m_choice, tr("A Letter"), Start::Letter);
    addChoice(m_choice, tr("A Picture…"), Start::Picture);
    m_choice->setAccessibleName(tr("What the steps start from"));
    m_choice->setWhatsThis(tr("What the steps start from. Whatever you choose, the images get closer to the "
                              "same attractor: a square, a letter that you type, or the dark shape in a "
                              "picture, each as large as the attractor."));
    constexpr int fewLetters = 8; // in a narrow window
    m_choice->setMinimumWidth(fewLetters * fontMetrics().averageCharWidth());
    m_letter->setMaxLength(maxLetters);
    m_letter->setText(steps->letter());
    m_letter->setAccessibleName(tr("Letters to start from"));
    m_letter->setToolTip(tr("One letter, or up to three"));
    m_letter->setWhatsThis(tr("The letter that the steps start from, or up to three letters. One that is not "
                              "symmetric, such as R, shows how the maps turn and reflect."));
    m_letter->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("WWW")) + 16);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label);
    layout->addWidget(m_choice);
    layout->addWidget(m_letter);
    connect(m_choice, &QComboBox::activated, this, &StartShapeBox::choose);
    connect(m_letter, &QLineEdit::textChanged, steps, &StepsBridge::setLetter);
    connect(steps, &StepsBridge::changed, this, &StartShapeBox::follow);
    follow();
}

void StartShapeBox::choose() {
    const auto start = chosenValue<Start>(m_choice);
    if (start != Start::Picture) {
        m_steps->setStart(start);
        if (start == Start::Letter) {
            m_letter->setFocus();
            m_letter->selectAll();
        }
        return;
    }
    const QString path = choosePictureToOpen(this, tr("Choose a Picture to Start From"));
    if (!path.isEmpty()) m_steps->readPicture(path);
    follow(); // restores the choice until the picture has been read
}

void StartShapeBox::follow() {
    const QSignalBlocker quiet(m_choice);
    chooseValue(m_choice, m_steps->start());
    m_choice->setToolTip(m_steps->start() == Start::Picture ? tooltipText(m_steps->pictureName())
                                                            : tr("What the steps start from"));
    m_letter->setVisible(m_steps->start() == Start::Letter);
}

} // namespace view
