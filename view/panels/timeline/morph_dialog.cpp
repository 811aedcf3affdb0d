// SPDX-License-Identifier: MIT
#include "panels/timeline/morph_dialog.h"

#include "attractor/request/appearance.h"
#include "document/moments/animated_fractal.h"
#include "io/file/background.h"
#include "panels/timeline/morph_lines.h"
#include "widgets/choices.h"
#include "widgets/text/tooltip_text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

constexpr int momentCount = 5; // pictures of the morph, from its beginning to its end
constexpr int side = 88;       // pixels of each picture

template <int Dim>
std::vector<QColor> coloursIn(const document::Fractal& fractal, const document::Shape<Dim>& shape) {
    std::vector<QColor> colours;
    for (const auto& map : shape.system.maps) {
        const auto colour = attractor::mapColour(fractal.appearance, map.id, colours.size());
        colours.emplace_back(colour.red, colour.green, colour.blue);
    }
    return colours;
}

std::vector<QColor> mapColours(const document::Fractal& fractal) {
    if (const auto* plane = document::plane(fractal)) return coloursIn<2>(fractal, *plane);
    if (const auto* space = document::space(fractal)) return coloursIn<3>(fractal, *space);
    return {};
}

} // namespace

QString morphObstacle(document::MorphFlaw flaw) {
    switch (flaw) {
    case document::MorphFlaw::Dimensions:
        return MorphDialog::tr("A fractal in the plane cannot become one in space.");
    case document::MorphFlaw::TooMany:
        return MorphDialog::tr("One of the two fractals has more than 256 maps.");
    case document::MorphFlaw::Linked:
        return MorphDialog::tr("The maps of one of the two fractals are linked.");
    case document::MorphFlaw::BentCage:
        return MorphDialog::tr("A bent cage has no code to start from. Reset or bake it first.");
    case document::MorphFlaw::Measure:
        break;
    }
    return MorphDialog::tr("One of the two fractals has no attractor.");
}

MorphDialog::MorphDialog(const document::Document& document, int length, QWidget* parent)
    : QDialog(parent),
      m_from(document.sharedFractal()),
      m_length(length),
      m_thumbnails(new Thumbnails(this)) {
    setWindowTitle(tr("Morph “%1”").arg(titleText(m_from->name)));
    createControls();
    for (const document::Entry& entry : document.file().entries) {
        if (entry.id == document.currentId() ||
            document::dimension(*entry.fractal) != document::dimension(*m_from))
            continue;
        addChoice(m_target, entry.fractal->name, entry.fractal);
    }
    connect(m_target, &QComboBox::currentIndexChanged, this, &MorphDialog::takeTarget);
    connect(m_lines, &MorphLines::pinsChanged, this, &MorphDialog::solve);
    connect(m_lines, &MorphLines::currentChanged, this, [this] {
        if (!isSolved()) return;
        m_sentence->setText(m_lines->sentence());
        m_lines->setAccessibleDescription(m_lines->sentence());
    });
    connect(&m_solving, &QFutureWatcherBase::finished, this, &MorphDialog::takeOutcome);
    connect(m_thumbnails, &Thumbnails::ready, this, &MorphDialog::showMoments);
    takeTarget();
}

MorphDialog::~MorphDialog() {
    m_solving.cancel();
}

void MorphDialog::createControls() {
    m_target = new QComboBox(this);
    m_target->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_target->setWhatsThis(tr("The entry of this file that the fractal becomes."));
    auto* label = new QLabel(tr("&Becomes:"), this);
    label->setBuddy(m_target);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_target, 1);
    m_lines = new MorphLines;
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setMinimumHeight(220);
    area->setWidget(m_lines);
    connect(m_lines, &MorphLines::currentChanged, area, [this, area] {
        const QRect place = m_lines->rectOf(m_lines->current());
        area->ensureVisible(place.center().x(), place.center().y(), place.width() / 2, place.height());
    });
    m_sentence = new QLabel(this);
    m_sentence->setWordWrap(true);
    m_sentence->setMinimumHeight(2 * fontMetrics().lineSpacing());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_add = buttons->addButton(tr("&Add Morph"), QDialogButtonBox::AcceptRole);
    m_add->setObjectName(QStringLiteral("add"));
    m_add->setWhatsThis(
        tr("Adds the morph to the file as an entry of its own, in one step that you can undo."));
    m_clear = buttons->addButton(tr("&Remove Pins"), QDialogButtonBox::ResetRole);
    m_clear->setWhatsThis(tr("Pairs all maps so that the total distance is shortest."));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_clear, &QPushButton::clicked, m_lines, &MorphLines::clearPins);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(row);
    layout->addWidget(area, 1);
    layout->addWidget(m_sentence);
    createMoments();
    layout->addWidget(buttons);
}

void MorphDialog::createMoments() {
    m_thumbnails->setSize(side, devicePixelRatioF());
    auto* row = new QHBoxLayout;
    for (int i = 0; i < momentCount; ++i) {
        auto* picture = new QLabel(this);
        picture->setFixedSize(side, side);
        picture->setAccessibleName(tr("The morph at %1 %").arg(100 * i / (momentCount - 1)));
        m_pictures.push_back(picture);
        if (i > 0) row->addStretch();
        row->addWidget(picture);
    }
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

MorphDialog::FractalPointer MorphDialog::chosenFractal() const {
    return chosenValue<FractalPointer>(m_target);
}

QString MorphDialog::targetName() const {
    const FractalPointer to = chosenFractal();
    return to ? to->name : QString();
}

void MorphDialog::takeTarget() {
    const auto to = chosenFractal();
    m_target->setEnabled(to != nullptr);
    m_lines->setColumns(mapColours(*m_from), to ? mapColours(*to) : std::vector<QColor>());
    solve();
}

void MorphDialog::solve() {
    m_clear->setEnabled(!m_lines->pins().empty());
    m_add->setEnabled(false);
    m_solving.cancel();
    m_outcome = {};
    const auto to = chosenFractal();
    if (!to) return m_sentence->setText(tr("This file has no other fractal of this dimension."));
    m_solving.setFuture(io::inBackground<document::MorphOutcome>(
        [from = m_from, to, length = m_length,
         pins = m_lines->pins()](QPromise<document::MorphOutcome>& promise) {
            if (!promise.isCanceled()) promise.addResult(document::morphed(*from, *to, length, pins));
        }));
}

void MorphDialog::takeOutcome() {
    if (m_solving.isCanceled() || m_solving.future().resultCount() == 0) return;
    m_outcome = m_solving.result();
    m_add->setEnabled(isSolved());
    m_lines->setPairs(m_outcome.pairs);
    m_sentence->setText(isSolved() ? m_lines->sentence() : morphObstacle(m_outcome.flaw));
    m_moments.clear();
    ++m_solved;
    if (const auto facts = isSolved() ? document::animationFacts(morph()) : std::nullopt)
        for (const animation::Moment& moment : document::moments(*facts, momentCount))
            m_moments.push_back(
                std::make_shared<const document::Fractal>(document::frameAt(morph(), moment).fractal));
    showMoments();
}

void MorphDialog::showMoments() {
    for (std::size_t i = 0; i < m_pictures.size(); ++i) {
        const QPixmap picture = i < m_moments.size()
                                    ? m_thumbnails->thumbnail(m_solved * momentCount + i, m_moments[i]).pixmap
                                    : QPixmap();
        if (!picture.isNull() || m_moments.empty()) m_pictures[i]->setPixmap(picture);
    }
}

} // namespace view
