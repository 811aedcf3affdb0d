// SPDX-License-Identifier: MIT
#include "transformation/transformation_bar.h"

#include "widgets/choices.h"
#include "widgets/flat_buttons.h"
#include "widgets/menus/menu_button.h"
#include "widgets/text/elided_label.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStylePainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <utility>

namespace view {

namespace {

using document::TheftMode;

constexpr int fewLetters = 10; // letters of a combo box in a narrow window
constexpr int moreLetters = 16;
constexpr int narrowest = 60; // pixels of a combo box in the narrowest window

QToolButton* named(const char* name, QToolButton* button) {
    button->setObjectName(QLatin1String(name));
    return button;
}

// A combo box that abbreviates a long choice with dots; the list shows it whole.
class NamesBox : public QComboBox {
public:
    using QComboBox::QComboBox;

    void showPopup() override {
        view()->setMinimumWidth(view()->sizeHintForColumn(0) +
                                view()->verticalScrollBar()->sizeHint().width());
        QComboBox::showPopup();
    }

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QStylePainter painter(this);
        QStyleOptionComboBox option;
        initStyleOption(&option);
        painter.drawComplexControl(QStyle::CC_ComboBox, option);
        const int room =
            style()
                ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this)
                .width() -
            2;
        option.currentText = fontMetrics().elidedText(option.currentText, Qt::ElideMiddle, room);
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
    }
};

MenuButton* menuButton(const QString& text, const QString& tip, QWidget* parent) {
    auto* made = new MenuButton(parent);
    made->setText(text);
    made->setAccessibleName(text);
    made->setToolTip(tip);
    made->setPopupMode(QToolButton::InstantPopup);
    made->setMenu(new QMenu(made));
    return made;
}

QComboBox* comboBox(const QString& name, const QString& tip, QWidget* parent) {
    auto* made = new NamesBox(parent);
    made->setMinimumWidth(narrowest);
    made->setAccessibleName(name);
    made->setToolTip(tip);
    made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made->setMinimumContentsLength(fewLetters);
    return made;
}

} // namespace

TransformationBar::TransformationBar(QWidget* parent)
    : QWidget(parent),
      m_from(new ElidedLabel(this)),
      m_partner(comboBox(tr("Partner"), tr("The entry on which the picture is placed"), this)),
      m_mode(comboBox(tr("Mode"), tr("What the fractal transformation does with the picture"), this)),
      m_status(new ElidedLabel(this)) {
    setAccessibleName(tr("Fractal transformation"));
    m_mode->setMinimumContentsLength(moreLetters);
    addChoice(m_mode, tr("Steal Colours"), TheftMode::StealColours);
    addChoice(m_mode, tr("Transform a Picture"), TheftMode::TransformPicture);
    addChoice(m_mode, tr("Deformation Grid"), TheftMode::DeformationGrid);
    addChoice(m_mode, tr("Filter: Reduce"), TheftMode::Reduce);
    addChoice(m_mode, tr("Filter: Posterise"), TheftMode::Posterise);
    addPictures();
    addStarters();
    addButtons();
    m_status->setLines(2);
    m_status->setAccessibleName(tr("State of the fractal transformation"));

    auto* first = new QHBoxLayout;
    for (QWidget* widget : {static_cast<QWidget*>(m_from), static_cast<QWidget*>(m_partner),
                            static_cast<QWidget*>(m_mode), static_cast<QWidget*>(m_picture),
                            static_cast<QWidget*>(m_starters), static_cast<QWidget*>(m_export)})
        first->addWidget(widget, widget == m_from || widget == m_partner ? 1 : 0);
    auto* last = new QHBoxLayout;
    last->addWidget(m_status, 1);
    last->addWidget(m_remedy);
    last->addWidget(m_overlay);
    last->addWidget(m_stack);
    last->addStrut(m_remedy->sizeHint().height()); // same height with and without a message
    m_rows = new QVBoxLayout(this);
    m_rows->setContentsMargins(8, 4, 8, 4);
    m_rows->setSpacing(4);
    m_rows->addLayout(first);
    m_rows->addLayout(last);

    connect(m_partner, &QComboBox::activated, this,
            [this] { emit partnerChosen(chosenValue<document::EntryId>(m_partner)); });
    connect(m_mode, &QComboBox::activated, this, [this] { emit modeChosen(chosenValue<TheftMode>(m_mode)); });
    connect(m_export, &QToolButton::clicked, this, &TransformationBar::exportWanted);
    connect(m_overlay, &QToolButton::toggled, this, &TransformationBar::overlaid);
    connect(m_stack, &QToolButton::toggled, this, &TransformationBar::stacked);
    connect(m_remedy, &QToolButton::clicked, this, [this] {
        if (m_wanted == Remedy::DivideWords) emit divideWanted();
        if (m_wanted == Remedy::ResetOrder) emit resetOrderWanted();
        if (m_wanted == Remedy::FindPicture) emit pictureWanted();
        if (m_wanted == Remedy::OpenForeignPicture) emit foreignPictureWanted();
    });
    showProblem({}, Remedy::None);
}

void TransformationBar::addButtons() {
    m_export =
        named("export", flatButton(QString(), tr("Export…"), tr("Save the stolen picture as PNG"), this));
    m_export->setEnabled(false);
    m_remedy = flatButton(QString(), tr("Divide Words"), QString(), this);
    m_overlay = named(
        "overlay",
        flatButton(QString(), tr("Overlay"),
                   tr("Show the partner half transparent over the fractal, in the same coordinates"), this));
    m_overlay->setCheckable(true);
    m_stack = named(
        "stack", flatButton(QString(), tr("Stack"),
                            tr("Show the two fractals one above the other instead of side by side"), this));
    m_stack->setCheckable(true);
}

