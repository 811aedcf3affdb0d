// SPDX-License-Identifier: MIT
#include "transformation/family_sliders.h"

#include "ifs/tops/families.h"
#include "panels/appearance/controls/appearance_slider.h"

#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace view {

namespace {

constexpr double minParameter = 0.02, maxParameter = 0.98;

std::optional<std::vector<double>> parametersOf(const document::Fractal& fractal) {
    const document::System2* system = document::system2(fractal);
    return system ? ifs::familyParameters(ifs::mapsOf(*system)) : std::nullopt;
}

document::Fractal withParameters(document::Fractal fractal, const std::vector<double>& values) {
    const auto maps = values.size() == 3 ? ifs::triangleFamily({values[0], values[1], values[2]})
                                         : ifs::squareFamily({values[0], values[1]});
    document::System2& system = *document::system2(fractal);
    for (std::size_t i = 0; i < maps.size(); ++i)
        system.maps[i].map = maps[i];
    return fractal;
}

} // namespace

FamilySliders::FamilySliders(document::Document* document, QWidget* parent)
    : QWidget(parent), m_document(document) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    for (std::size_t k = 0; k < 3; ++k) {
        auto* name = new QLabel(this);
        auto* slider = new AppearanceSlider(tr("Parameter %1 of the family").arg(k + 1), minParameter,
                                            maxParameter, AppearanceSlider::Scale::Linear, this);
        layout->addWidget(name);
        layout->addWidget(slider, 1);
        m_rows.push_back({name, slider});
        connect(slider, &AppearanceSlider::tried, this, [this, k](double value) { tryValue(k, value); });
        connect(slider, &AppearanceSlider::accepted, this, [this] {
            if (m_gesture) m_gesture->commit();
            m_gesture.reset();
        });
        connect(slider, &AppearanceSlider::rejected, this, [this] { m_gesture.reset(); });
    }
    connect(document, &document::Document::changed, this, &FamilySliders::follow);
    follow();
}

void FamilySliders::follow() {
    const auto values = parametersOf(m_document->fractal());
    setVisible(values.has_value());
    if (!values) return;
    static const QString ofTriangle[] = {QStringLiteral("α"), QStringLiteral("β"), QStringLiteral("γ")};
    static const QString ofSquare[] = {QStringLiteral("p"), QStringLiteral("q")};
    for (std::size_t k = 0; k < m_rows.size(); ++k) {
        const bool isUsed = k < values->size();
        m_rows[k].name->setVisible(isUsed);
        m_rows[k].slider->setVisible(isUsed);
        if (!isUsed) continue;
        m_rows[k].name->setText(values->size() == 3 ? ofTriangle[k] : ofSquare[k]);
        // Rounded, because the values are computed from coefficients.
        m_rows[k].slider->setValue(QString::number((*values)[k], 'g', 15).toDouble());
    }
}

void FamilySliders::tryValue(std::size_t index, double value) {
    if (!m_gesture || !m_gesture->isOpen()) m_gesture.emplace(m_document->beginGesture(tr("Change Family")));
    auto values = parametersOf(m_gesture->before());
    if (!values || index >= values->size()) return;
    (*values)[index] = std::clamp(value, minParameter, maxParameter);
    m_gesture->preview(withParameters(m_gesture->before(), *values));
}

} // namespace view
