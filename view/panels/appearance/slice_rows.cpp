// SPDX-License-Identifier: MIT
#include "panels/appearance/slice_rows.h"

#include "document/fractal/space_geometry.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_field.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace view {

namespace {

using attractor::SpaceClip;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double usualThickness = 0.1; // share of the extent along the normal
// Directions in the order of SliceRows::Across.
const std::array<ifs::Vector<3>, 4> directions{ifs::Vector<3>::UnitX(), ifs::Vector<3>::UnitY(),
                                               ifs::Vector<3>::UnitZ(), ifs::Vector<3>::Ones()};

SliceRows::Kind kindOf(const std::optional<SpaceClip>& clip) {
    if (!clip) return SliceRows::Kind::Whole;
    return std::isfinite(clip->lowest) && std::isfinite(clip->highest) ? SliceRows::Kind::Slice
                                                                       : SliceRows::Kind::Half;
}

// Offset in units of space: of the middle of a slice, or of the border of a half.
double offsetOf(const SpaceClip& clip) {
    const double sum = std::isfinite(clip.lowest) ? clip.lowest : clip.highest;
    return (std::isfinite(clip.highest) ? (sum + clip.highest) / 2 : sum) / clip.normal.norm();
}

double thicknessOf(const SpaceClip& clip) {
    return (clip.highest - clip.lowest) / clip.normal.norm();
}

void place(SpaceClip& clip, double offset, double thickness) {
    const double length = clip.normal.norm();
    if (std::isfinite(clip.lowest)) clip.lowest = (offset - thickness / 2) * length;
    clip.highest = (offset + thickness / 2) * length;
}

} // namespace

SliceRows::SliceRows(QFormLayout* form, document::Document* document, QWidget* parent)
    : QObject(parent), m_form(form), m_document(document), m_edit(document) {
    makeRows(form, parent);
}

void SliceRows::makeRows(QFormLayout* form, QWidget* parent) {
    m_kind = new QComboBox(parent);
    m_kind->setAccessibleName(tr("Slice"));
    m_kind->setWhatsThis(
        tr("Cuts the picture open by hiding everything in front of a plane, or everything outside a slice. "
           "Drag the plane by the handle at its centre."));
    addChoice(m_kind, tr("Whole"), Kind::Whole);
    addChoice(m_kind, tr("Half"), Kind::Half);
    addChoice(m_kind, tr("Thin slice"), Kind::Slice);
    connect(m_kind, &QComboBox::activated, this, [this] { choose(chosenValue<Kind>(m_kind)); });
    form->addRow(tr("Slice"), m_kind);
    makeNormal(form, parent);
    m_offset =
        new AppearanceSlider(tr("Position of the plane"), -1, 1, AppearanceSlider::Scale::Linear, parent);
    m_thickness =
        new AppearanceSlider(tr("Thickness of the slice"), 0, 1, AppearanceSlider::Scale::Linear, parent);
    const auto link = [this](AppearanceSlider* slider, const QString& text, auto change) {
        connect(slider, &AppearanceSlider::tried, this, [this, text, change](double value) {
            editClip(text, [&](SpaceClip& clip) { change(clip, value); });
        });
        connect(slider, &AppearanceSlider::accepted, this, [this] { m_edit.commit(); });
        connect(slider, &AppearanceSlider::rejected, this, [this] { m_edit.cancel(); });
    };
    link(m_offset, tr("Move the Slice"), [](SpaceClip& clip, double value) {
        place(clip, value, kindOf(clip) == Kind::Slice ? thicknessOf(clip) : 0);
    });
    link(m_thickness, tr("Thickness of the slice"),
         [](SpaceClip& clip, double value) { place(clip, offsetOf(clip), value); });
    form->addRow(tr("Position"), m_offset);
    form->addRow(tr("Thickness"), m_thickness);
}

void SliceRows::makeNormal(QFormLayout* form, QWidget* parent) {
    m_direction = new QComboBox(parent);
    m_direction->setAccessibleName(tr("Direction of the plane"));
    m_direction->setWhatsThis(tr("Sets the plane perpendicular to an axis or the diagonal; type any other "
                                 "normal in the fields below."));
    addChoice(m_direction, tr("Across X"), Across::X);
    addChoice(m_direction, tr("Across Y"), Across::Y);
    addChoice(m_direction, tr("Across Z"), Across::Z);
    addChoice(m_direction, tr("Across the diagonal"), Across::Diagonal);
    addChoice(m_direction, tr("As typed"), Across::Typed);
    connect(m_direction, &QComboBox::activated, this, [this] {
        if (const auto across = chosenValue<Across>(m_direction); across != Across::Typed)
            turnTo(directions.at(std::size_t(across)), tr("Turn the Slice"));
    });
    form->addRow(tr("Direction"), m_direction);
    m_normalBox = new QWidget(parent);
    auto* line = new QHBoxLayout(m_normalBox);
    line->setContentsMargins(0, 0, 0, 0);
    const QString axes[] = {tr("x of the normal"), tr("y of the normal"), tr("z of the normal")};
    for (int axis = 0; axis < 3; ++axis) {
        auto*& field = m_normal[std::size_t(axis)];
        field = new NumberField(m_normalBox);
        field->setAccessibleName(axes[axis]);
        field->setToolTip(tr("The direction perpendicular to the plane"));
        line->addWidget(field);
        connect(field, &NumberField::edited, this, [this, axis](double value) { editNormal(axis, value); });
        connect(field, &NumberField::committed, this, [this] { m_edit.commit(); });
        connect(field, &NumberField::cancelled, this, [this] { m_edit.cancel(); });
    }
    form->addRow(tr("Normal"), m_normalBox);
}

