// SPDX-License-Identifier: MIT
#pragma once

#include "cage_edits.h"
#include "panels/live_edit.h"

#include <QFutureWatcher>
#include <QTimer>
#include <QWidget>

#include <array>
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

// The control cage in numbers: its vertices, what it does to the picture, and how it is fitted, reset and
// baked.
class CagePanel : public QWidget {
    Q_OBJECT

public:
    explicit CagePanel(document::Document* document, QWidget* parent = nullptr);
    ~CagePanel() override;

    enum class Vertices { Current, Rest };
    NumberField* field(Vertices vertices, std::size_t vertex, int axis) const;
    QString status() const;      // at rest, placed, mirrored or flat, as a sentence
    QString barycentric() const; // of the point typed in the panel

    void fit(SimplexChoice choice);
    void fit(PolygonChoice choice, int corners = 4);
    void setDeformation(ifs::Deformation deformation);
    void reset();
    void bake();
    QAction* bakeAction() const { return m_bake; }
    QAbstractButton* modeButton(document::CageMode mode) const;
    QAbstractButton* deformationButton(ifs::Deformation deformation) const;
    QString warning() const; // of a cage that is concave or folded; empty when it is sound
    NumberField* pointField(int axis) const { return axis == 0 ? m_pointX : m_pointY; }

signals:
    void defineRequested(); // by three clicks on the canvas
    void message(const QString& text);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void fitTo(std::optional<document::Fractal> fitted, const QString& obstacle); // nullopt: says why
    struct VertexRow {
        QLabel* number;
        std::array<NumberField*, 2> current;
        std::array<NumberField*, 2> rest;
    };
    QWidget* makeVertices();
    QLayout* makeButtons();
    QWidget* makeMode();
    QWidget* makeDeformation();
    QWidget* makeSimplex();
    QWidget* makePoint();
    void addRow();
    NumberField* vertexField(Vertices vertices, std::size_t vertex, int axis);
    void editCurrent(std::size_t vertex, int axis, double value);
    void editRest(std::size_t vertex, int axis, double value);
    void follow(const document::Change& change);
    void showCage();
    void showPoint();
    void showSimplex();
    void showMode();
    void updateActions();
    void showRest(bool shown);

    document::Document* m_document;
    LiveEdit m_edit;
    ifs::ControlCage<2> m_cage; // as shown
    QGridLayout* m_grid = nullptr;
    std::vector<VertexRow> m_rows;
    std::vector<QWidget*> m_restWidgets;
    bool m_restShown = false;
    QButtonGroup* m_mode = nullptr;
    QLabel* m_modeText = nullptr;
    QWidget* m_deformationBox = nullptr;
    QButtonGroup* m_deformation = nullptr;
    QLabel* m_status = nullptr;
    QLabel* m_warning = nullptr;
    QLabel* m_simplex = nullptr;
    QLabel* m_barycentric = nullptr;
    NumberField* m_pointX = nullptr;
    NumberField* m_pointY = nullptr;
    QAction* m_define = nullptr;
    QAction* m_reset = nullptr;
    QAction* m_bake = nullptr;
    QToolButton* m_fit = nullptr;
    QTimer m_settled;                    // the simplex is computed when the hand rests,
    QFutureWatcher<QString> m_enclosing; // beside the window
};

} // namespace view
