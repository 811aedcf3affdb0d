// SPDX-License-Identifier: MIT
#include "panels/cage/cage_panel.h"

#include "document/edits/cage/cage_actions.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "io/file/background.h"
#include "panels/cage/cage_texts.h"
#include "panels/cage/fit_menu.h"
#include "widgets/icon.h"
#include "widgets/numbers/number_field.h"

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
#include <utility>

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
    : QWidget(parent), m_document(document), m_edit(document), m_fitter(document) {
    setAccessibleName(tr("Cage"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(10);
    m_modeBox = makeMode();
    layout->addWidget(m_modeBox);
    layout->addLayout(makeButtons());
    layout->addWidget(makeDeformation());
    layout->addWidget(makeVertices());
    m_status = factLabel(tr("State of the cage"), this); // below the fields, so that these keep their places
    layout->addWidget(m_status);
    m_warning = factLabel(tr("Warning about the cage"), this);
    QFont bold = m_warning->font();
    bold.setBold(true);
    m_warning->setFont(bold);
    layout->addWidget(m_warning);
    layout->addWidget(makeSimplex());
    layout->addWidget(makePoint());
    layout->addStretch();
    m_settled.setSingleShot(true);
    m_settled.setInterval(restPause);
    connect(&m_settled, &QTimer::timeout, this, &CagePanel::showSimplex);
    connect(&m_enclosing, &QFutureWatcherBase::resultReadyAt, this,
            [this](int index) { m_simplex->setText(m_enclosing.resultAt(index)); });
    connect(&m_fitter, &CageFitter::message, this, &CagePanel::message);
    m_following = connect(document, &document::Document::changed, this, &CagePanel::follow);
    showCage();
}

// A field that loses the focus while it is destroyed has no receiver left, and neither has the document when
// typing ends there.
CagePanel::~CagePanel() {
    disconnect(m_following);
    for (NumberField* field : findChildren<NumberField*>())
        field->disconnect(this);
}

QWidget* CagePanel::makeMode() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    m_mode = new QButtonGroup(this);
    layout->addWidget(segments(m_mode, {tr("Place"), tr("Rewrite")},
                               {tr("Moving the cage moves the picture; the code does not change"),
                                tr("Moving the cage rewrites the code")},
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
        {tr("The picture follows every vertex and bends; a bent picture cannot be baked into the code"),
         tr("The picture follows the vertices by the closest affine map; it can be baked")},
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
    const auto change = [deformation](auto* shape) {
        if (!shape || !shape->cage || shape->cage->deformation == deformation) return false;
        shape->cage->deformation = deformation;
        return true;
    };
    if (!change(document::plane(fractal)) && !change(document::space(fractal))) return;
    m_document->edit(deformation == ifs::Deformation::Bend ? tr("Bend the picture")
                                                           : tr("Fit the picture by an affine map"),
                     std::move(fractal));
}

QLayout* CagePanel::makeButtons() {
    m_define = new QAction(icon(QStringLiteral("define")), tr("Define…"), this);
    connect(m_define, &QAction::triggered, this, &CagePanel::defineRequested);
    m_reset = new QAction(icon(QStringLiteral("reset")), tr("Reset"), this);
    connect(m_reset, &QAction::triggered, this, &CagePanel::reset);
    m_bake = new QAction(icon(QStringLiteral("bake")), tr("Bake"), this);
    connect(m_bake, &QAction::triggered, this, &CagePanel::bake);

    m_define->setObjectName(QStringLiteral("define"));
    m_reset->setObjectName(QStringLiteral("reset"));
    m_bake->setObjectName(QStringLiteral("bake"));

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
    auto* top = new QWidget(box);
    m_verticesTitle = heading(tr("Vertices"), top);
    m_restToggle = new QToolButton(top);
    m_restToggle->setText(tr("Rest cage"));
    m_restToggle->setToolTip(tr("Show the positions of the vertices when the cage is at rest"));
    m_restToggle->setAccessibleName(tr("Show the rest cage"));
    m_restToggle->setCheckable(true);
    m_restToggle->setAutoRaise(true);
    connect(m_restToggle, &QToolButton::toggled, this, &CagePanel::showRest);
    auto* topLayout = new QHBoxLayout(top);
    topLayout->setContentsMargins(0, 0, 0, 0);
    topLayout->addWidget(m_verticesTitle, 1);
    topLayout->addWidget(m_restToggle);
    const auto name = [box](const QString& text) {
        auto* label = quietLabel(text, box);
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        return label;
    };
    m_names = {name(tr("x")), name(tr("y")), name(tr("z"))};
    m_restNames = {name(tr("x at rest")), name(tr("y at rest")), name(tr("z at rest"))};
    return box;
}

void CagePanel::followDimension() {
    if (m_arrangedFor == dimension()) return;
    m_arrangedFor = dimension();
    arrange();
    const bool isPlane = m_arrangedFor == 2;
    delete m_fit->menu();
    const PlaneFits inPlane{[this](document::SimplexChoice choice) { fit(choice); },
                            [this](document::PolygonChoice choice, int corners) { fit(choice, corners); }};
    const SpaceFits inSpace{
        [this](const std::optional<ifs::Orientation<3>>& orientation) { fitTetrahedron(orientation); },
        [this] { fitBox(); },
        [this](document::SpacePolyhedron choice, int corners) { fitPolyhedron(choice, corners); }};
    m_fit->setMenu(isPlane ? makeFitMenu(this, inPlane) : makeFitMenu(this, inSpace));
    m_pointZName->setVisible(!isPlane);
    m_point[2]->setVisible(!isPlane);
    static_cast<QGridLayout*>(m_point[2]->parentWidget()->layout())->setColumnStretch(5, isPlane ? 0 : 1);
    m_simplexTitle->setToolTip(
        isPlane
            ? tr("The smallest isosceles right triangle with legs parallel to the axes that contains the "
                 "picture. The signs give the directions in which its legs point from the right angle.")
            : tr("The smallest tetrahedron with three equal legs parallel to the axes that contains the "
                 "picture. The signs give the directions in which its legs point from their common corner."));
    m_pointTitle->setToolTip(
        isPlane ? tr("The weights a, b, c with a + b + c = 1 for which the point is the weighted mean of the "
                     "vertices.")
                : tr("The weights a, b, c, d with a + b + c + d = 1 for which the point is the weighted mean "
                     "of the vertices."));
}

// The plane has two columns for the vertices and two for those at rest, space has three and three.
void CagePanel::arrange() {
    const int axes = m_arrangedFor;
    const auto put = [this](QWidget* widget, int column) {
        m_grid->removeWidget(widget);
        m_grid->addWidget(widget, 1, column);
    };
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        const bool used = axis < axes;
        m_names[at]->setVisible(used);
        if (used) {
            put(m_names[at], 1 + axis);
            put(m_restNames[at], 1 + axes + axis);
        }
    }
    stretchColumns();
    for (std::size_t vertex = 0; vertex < m_rows.size(); ++vertex)
        arrangeRow(vertex);
}

// Columns that are shown share the width.
void CagePanel::stretchColumns() {
    const int shown = m_restShown ? 2 * m_arrangedFor : m_arrangedFor;
    for (int column = 1; column <= 6; ++column)
        m_grid->setColumnStretch(column, column <= shown ? 1 : 0);
    QWidget* top = m_restToggle->parentWidget();
    m_grid->removeWidget(top);
    m_grid->addWidget(top, 0, 0, 1, 1 + shown);
}

QWidget* CagePanel::makeSimplex() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    m_simplexTitle = heading(tr("Minimal canonical simplex"), box);
    layout->addWidget(m_simplexTitle);
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
    m_pointTitle = heading(tr("Barycentric coordinates of a point"), box);
    grid->addWidget(m_pointTitle, 0, 0, 1, 4);
    const std::array names{tr("x of the point"), tr("y of the point"), tr("z of the point")};
    const std::array letters{tr("x"), tr("y"), tr("z")};
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        m_point[at] = new NumberField(box);
        m_point[at]->setAccessibleName(names[at]);
        connect(m_point[at], &NumberField::edited, this, &CagePanel::showPoint);
        auto* letter = quietLabel(letters[at], box);
        grid->addWidget(letter, 1, 2 * axis);
        grid->addWidget(m_point[at], 1, 2 * axis + 1);
        if (axis == 2) m_pointZName = letter;
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    m_barycentric = factLabel(tr("Barycentric coordinates"), box);
    grid->addWidget(m_barycentric, 2, 0, 1, 4);
    return box;
}

NumberField* CagePanel::vertexField(Vertices vertices, std::size_t vertex, int axis) {
    auto* field = new NumberField(m_grid->parentWidget());
    const QString name = axis == 0 ? tr("x") : axis == 1 ? tr("y") : tr("z");
    field->setAccessibleName(vertices == Vertices::Current
                                 ? tr("%1 of vertex %2").arg(name).arg(vertex + 1)
                                 : tr("%1 of rest vertex %2").arg(name).arg(vertex + 1));
    connect(field, &NumberField::edited, this, [=, this](double value) {
        if (vertices == Vertices::Current)
            editCurrent(vertex, axis, value);
        else
            editRest(vertex, axis, value);
    });
    const QString place = placeOf(vertices, vertex, axis);
    connect(field, &NumberField::committed, this, [this, field, place] {
        if (m_edit.isOpen())
            m_document->typedNumbers().keep(m_document->currentId(), place, field->value(),
                                            field->typedText());
        m_edit.commit();
        showCage();
    });
    connect(field, &NumberField::cancelled, this, [this] { m_edit.cancel(); });
    return field;
}

void CagePanel::addRow() {
    const std::size_t vertex = m_rows.size();
    VertexRow row{quietLabel(QString::number(vertex + 1), m_grid->parentWidget()), {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        row.current[at] = vertexField(Vertices::Current, vertex, axis);
        row.rest[at] = vertexField(Vertices::Rest, vertex, axis);
    }
    m_grid->addWidget(row.number, static_cast<int>(vertex) + 2, 0);
    m_rows.push_back(row);
    arrangeRow(vertex);
}

void CagePanel::arrangeRow(std::size_t vertex) {
    const int line = static_cast<int>(vertex) + 2;
    for (int axis = 0; axis < 3; ++axis) {
        NumberField* current = field(Vertices::Current, vertex, axis);
        NumberField* rest = field(Vertices::Rest, vertex, axis);
        m_grid->removeWidget(current);
        m_grid->removeWidget(rest);
        current->setVisible(false); // hidden until it is shown with its vertex
        rest->setVisible(false);
        if (axis >= m_arrangedFor) continue;
        m_grid->addWidget(current, line, 1 + axis);
        m_grid->addWidget(rest, line, 1 + m_arrangedFor + axis);
    }
}

NumberField* CagePanel::field(Vertices vertices, std::size_t vertex, int axis) const {
    const VertexRow& row = m_rows.at(vertex);
    const auto at = static_cast<std::size_t>(axis);
    return vertices == Vertices::Current ? row.current[at] : row.rest[at];
}

void CagePanel::showRest(bool shown) {
    m_restShown = shown;
    stretchColumns();
    showCage();
}

void CagePanel::editCurrent(std::size_t vertex, int axis, double value) {
    if (const QString obstacle = moveCageObstacle(*m_document); !obstacle.isEmpty()) {
        emit message(obstacle);
        return showCage();
    }
    if (auto cage = document::spaceCage(m_edit.before()))
        editCurrent<3>(*std::move(cage), vertex, axis, value);
    else
        editCurrent<2>(document::effectiveCage(m_edit.before()), vertex, axis, value);
}

template <int Dim>
void CagePanel::editCurrent(ifs::ControlCage<Dim> cage, std::size_t vertex, int axis, double value) {
    cage.current.at(vertex)[axis] = value;
    const QString pattern =
        Dim == 3 ? tr("Move vertex %1 to (%2, %3, %4)") : tr("Move vertex %1 to (%2, %3)");
    m_edit.preview(stepText<Dim>(pattern, vertex, cage.current[vertex]), [&](document::Fractal& fractal) {
        fractal = withCageMoved(std::move(fractal), cage, m_document->cageMode());
    });
}

void CagePanel::editRest(std::size_t vertex, int axis, double value) {
    if (auto cage = document::spaceCage(m_edit.before()))
        editRest<3>(*std::move(cage), vertex, axis, value);
    else
        editRest<2>(document::effectiveCage(m_edit.before()), vertex, axis, value);
}

template <int Dim>
void CagePanel::editRest(ifs::ControlCage<Dim> cage, std::size_t vertex, int axis, double value) {
    const auto placement = ifs::displayMap(cage);
    cage.rest.at(vertex)[axis] = value;
    if (!ifs::isValid(cage)) {
        emit message(Dim == 3 ? tr("The vertices are in one plane: the rest cage must enclose a volume.")
                     : cage.rest.size() == triangle
                         ? tr("The three points are on one line: the rest cage must enclose an area.")
                         : tr("The rest cage must be a polygon that does not cross itself."));
        return;
    }
    // Keeps the picture, and moves only the corners that hold it.
    cage.current[vertex] = placement(cage.rest[vertex]);
    const QString pattern =
        Dim == 3 ? tr("Define vertex %1 at (%2, %3, %4)") : tr("Define vertex %1 at (%2, %3)");
    m_edit.preview(stepText<Dim>(pattern, vertex, cage.rest[vertex]), [&](document::Fractal& fractal) {
        std::get<document::Shape<Dim>>(fractal.shape).cage = cage;
    });
}

void CagePanel::reset() {
    m_document->edit(tr("Reset the cage"), withCageAtRest(m_document->fractal()));
}

void CagePanel::bake() {
    if (const QString obstacle = bakeObstacle(*m_document); !obstacle.isEmpty())
        emit message(obstacle);
    else if (auto after = baked(m_document->fractal()))
        m_document->edit(tr("Bake the cage into the code"), std::move(*after));
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

QString CagePanel::placeOf(Vertices vertices, std::size_t vertex, int axis) {
    return QStringLiteral("vertex %1 %2 %3").arg(int(vertices)).arg(vertex).arg(axis);
}

void CagePanel::showNumber(NumberField* field, const QString& place, double value) {
    field->setValue(value, m_document->typedNumbers().text(m_document->currentId(), place, value));
}

void CagePanel::showCage() {
    const document::Fractal& fractal = m_document->fractal();
    const bool plane = document::dimension(fractal) == 2;
    setEnabled(document::dimension(fractal) != 0);
    if (document::space(fractal)) // not yet known for very many maps
        m_cage = document::knownSpaceCage(fractal).value_or(ifs::ControlCage<3>{});
    else
        m_cage = plane ? document::effectiveCage(fractal) : ifs::ControlCage<2>{};
    followDimension();
    while (m_rows.size() < vertexCount())
        addRow();
    std::visit([this](const auto& cage) { showVertices(cage); }, m_cage);
    for (std::size_t axis = 0; axis < m_restNames.size(); ++axis)
        m_restNames[axis]->setVisible(m_restShown && int(axis) < dimension());
    m_status->setText(status());
    m_deformationBox->setVisible(vertexCount() > std::size_t(dimension()) + 1);
    std::visit([this](const auto& cage) { deformationButton(cage.deformation)->setChecked(true); }, m_cage);
    m_warning->setText(plane ? cageWarning(fractal) : QString());
    m_warning->setVisible(!m_warning->text().isEmpty());
    showMode();
    updateActions();
    showPoint();
    m_settled.start();
}

std::size_t CagePanel::vertexCount() const {
    return std::visit([](const auto& cage) { return cage.current.size(); }, m_cage);
}

bool CagePanel::isCageKnown() const {
    return dimension() == 2 || vertexCount() > 0;
}

template <int Dim> void CagePanel::showVertices(const ifs::ControlCage<Dim>& cage) {
    const double rounding = roundingIn(cage);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const bool used = i < cage.current.size();
        m_rows[i].number->setVisible(used);
        for (int axis = 0; axis < Dim; ++axis) {
            NumberField* current = field(Vertices::Current, i, axis);
            NumberField* rest = field(Vertices::Rest, i, axis);
            current->setVisible(used);
            rest->setVisible(used && m_restShown);
            rest->setReadOnly(ifs::bends(cage));
            if (used) {
                current->setRounding(rounding);
                rest->setRounding(rounding);
                showNumber(current, placeOf(Vertices::Current, i, axis), cage.current[i][axis]);
                showNumber(rest, placeOf(Vertices::Rest, i, axis), cage.rest[i][axis]);
            }
        }
    }
}

QString CagePanel::status() const {
    const document::Fractal& fractal = m_document->fractal();
    if (document::dimension(fractal) == 0) return tr("This entry could not be read, so it has no cage.");
    if (!isCageKnown()) return tr("The system has very many maps. Computing the cage around it…");
    return std::visit([&](const auto& cage) { return cageStatus(fractal, cage); }, m_cage);
}

QString CagePanel::barycentric() const {
    return m_barycentric->text();
}

void CagePanel::showPoint() {
    const auto text = [this]<int Dim>(const ifs::ControlCage<Dim>& cage) {
        ifs::Vector<Dim> point;
        for (int axis = 0; axis < Dim; ++axis)
            point[axis] = pointField(axis)->value();
        return barycentricText(cage, point);
    };
    m_barycentric->setText(std::visit(text, m_cage));
}

void CagePanel::showSimplex() {
    if (QGuiApplication::mouseButtons() != Qt::NoButton) return m_settled.start(); // drag not ended
    if (!isVisible()) return;
    m_enclosing.cancel();
    m_enclosing.setFuture(
        io::inBackground<QString>([fractal = m_document->sharedFractal()](QPromise<QString>& text) {
            text.addResult(enclosingSimplexText(*fractal));
        }));
}

void CagePanel::updateActions() {
    const document::Fractal& fractal = m_document->fractal();
    const bool isSpace = document::dimension(fractal) == 3;
    m_define->setEnabled(document::dimension(fractal) != 0);
    m_define->setToolTip(isSpace
                             ? tr("Define the tetrahedron with four clicks on the canvas; the picture stays")
                             : tr("Define the triangle with three clicks on the canvas; the picture stays"));
    m_fit->setEnabled(document::dimension(fractal) != 0 && isCageKnown());
    m_fit->setToolTip(tr("Replace the cage by one fitted to the picture; the picture stays"));
    const QString nothingToReset = resetObstacle(fractal);
    m_reset->setEnabled(nothingToReset.isEmpty());
    m_reset->setToolTip(nothingToReset.isEmpty() ? tr("Return the cage and the picture to rest")
                                                 : nothingToReset);
    const QString obstacle = bakeObstacle(*m_document);
    m_bake->setEnabled(obstacle.isEmpty());
    m_bake->setToolTip(obstacle.isEmpty()
                           ? tr("Write the displayed picture into the code; the cage is then at rest")
                           : obstacle);
}

} // namespace view