// A half keeps the part below its plane; both begin in the middle of the picture.
void SliceRows::choose(Kind kind) {
    m_edit.commit();
    document::Fractal fractal = m_document->fractal();
    std::optional<SpaceClip>& clip = fractal.inSpace.clip;
    if (kind == Kind::Whole) {
        clip.reset();
    } else {
        SpaceClip made = clip.value_or(SpaceClip{ifs::Vector<3>::UnitZ(), 0, 0});
        const auto extent = document::extentAlong(fractal, made.normal.normalized());
        const double offset = clip ? offsetOf(*clip) : (extent.low + extent.high) / 2;
        made.lowest = kind == Kind::Half ? -infinite : 0;
        place(made, offset, kind == Kind::Half ? 0 : usualThickness * (extent.high - extent.low));
        clip = made;
    }
    m_document->edit(kind == Kind::Whole ? tr("Show the Whole Solid") : tr("Cut the Solid"),
                     std::move(fractal));
}

// The plane goes on through the point of its normal that is in the middle of the picture.
void SliceRows::turnTo(const ifs::Vector<3>& normal, const QString& text) {
    m_edit.commit();
    document::Fractal fractal = m_document->fractal();
    if (!fractal.inSpace.clip) return;
    SpaceClip& clip = *fractal.inSpace.clip;
    const double thickness = kindOf(clip) == Kind::Slice ? thicknessOf(clip) : 0;
    const auto extent = document::extentAlong(fractal, normal.normalized());
    clip.normal = normal;
    place(clip, (extent.low + extent.high) / 2, thickness);
    m_document->edit(text, std::move(fractal));
}

void SliceRows::editNormal(int axis, double value) {
    const std::optional<SpaceClip> before = m_edit.before().inSpace.clip;
    if (!before) return;
    SpaceClip turned = *before;
    turned.normal[axis] = value;
    if (!(turned.normal.norm() > 0)) return;
    const double thickness = kindOf(*before) == Kind::Slice ? thicknessOf(*before) : 0;
    place(turned, offsetOf(*before), thickness);
    if (isUsable(turned)) editClip(tr("Turn the Slice"), [&](SpaceClip& clip) { clip = turned; });
}

void SliceRows::editClip(const QString& text, const std::function<void(SpaceClip&)>& change) {
    m_edit.preview(text, [&](document::Fractal& fractal) {
        if (!fractal.inSpace.clip) return;
        SpaceClip changed = *fractal.inSpace.clip;
        change(changed);
        if (isUsable(changed)) fractal.inSpace.clip = changed;
    });
}

void SliceRows::showExtent() {
    const document::Fractal& fractal = m_document->fractal();
    const auto extent = document::extentAlong(fractal, fractal.inSpace.clip->normal.normalized());
    m_offset->setRange(extent.low, extent.high);
    m_thickness->setRange(0, extent.high - extent.low);
}

void SliceRows::follow(bool isLive) {
    const document::Fractal& fractal = m_document->fractal();
    const bool isSpace = document::space(fractal) != nullptr;
    if (!isSpace && !std::exchange(m_isShown, false)) return;
    m_isShown = isSpace;
    const std::optional<SpaceClip>& clip = fractal.inSpace.clip;
    const Kind kind = kindOf(clip);
    m_form->setRowVisible(m_kind, isSpace);
    m_form->setRowVisible(m_direction, isSpace && clip);
    m_form->setRowVisible(m_normalBox, isSpace && clip);
    m_form->setRowVisible(m_offset, isSpace && clip);
    m_form->setRowVisible(m_thickness, isSpace && kind == Kind::Slice);
    chooseValue(m_kind, kind);
    const bool isKnown = document::isSpaceExtentKnown(fractal);
    for (QWidget* row : std::initializer_list<QWidget*>{m_kind, m_direction, m_normalBox})
        row->setEnabled(isKnown);
    if (!isSpace || !clip || !isKnown) return;
    if (!isLive) showExtent();
    const auto same = std::ranges::find_if(directions, [&](const ifs::Vector<3>& direction) {
        return clip->normal.normalized().isApprox(direction.normalized(), 1e-12);
    });
    chooseValue(m_direction, SliceRows::Across(same - directions.begin()));
    for (int axis = 0; axis < 3; ++axis)
        m_normal[std::size_t(axis)]->setValue(clip->normal[axis]);
    m_offset->setValue(offsetOf(*clip));
    if (kind == Kind::Slice) m_thickness->setValue(thicknessOf(*clip));
}

} // namespace view