void TransformationBar::addPictures() {
    m_picture =
        menuButton(tr("Picture"), tr("The picture on the partner; you can also drop one there"), this);
    QMenu* menu = m_picture->menu();
    menu->addAction(tr("Choose Picture…"), this, &TransformationBar::pictureWanted);
    m_embed = menu->addAction(tr("Embed in the File"));
    m_embed->setObjectName(QStringLiteral("embed"));
    m_embed->setCheckable(true);
    m_embed->setToolTip(tr("Store the picture itself with the entry, not only its path"));
    m_embed->setWhatsThis(
        tr("Stores the picture itself with the entry, so that the file shows it wherever it goes. "
           "A picture of more than 128 KB is stored smaller. Otherwise only its path is stored."));
    connect(m_embed, &QAction::triggered, this, &TransformationBar::embedWanted);
    menu->addSeparator();
    const std::array<std::pair<attractor::Pattern, QString>, 8> patterns{{
        {attractor::Pattern::Wheel, tr("Colour Wheel")},
        {attractor::Pattern::Grid, tr("Grid")},
        {attractor::Pattern::Rings, tr("Rings")},
        {attractor::Pattern::Sunset, tr("Sunset")},
        {attractor::Pattern::Glass, tr("Stained Glass")},
        {attractor::Pattern::Marble, tr("Marble")},
        {attractor::Pattern::Tartan, tr("Tartan")},
        {attractor::Pattern::Waves, tr("Waves")},
    }};
    for (const auto& [pattern, name] : patterns)
        menu->addAction(name, this, [this, pattern = pattern] { emit patternChosen(pattern); })
            ->setObjectName(QLatin1String(ifs::nameOf(pattern)));
}

void TransformationBar::addStarters() {
    m_starters = menuButton(
        tr("Starters"), tr("Add two entries with the same addresses, whose parameters you can slide"), this);
    const auto add = [this](const char* id, const QString& name, document::TheftFamily family) {
        m_starters->menu()
            ->addAction(name, this, [this, family] { emit starterChosen(family); })
            ->setObjectName(QLatin1String(id));
    };
    add("triangle-family", tr("Triangle Family"), document::TheftFamily::Triangle);
    add("square-family", tr("Square Family"), document::TheftFamily::Square);
}

void TransformationBar::show(const document::FractalFile& file, document::EntryId current,
                             document::EntryId partner, const document::KeptTheft& theft) {
    const QSignalBlocker quiet(m_partner), quietMode(m_mode);
    m_partner->clear();
    for (const document::Entry& entry : file.entries) {
        if (entry.id == current)
            m_from->setText(tr("%1 →").arg(entry.fractal->name));
        else if (document::plane(*entry.fractal))
            addChoice(m_partner, entry.fractal->name, entry.id);
    }
    m_from->setMaximumWidth(m_from->sizeHint().width());
    chooseValue(m_partner, partner);
    m_partner->setEnabled(m_partner->count() > 0);
    chooseValue(m_mode, theft.mode);
    m_embed->setEnabled(!theft.picture.isEmpty());
    m_embed->setChecked(!theft.embedded.isEmpty());
    m_picture->setEnabled(theft.mode != TheftMode::DeformationGrid);
    m_picture->setToolTip(
        theft.picture.isEmpty()
            ? tr("The picture on the partner; you can also drop one there")
            : tr("The picture on the partner: %1").arg(QFileInfo(theft.picture).fileName()));
}

void TransformationBar::showContinuity(const QString& sentence) {
    m_continuity = sentence;
    showStatus();
}

TransformationBar::RemedyTexts TransformationBar::textsOf(Remedy remedy) {
    switch (remedy) {
    case Remedy::FindPicture:
        return {"find-picture", tr("Find Picture…"), tr("Choose the current location of the picture")};
    case Remedy::OpenForeignPicture:
        return {"open-foreign-picture", tr("Open It"),
                tr("Open this picture, which is outside the folder of the file")};
    case Remedy::ResetOrder:
        return {"reset-order", tr("Reset Order"), tr("Put the maps back in the order of their numbers")};
    case Remedy::DivideWords:
    case Remedy::None:
        break;
    }
    return {"divide-words", tr("Divide Words"),
            tr("Divide maps of both entries into words until both have the same number")};
}

void TransformationBar::showProblem(const QString& sentence, Remedy remedy) {
    m_problem = sentence;
    m_wanted = remedy;
    m_remedy->setVisible(remedy != Remedy::None);
    const auto [id, text, tip] = textsOf(remedy);
    m_remedy->setObjectName(QLatin1String(id));
    m_remedy->setText(text);
    m_remedy->setAccessibleName(text);
    m_remedy->setToolTip(tip);
    showStatus();
}

// A problem, or else how continuous it is. What has no room is in the tip.
void TransformationBar::showStatus() {
    const QString& sentence = m_problem.isEmpty() ? m_continuity : m_problem;
    m_status->setText(sentence);
}

void TransformationBar::setExportable(bool exportable) {
    m_export->setEnabled(exportable);
    m_export->setToolTip(exportable ? tr("Save the stolen picture as PNG")
                                    : tr("There is no stolen picture yet"));
}

QString TransformationBar::problem() const {
    return m_problem;
}

QString TransformationBar::continuity() const {
    return m_continuity;
}

void TransformationBar::addSliders(QWidget* sliders) {
    m_rows->insertWidget(1, sliders);
}

} // namespace view
