// SPDX-License-Identifier: MIT
#include "panels/cage_panel.h"

#include "icon.h"
#include "io/background.h"
#include "panels/number_field.h"

#include <QAction>
#include <QButtonGroup>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QShowEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <chrono>

namespace view {

namespace {

constexpr std::size_t triangle = 3;
constexpr std::chrono::milliseconds restPause{120};

QLabel* quietLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

QLabel* factLabel(const QString& name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setAccessibleName(name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

// Two buttons side by side of which one is down.
QWidget* segments(QButtonGroup* group, const std::array<QString, 2>& texts,
                  const std::array<QString, 2>& tips, QWidget* parent) {
    auto* box = new QWidget(parent);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        auto* button = new QToolButton(box);
        button->setText(texts[i]);
        button->setAccessibleName(texts[i]);
        button->setToolTip(tips[i]);
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        group->addButton(button, static_cast<int>(i));
        layout->addWidget(button);
    }
    return box;
}

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

} // namespace

CagePanel::CagePanel(document::Document* document, QWidget* parent)
    : QWidget(parent), m_document(document), m_edit(document) {
    setAccessibleName(tr("Cage"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(10);
    layout->addWidget(makeMode());
    layout->addLayout(makeButtons());
    layout->addWidget(makeDeformation());
    m_status = factLabel(tr("State of the cage"), this);
    layout->addWidget(m_status);
    m_warning = factLabel(tr("Warning about the cage"), this);
    QFont bold = m_warning->font();
    bold.setBold(true);
    m_warning->setFont(bold);
    layout->addWidget(m_warning);
    layout->addWidget(makeVertices());
    layout->addWidget(makeSimplex());
    layout->addWidget(makePoint());
    layout->addStretch();
    m_settled.setSingleShot(true);
    m_settled.setInterval(restPause);
    connect(&m_settled, &QTimer::timeout, this, &CagePanel::showSimplex);
    connect(&m_enclosing, &QFutureWatcherBase::resultReadyAt, this,
            [this](int index) { m_simplex->setText(m_enclosing.resultAt(index)); });
    connect(document, &document::Document::changed, this, &CagePanel::follow);
    showCage();
}

// A field that loses the focus while it is destroyed has nobody left to tell.
CagePanel::~CagePanel() {
    for (NumberField* field : findChildren<NumberField*>())
        field->disconnect(this);
}

QWidget* CagePanel::makeMode() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    m_mode = new QButtonGroup(this);
    layout->addWidget(segments(
        m_mode, {tr("Place"), tr("Rewrite")},
        {tr("Moving the cage moves the picture; the code stays"), tr("Moving the cage rewrites the code")},
        box));
    m_modeText = quietLabel({}, box);
    m_modeText->setWordWrap(true);
    layout->addWidget(m_modeText);
    connect(m_mode, &QButtonGroup::idClicked, this,
            [this](int id) { m_document->setCageMode(static_cast<document::CageMode>(id)); });
    connect(m_document, &document::Document::cageModeChanged, this, &CagePanel::showMode);
    return box;
}

QWidget* CagePanel::makeDeformation() {
    m_deformation = new QButtonGroup(this);
    m_deformationBox = segments(
        m_deformation, {tr("Bend"), tr("Affine fit")},
        {tr("Every vertex is followed; the picture bends, which cannot be baked into a code"),
         tr("The picture moves by the affine map that comes nearest to the vertices; it can be baked")},
        this);
    connect(m_deformation, &QButtonGroup::idClicked, this,
            [this](int id) { setDeformation(static_cast<ifs::Deformation>(id)); });
    return m_deformationBox;
}

QAbstractButton* CagePanel::modeButton(document::CageMode mode) const {
    return m_mode->button(static_cast<int>(mode));
}

QAbstractButton* CagePanel::deformationButton(ifs::Deformation deformation) const {
    return m_deformation->button(static_cast<int>(deformation));
}

QString CagePanel::warning() const {
    return m_warning->text();
}

void CagePanel::showMode() {
    const document::CageMode mode = m_document->cageMode();
    modeButton(mode)->setChecked(true);
    m_modeText->setText(modeText(m_document->fractal(), mode));
}

void CagePanel::setDeformation(ifs::Deformation deformation) {
    document::Fractal fractal = m_document->fractal();
    if (!fractal.cage || fractal.cage->deformation == deformation) return;
    fractal.cage->deformation = deformation;
    m_document->edit(deformation == ifs::Deformation::Bend ? tr("Bend the picture")
                                                           : tr("Fit the picture by an affine map"),
                     std::move(fractal));
}

QLayout* CagePanel::makeButtons() {
    m_define = new QAction(icon(QStringLiteral("define")), tr("Define…"), this);
    m_define->setToolTip(tr("Define the triangle by three clicks on the canvas; the picture stays"));
    connect(m_define, &QAction::triggered, this, &CagePanel::defineRequested);
    m_reset = new QAction(icon(QStringLiteral("reset")), tr("Reset"), this);
    connect(m_reset, &QAction::triggered, this, &CagePanel::reset);
    m_bake = new QAction(icon(QStringLiteral("bake")), tr("Bake"), this);
    connect(m_bake, &QAction::triggered, this, &CagePanel::bake);

    auto* menu = new QMenu(this);
    const auto add = [&](const QString& text, SimplexChoice choice) {
        menu->addAction(text, this, [this, choice] { fit(choice); });
    };
    add(tr("Minimal Canonical Simplex"), SimplexChoice::Minimal);
    menu->addSeparator();
    const std::array choices{SimplexChoice::PlusPlus, SimplexChoice::MinusPlus, SimplexChoice::PlusMinus,
                             SimplexChoice::MinusMinus};
    const std::array<ifs::Orientation<2>, 4> orientations{{{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (std::size_t i = 0; i < choices.size(); ++i)
        add(tr("Canonical Simplex %1").arg(orientationText(orientations[i])), choices[i]);
    menu->addSeparator();
    menu->addAction(tr("Bounding Box"), this, [this] { fit(PolygonChoice::Box); });
    const auto addPolygons = [&](const QString& title, PolygonChoice choice) {
        QMenu* polygons = menu->addMenu(title);
        for (const int corners : {3, 4, 5, 6, 8, 12, 16, 24})
            polygons->addAction(tr("%n Corners", nullptr, corners), this,
                                [this, choice, corners] { fit(choice, corners); });
    };
    addPolygons(tr("Convex Hull, Simplified to"), PolygonChoice::Hull);
    addPolygons(tr("Regular Polygon with"), PolygonChoice::Regular);

    auto* grid = new QGridLayout; // narrow in every language
    grid->setSpacing(2);
    grid->setColumnStretch(2, 1);
    const auto button = [&](QAction* action, int row, int column) {
        auto* made = new QToolButton(this);
        made->setDefaultAction(action);
        made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        made->setAutoRaise(true);
        made->setAccessibleName(action->text());
        grid->addWidget(made, row, column);
    };
    button(m_define, 0, 0);
    m_fit = new QToolButton(this);
    m_fit->setText(tr("Fit"));
    m_fit->setIcon(icon(QStringLiteral("fit-simplex")));
    m_fit->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_fit->setAccessibleName(tr("Fit the cage"));
    m_fit->setMenu(menu);
    m_fit->setPopupMode(QToolButton::InstantPopup);
    m_fit->setAutoRaise(true);
    grid->addWidget(m_fit, 0, 1);
    button(m_reset, 1, 0);
    button(m_bake, 1, 1);
    return grid;
}

QWidget* CagePanel::makeVertices() {
    auto* box = new QWidget(this);
    m_grid = new QGridLayout(box);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(6);
    m_grid->setVerticalSpacing(4);
    m_grid->addWidget(heading(tr("Vertices"), box), 0, 0, 1, 3);
    auto* toggle = new QToolButton(box);
    toggle->setText(tr("Rest cage"));
    toggle->setToolTip(tr("Show the vertices that hold the attractor while the cage is at rest"));
    toggle->setAccessibleName(tr("Show the rest cage"));
    toggle->setCheckable(true);
    toggle->setAutoRaise(true);
    connect(toggle, &QToolButton::toggled, this, &CagePanel::showRest);
    m_grid->addWidget(toggle, 0, 3, 1, 2, Qt::AlignRight);
    const std::array names{tr("x"), tr("y"), tr("x at rest"), tr("y at rest")};
    for (int column = 0; column < 4; ++column) {
        auto* label = quietLabel(names[static_cast<std::size_t>(column)], box);
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(label, 1, column + 1);
        m_grid->setColumnStretch(column + 1, 1);
        if (column >= 2) m_restWidgets.push_back(label);
    }
    return box;
}

QWidget* CagePanel::makeSimplex() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* title = heading(tr("Minimal canonical simplex"), box);
    title->setToolTip(
        tr("The smallest isosceles right triangle with legs parallel to the axes that contains the "
           "picture. The signs say to which side its legs point from the right angle."));
    layout->addWidget(title);
    m_simplex = factLabel(tr("Minimal canonical simplex"), box);
    layout->addWidget(m_simplex);
    return box;
}

QWidget* CagePanel::makePoint() {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    auto* title = heading(tr("Barycentric coordinates of a point"), box);
    title->setToolTip(
        tr("The weights a, b, c with a + b + c = 1 that the vertices take to balance in the point."));
    grid->addWidget(title, 0, 0, 1, 4);
    m_pointX = new NumberField(box);
    m_pointX->setAccessibleName(tr("x of the point"));
    m_pointY = new NumberField(box);
    m_pointY->setAccessibleName(tr("y of the point"));
    grid->addWidget(quietLabel(tr("x"), box), 1, 0);
    grid->addWidget(m_pointX, 1, 1);
    grid->addWidget(quietLabel(tr("y"), box), 1, 2);
    grid->addWidget(m_pointY, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    m_barycentric = factLabel(tr("Barycentric coordinates"), box);
    grid->addWidget(m_barycentric, 2, 0, 1, 4);
    for (NumberField* field : {m_pointX, m_pointY})
        connect(field, &NumberField::edited, this, &CagePanel::showPoint);
    return box;
}

NumberField* CagePanel::vertexField(Vertices vertices, std::size_t vertex, int axis) {
    auto* field = new NumberField(m_grid->parentWidget());
    const QString name = axis == 0 ? tr("x") : tr("y");
    field->setAccessibleName(vertices == Vertices::Current
                                 ? tr("%1 of vertex %2").arg(name).arg(vertex + 1)
                                 : tr("%1 of rest vertex %2").arg(name).arg(vertex + 1));
    connect(field, &NumberField::edited, this, [=, this](double value) {
        if (vertices == Vertices::Current)
            editCurrent(vertex, axis, value);
        else
            editRest(vertex, axis, value);
    });
    connect(field, &NumberField::committed, this, [this] {
        m_edit.commit();
        showCage();
    });
    connect(field, &NumberField::cancelled, this, [this] { m_edit.cancel(); });
    return field;
}

void CagePanel::addRow() {
    const std::size_t vertex = m_rows.size();
    const int line = static_cast<int>(vertex) + 2;
    VertexRow row{quietLabel(QString::number(vertex + 1), m_grid->parentWidget()), {}, {}};
    m_grid->addWidget(row.number, line, 0);
    for (int axis = 0; axis < 2; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        row.current[at] = vertexField(Vertices::Current, vertex, axis);
        row.rest[at] = vertexField(Vertices::Rest, vertex, axis);
        m_grid->addWidget(row.current[at], line, 1 + axis);
        m_grid->addWidget(row.rest[at], line, 3 + axis);
    }
    m_rows.push_back(row);
}

NumberField* CagePanel::field(Vertices vertices, std::size_t vertex, int axis) const {
    const VertexRow& row = m_rows.at(vertex);
    const auto at = static_cast<std::size_t>(axis);
    return vertices == Vertices::Current ? row.current[at] : row.rest[at];
}

void CagePanel::showRest(bool shown) {
    m_restShown = shown;
    showCage();
}

void CagePanel::editCurrent(std::size_t vertex, int axis, double value) {
    m_edit.preview(tr("Move vertex %1").arg(vertex + 1), [&](document::Fractal& fractal) {
        auto cage = document::effectiveCage(fractal);
        cage.current.at(vertex)[axis] = value;
        fractal = withCageMoved(std::move(fractal), std::move(cage), m_document->cageMode());
    });
}

void CagePanel::editRest(std::size_t vertex, int axis, double value) {
    auto cage = document::effectiveCage(m_edit.before());
    const auto placement = ifs::displayMap(cage);
    cage.rest.at(vertex)[axis] = value;
    if (!ifs::isValid(cage)) {
        emit message(cage.rest.size() == triangle
                         ? tr("The three points are on one line: the rest cage must enclose an area.")
                         : tr("The rest cage must be a polygon that does not cross itself."));
        return;
    }
    // The picture stays; only the points by which it is held are others.
    cage.current[vertex] = placement(cage.rest[vertex]);
    m_edit.preview(tr("Define vertex %1").arg(vertex + 1),
                   [&](document::Fractal& fractal) { fractal.cage = cage; });
}

void CagePanel::fit(SimplexChoice choice) {
    auto fitted = withCageFitted(m_document->fractal(), choice);
    const QString obstacle = fitted ? QString() : fitObstacle(m_document->fractal());
    fitTo(std::move(fitted), obstacle);
}

void CagePanel::fit(PolygonChoice choice, int corners) {
    const QString obstacle = fitObstacle(m_document->fractal());
    auto fitted = obstacle.isEmpty() ? withCageAround(m_document->fractal(), choice, corners) : std::nullopt;
    fitTo(std::move(fitted), obstacle.isEmpty() ? tr("The picture is too thin for such a cage.") : obstacle);
}

void CagePanel::fitTo(std::optional<document::Fractal> fitted, const QString& obstacle) {
    if (!fitted)
        emit message(obstacle);
    else if (isCageAlike(m_document->fractal(), *fitted))
        emit message(tr("The cage is there already."));
    else
        m_document->edit(tr("Fit the cage"), *std::move(fitted));
}

void CagePanel::reset() {
    m_document->edit(tr("Reset the cage"), withCageAtRest(m_document->fractal()));
}

void CagePanel::bake() {
    if (auto after = baked(m_document->fractal()))
        m_document->edit(tr("Bake the cage into the code"), std::move(*after));
    else
        emit message(bakeObstacle(m_document->fractal()));
}

void CagePanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showCage();
}

void CagePanel::follow(const document::Change& change) {
    using document::Change;
    if (isVisible() &&
        change.parts & (Change::System | Change::Cage | Change::Entries | Change::Current | Change::File))
        showCage();
}

void CagePanel::showCage() {
    const document::Fractal& fractal = m_document->fractal();
    const bool plane = document::dimension(fractal) == 2;
    setEnabled(plane);
    m_cage = plane ? document::effectiveCage(fractal) : ifs::ControlCage<2>{};
    while (m_rows.size() < m_cage.current.size())
        addRow();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const bool used = i < m_cage.current.size();
        m_rows[i].number->setVisible(used);
        for (int axis = 0; axis < 2; ++axis) {
            NumberField* current = field(Vertices::Current, i, axis);
            NumberField* rest = field(Vertices::Rest, i, axis);
            current->setVisible(used);
            rest->setVisible(used && m_restShown);
            rest->setReadOnly(ifs::bends(m_cage));
            if (used) {
                current->setValue(m_cage.current[i][axis]);
                rest->setValue(m_cage.rest[i][axis]);
            }
        }
    }
    for (QWidget* widget : m_restWidgets)
        widget->setVisible(m_restShown);
    m_status->setText(status());
    m_deformationBox->setVisible(m_cage.current.size() > triangle);
    deformationButton(m_cage.deformation)->setChecked(true);
    m_warning->setText(plane ? cageWarning(fractal) : QString());
    m_warning->setVisible(!m_warning->text().isEmpty());
    showMode();
    updateActions();
    showPoint();
    m_settled.start();
}

QString CagePanel::status() const {
    const document::Fractal& fractal = m_document->fractal();
    if (document::dimension(fractal) == 3) return tr("3D: not yet shown.");
    if (document::dimension(fractal) == 0) return tr("This entry could not be read, so it has no cage.");
    const std::size_t count = m_cage.current.size();
    if (isAtRest(fractal))
        return count == triangle ? tr("At rest: the picture is that of the code.")
                                 : tr("%1 vertices, at rest: the picture is that of the code.").arg(count);
    if (ifs::bends(m_cage)) {
        const bool smooth =
            document::placement(fractal).bend()->coordinates() == ifs::Coordinates::Wachspress;
        return smooth ? tr("%1 vertices: bent by Wachspress coordinates, not bakeable.").arg(count)
                      : tr("%1 vertices: bent by mean value coordinates, not bakeable.").arg(count);
    }
    if (!ifs::isInvertible(m_cage))
        return tr("Flat: the picture lies on one line. Open the cage and it comes back.");
    const double factor = ifs::determinant<2>(ifs::displayMap(m_cage).linear);
    return factor < 0 ? tr("Placed and mirrored: areas change by the factor %1, and the sense of rotation is "
                           "reversed.")
                            .arg(shortNumber(-factor))
                      : tr("Placed: areas change by the factor %1.").arg(shortNumber(factor));
}

QString CagePanel::barycentric() const {
    return m_barycentric->text();
}

void CagePanel::showPoint() {
    if (m_cage.current.size() != triangle) {
        m_barycentric->setText(m_cage.current.empty() ? QString()
                                                      : tr("The coordinates are read over a triangle."));
        return;
    }
    const ifs::Simplex<2> simplex{m_cage.current[0], m_cage.current[1], m_cage.current[2]};
    if (!ifs::isAffineBasis<2>(simplex)) {
        m_barycentric->setText(tr("The triangle is flat: it holds no coordinates."));
        return;
    }
    const auto weights = ifs::barycentric<2>(simplex, {m_pointX->value(), m_pointY->value()});
    m_barycentric->setText(
        QStringLiteral("(%1, %2, %3)")
            .arg(shortNumber(weights[0]), shortNumber(weights[1]), shortNumber(weights[2])));
}

void CagePanel::showSimplex() {
    if (QGuiApplication::mouseButtons() != Qt::NoButton) return m_settled.start(); // still held
    if (!isVisible()) return;
    m_enclosing.cancel();
    m_enclosing.setFuture(io::inBackground<QString>([fractal = m_document->currentEntry().fractal](
                                                        QPromise<QString>& text) {
        const auto simplex = displayedSimplex(*fractal, SimplexChoice::Minimal);
        text.addResult(simplex ? tr("%1, leg %2, corner (%3, %4)")
                                     .arg(orientationText(simplex->orientation), shortNumber(simplex->leg),
                                          shortNumber(simplex->vertices[0].x()),
                                          shortNumber(simplex->vertices[0].y()))
                               : fitObstacle(*fractal));
    }));
}

void CagePanel::updateActions() {
    const document::Fractal& fractal = m_document->fractal();
    const bool plane = document::dimension(fractal) == 2;
    m_define->setEnabled(plane);
    m_fit->setEnabled(plane);
    m_fit->setToolTip(tr("Hold the picture by a fitted cage; the picture stays"));
    const QString nothingToReset = resetObstacle(fractal);
    m_reset->setEnabled(nothingToReset.isEmpty());
    m_reset->setToolTip(nothingToReset.isEmpty() ? tr("Put the cage and the picture back to rest")
                                                 : nothingToReset);
    const QString obstacle = bakeObstacle(fractal);
    m_bake->setEnabled(obstacle.isEmpty());
    m_bake->setToolTip(obstacle.isEmpty() ? tr("Make the displayed picture the code; the cage then rests")
                                          : obstacle);
}

} // namespace view
