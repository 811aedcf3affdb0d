// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/cage/cage_edits.h"
#include "document/edits/live_edit.h"
#include "panels/cage/cage_fitter.h"

#include <QFutureWatcher>
#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>
#include <variant>
#include <vector>

class QAbstractButton;
class QAction;
class QButtonGroup;
class QGridLayout;
class QLabel;
class QLayout;
class QToolButton;

namespace view {

class NumberField;

// The control cage in numbers: its vertices, its effect on the picture, and the commands to fit, reset and
// bake it.
class CagePanel : public QWidget {
    Q_OBJECT

public:
    explicit CagePanel(document::Document* document, QWidget* parent = nullptr);
    ~CagePanel() override;

    enum class Vertices { Current, Rest };
    NumberField* field(Vertices vertices, std::size_t vertex, int axis) const;
    QString status() const;      // sentence: at rest, placed, mirrored or flat
    QString barycentric() const; // coordinates of the point typed in the panel

    void fit(document::SimplexChoice choice) { m_fitter.fit(choice); }
    void fit(document::PolygonChoice choice, int corners = 4) { m_fitter.fit(choice, corners); }
    void fitTetrahedron(const std::optional<ifs::Orientation<3>>& orientation = {}) {
        m_fitter.fitTetrahedron(orientation);
    }
    void fitBox() { m_fitter.fitBox(); }
    void fitPolyhedron(document::SpacePolyhedron choice, int corners) {
        m_fitter.fitPolyhedron(choice, corners);
    }
    void setDeformation(ifs::Deformation deformation);
    void reset();
    void bake();
    QAction* bakeAction() const { return m_bake; }
    QAbstractButton* modeButton(document::CageMode mode) const;
    QAbstractButton* deformationButton(ifs::Deformation deformation) const;
    QString warning() const; // warning about a concave or folded cage; empty: none
    NumberField* pointField(int axis) const { return m_point.at(static_cast<std::size_t>(axis)); }

signals:
    void defineRequested(); // sent to define a cage with three clicks on the canvas
    void message(const QString& text);

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct VertexRow {
        QLabel* number;
        std::array<NumberField*, 3> current;
        std::array<NumberField*, 3> rest;
    };
    using Cage = std::variant<ifs::ControlCage<2>, ifs::ControlCage<3>>;
    QWidget* makeVertices();
    QLayout* makeButtons();
    QWidget* makeMode();
    QWidget* makeDeformation();
    QWidget* makeSimplex();
    QWidget* makePoint();
    void addRow();
    static QString placeOf(Vertices vertices, std::size_t vertex, int axis);
    void showNumber(NumberField* field, const QString& place, double value);
    void followDimension();
    void arrange();
    void stretchColumns();
    void arrangeRow(std::size_t vertex);
    int dimension() const { return m_cage.index() == 0 ? 2 : 3; } // dimension of the cage shown
    std::size_t vertexCount() const;
    bool isCageKnown() const;
    template <int Dim> void showVertices(const ifs::ControlCage<Dim>& cage);
    NumberField* vertexField(Vertices vertices, std::size_t vertex, int axis);
    void editCurrent(std::size_t vertex, int axis, double value);
    template <int Dim>
    void editCurrent(ifs::ControlCage<Dim> cage, std::size_t vertex, int axis, double value);
    void editRest(std::size_t vertex, int axis, double value);
    template <int Dim> void editRest(ifs::ControlCage<Dim> cage, std::size_t vertex, int axis, double value);
    void follow(const document::Change& change);
    void showCage();
    void showPoint();
    void showSimplex();
    void showMode();
    void updateActions();
    void showRest(bool shown);

    document::Document* m_document;
    document::LiveEdit m_edit;
    CageFitter m_fitter;
    QMetaObject::Connection m_following; // connection to the document
    Cage m_cage;                         // cage as shown
    int m_arrangedFor = 0;               // dimension for which the fields are arranged
    QGridLayout* m_grid = nullptr;
    QLabel* m_verticesTitle = nullptr;
    QToolButton* m_restToggle = nullptr;
    std::array<QLabel*, 3> m_names{}; // labels above the columns
    std::array<QLabel*, 3> m_restNames{};
    std::vector<VertexRow> m_rows;
    bool m_restShown = false;
    QWidget* m_modeBox = nullptr;
    QButtonGroup* m_mode = nullptr;
    QLabel* m_modeText = nullptr;
    QWidget* m_deformationBox = nullptr;
    QButtonGroup* m_deformation = nullptr;
    QLabel* m_status = nullptr;
    QLabel* m_warning = nullptr;
    QLabel* m_simplexTitle = nullptr;
    QLabel* m_simplex = nullptr;
    QLabel* m_pointTitle = nullptr;
    QLabel* m_barycentric = nullptr;
    std::array<NumberField*, 3> m_point{};
    QLabel* m_pointZName = nullptr;
    QAction* m_define = nullptr;
    QAction* m_reset = nullptr;
    QAction* m_bake = nullptr;
    QToolButton* m_fit = nullptr;
    QTimer m_settled;                    // delays the computation of the simplex during a drag
    QFutureWatcher<QString> m_enclosing; // background computation of the simplex
};

} // namespace view
