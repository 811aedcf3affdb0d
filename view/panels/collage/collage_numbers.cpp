// SPDX-License-Identifier: MIT
#include "panels/collage/collage_numbers.h"

#include "widgets/numbers/number_text.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace view {

namespace {

QString percent(double share) {
    return CollageNumbers::tr("%1 %").arg(roundedNumber(100 * share, 1));
}

QString pixels(double distance) {
    return CollageNumbers::tr("%1 px", "pixels").arg(roundedNumber(distance, 2));
}

// A factor that is never “1” for a smaller number.
QString factorText(double factor) {
    const QString text = roundedNumber(factor, 3);
    return factor < 1 && text.toDouble() >= 1 ? fullNumber(factor) : text;
}

// The bound with the norm in which the maps contract, by its usual name.
QString guarantee(const document::MeasuredFractal& measured) {
    if (!measured.bound)
        return CollageNumbers::tr("none: a map stretches by %1").arg(roundedNumber(measured.contraction, 3));
    const QString bound = pixels(*measured.bound), factor = factorText(measured.norm.contractivity);
    switch (measured.norm.norm) {
    case ifs::NormKind::Ellipsoidal:
        return CollageNumbers::tr("%1 (ellipsoidal norm, γ = %2)").arg(bound, factor);
    case ifs::NormKind::Polytope:
        return CollageNumbers::tr("%1 (polytope norm, γ = %2)").arg(bound, factor);
    case ifs::NormKind::Words:
        return CollageNumbers::tr("%1 (any %2 maps in a row contract, γ = %3)")
            .arg(bound)
            .arg(measured.norm.wordLength)
            .arg(factor);
    case ifs::NormKind::Euclidean:
        break;
    }
    return CollageNumbers::tr("%1 (s = %2)").arg(bound, factor);
}

constexpr double visibleGrowth = 0.01; // pixels; last digit shown

QString boundText(const std::optional<double>& bound) {
    return bound ? pixels(*bound) : CollageNumbers::tr("none");
}

} // namespace

QString refinementText(const Refinement& refinement) {
    const auto& [compared, before, after] = refinement;
    const QString distance = compared == document::Compared::Collage
                                 ? CollageNumbers::tr("Mean distance of the collage: %1 → %2.")
                                 : CollageNumbers::tr("Mean distance of the attractor: %1 → %2.");
    QString text =
        distance.arg(pixels(before.agreement.mean), pixels(after.agreement.mean)) + u' ' +
        CollageNumbers::tr("Guarantee: %1 → %2.").arg(boundText(before.bound), boundText(after.bound));
    if (after.agreement.mean >= before.agreement.mean + visibleGrowth)
        text += u' ' + CollageNumbers::tr("The distance has increased, but the overlap (IoU) has improved.");
    if (before.bound && !after.bound)
        text += u' ' + CollageNumbers::tr("Nothing is guaranteed any more.");
    else if (before.bound && *after.bound >= *before.bound + visibleGrowth)
        text += u' ' + CollageNumbers::tr("The guarantee is now weaker.");
    return text;
}

CollageNumbers::CollageNumbers(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    m_sentence = new QLabel(this);
    m_sentence->setWordWrap(true);
    m_sentence->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(m_sentence);
    m_values = new QWidget(this);
    auto* grid = new QGridLayout(m_values);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(16);
    grid->setColumnStretch(1, 1);
    const std::pair<QString, QString> rows[] = {
        {tr("Coverage"), tr("The part of the target that is covered")},
        {tr("Excess"), tr("The area covered outside the target, relative to the area of the target")},
        {tr("Overlap (IoU)"), tr("The area that both cover, relative to the area that either covers")},
        {tr("Overlap of the maps"),
         tr("How often the images of the maps cover the same places: their areas together, "
            "divided by the area that they cover. It is 1 where no two of them overlap")},
        {tr("Mean distance"), tr("From each point to the nearest point of the other shape, in pixels of the "
                                 "picture as it is traced")},
        {tr("95 % within"), tr("95 % of all points are within this distance of the other shape")},
        {tr("Largest distance"), tr("The Hausdorff distance; the mark on the canvas shows where it is")},
        {tr("Guaranteed within"),
         tr("No point of the target is farther from the attractor than this, and no point of the attractor "
            "from the target. The value is larger during a drag, when a coarser picture is measured")},
    };
    for (const auto& [name, tip] : rows) {
        const int row = int(m_labels.size());
        auto* label = new QLabel(name, m_values);
        label->setToolTip(tip);
        auto* value = new QLabel(m_values);
        value->setAccessibleName(name);
        value->setToolTip(tip);
        value->setWordWrap(true); // a bound may name another norm
        value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        grid->addWidget(label, row, 0);
        grid->addWidget(value, row, 1);
        m_labels.push_back(value);
    }
    layout->addWidget(m_values);
    clear({});
}

void CollageNumbers::show(const document::MeasuredFractal& measured) {
    const collage::Agreement& a = measured.agreement;
    const QString texts[] = {
        percent(a.coverage), percent(a.excess), percent(a.iou),      roundedNumber(measured.overlap, 2),
        pixels(a.mean),      pixels(a.p95),     pixels(a.hausdorff), guarantee(measured)};
    for (std::size_t row = 0; row < m_labels.size(); ++row)
        m_labels[row]->setText(texts[row]);
    m_sentence->hide();
    m_values->show();
}

void CollageNumbers::clear(const QString& sentence) {
    m_sentence->setText(sentence);
    m_sentence->setVisible(!sentence.isEmpty());
    m_values->hide();
}

} // namespace view
