// SPDX-License-Identifier: MIT
#include "dialogs/go_to_dialog.h"

#include "document/maps/map_names.h"
#include "io/text/expression.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <utility>

namespace view {

namespace {

constexpr int noMap = -1;

} // namespace

std::optional<ifs::Word> wordOf(const QString& address, std::size_t maps) {
    static const QRegularExpression between(QStringLiteral("[\\s,.…]+"));
    ifs::Word word;
    for (const QString& part : address.split(between, Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const int number = part.toInt(&isNumber);
        if (!isNumber || number < 1 || std::size_t(number) > maps) return std::nullopt;
        word.push_back(number - 1);
    }
    return word;
}

GoToDialog::GoToDialog(std::shared_ptr<const document::Fractal> fractal, const attractor::View& now,
                       QWidget* parent)
    : QDialog(parent),
      m_fractal(std::move(fractal)),
      m_addresses(*m_fractal),
      m_now(now),
      m_x(numberField(now.centre.x(), tr("Centre, x"), tr("The x coordinate in the middle of the view."))),
      m_y(numberField(now.centre.y(), tr("Centre, y"), tr("The y coordinate in the middle of the view."))),
      m_height(numberField(now.height, tr("Height"),
                           tr("How much of the plane is seen, from the lower edge to the upper one."))),
      m_address(new QLineEdit(this)),
      m_map(new QComboBox(this)),
      m_note(new QLabel(this)) {
    setWindowTitle(tr("Go To"));
    m_address->setPlaceholderText(tr("such as 3 2 1"));
    m_address->setAccessibleName(tr("Address"));
    m_address->setWhatsThis(tr("Numbers of maps, as the status bar shows them for the point under the "
                               "pointer. They repeat, and the centre becomes the point that they lead to."));
    addChoice(m_map, tr("Choose a map"), noMap);
    const auto* system = document::system2(*m_fractal);
    const std::size_t maps = system ? system->maps.size() : 0;
    for (std::size_t index = 0; index < maps; ++index)
        addChoice(m_map, tr("Map %1").arg(document::mapTitle(*m_fractal, index)), int(index));
    m_map->setAccessibleName(tr("Fixed point"));
    m_map->setWhatsThis(tr("The centre becomes the point that this map leaves where it is."));
    layFields();
    connect(m_address, &QLineEdit::textEdited, this, &GoToDialog::readAddress);
    connect(m_map, &QComboBox::activated, this, &GoToDialog::chooseMap);
    for (QLineEdit* field : {m_x, m_y, m_height})
        connect(field, &QLineEdit::textChanged, this, &GoToDialog::check);
    m_x->selectAll();
    check();
}

QLineEdit* GoToDialog::numberField(double value, const QString& name, const QString& help) {
    auto* field = new QLineEdit(fullNumber(value), this);
    field->setAccessibleName(name);
    field->setWhatsThis(help);
    field->setCursorPosition(0);
    return field;
}

void GoToDialog::layFields() {
    m_note->setWordWrap(true);
    m_note->setAccessibleName(tr("Note"));
    m_note->setMinimumHeight(2 * m_note->fontMetrics().lineSpacing()); // constant height
    m_note->setAlignment(Qt::AlignTop);
    auto* centre = new QHBoxLayout;
    centre->addWidget(m_x);
    centre->addWidget(m_y);
    auto* form = new QFormLayout;
    auto* label = new QLabel(tr("&Centre:"), this);
    label->setBuddy(m_x);
    form->addRow(label, centre);
    form->addRow(tr("&Height:"), m_height);
    form->addRow(tr("&Address:"), m_address);
    form->addRow(tr("&Fixed point of:"), m_map);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_go = buttons->addButton(tr("&Go"), QDialogButtonBox::AcceptRole);
    m_go->setDefault(true);
    m_go->setWhatsThis(tr("Shows this part of the plane. The fractal stays as it is."));
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_note);
    layout->addStretch();
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const int digits = fontMetrics().horizontalAdvance(u'0') * 22;
    m_x->setMinimumWidth(digits);
    m_y->setMinimumWidth(digits);
}

void GoToDialog::fillCentre(const ifs::Word& word) {
    const auto point = m_addresses.fixedPoint(word);
    if (!point) {
        m_note->setText(tr("No point has this address: a map in it is switched off, or does not contract."));
        return;
    }
    m_x->setText(fullNumber(point->x()));
    m_y->setText(fullNumber(point->y()));
    for (QLineEdit* field : {m_x, m_y})
        field->setCursorPosition(0);
}

void GoToDialog::readAddress() {
    chooseValue(m_map, noMap);
    m_note->clear();
    const auto* system = document::system2(*m_fractal);
    const std::size_t maps = system ? system->maps.size() : 0;
    const auto word = wordOf(m_address->text(), maps);
    if (!word)
        m_note->setText(tr("An address has the numbers of maps, from 1 to %1.").arg(maps));
    else if (!word->empty())
        fillCentre(*word);
}

void GoToDialog::chooseMap() {
    m_address->clear();
    m_note->clear();
    if (const int map = chosenValue<int>(m_map); map != noMap) fillCentre({map});
}

std::optional<attractor::View> GoToDialog::view() const {
    const auto x = io::evaluate(m_x->text()), y = io::evaluate(m_y->text()),
               height = io::evaluate(m_height->text());
    if (!x || !y || !height || *height <= 0) return std::nullopt;
    attractor::View view = m_now;
    view.centre = {*x, *y};
    view.height = *height;
    return view;
}

void GoToDialog::check() {
    m_go->setEnabled(view().has_value());
}

} // namespace view
