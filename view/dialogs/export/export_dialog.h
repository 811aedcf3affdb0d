// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "dialogs/export/export_shell.h"
#include "document/document.h"
#include "document/fractal/fractal_geometry.h"
#include "document/saved_views.h"

#include <QFutureWatcher>
#include <QImage>
#include <QTimer>

#include <cstdint>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;
class QWidget;

namespace view {

class ExportPreview;
class ExportSizeEditor;

// Exports what the camera shows, as pixels or as shapes.
class ExportDialog : public ExportShell {
    Q_OBJECT

public:
    ExportDialog(document::Document* document, const attractor::Camera& camera, QWidget* parent = nullptr);
    ~ExportDialog() override;

    using File = std::variant<io::PictureFile, io::ShapeFile>; // chosen format
    enum class Section { View = -2, Attractor = -1 };          // saved views have the numbers from 0
    void setSection(Section section);                          // the part shown; the view at first
    void beginAsPoster();                                      // as pixels for the largest sheet
    void beginAsOutline();                                     // as one path in millimetres, to be cut
    void exportTo(const QString& path) override;               // the ending of the name decides the format
    const ExportPreview& preview() const { return *m_preview; }

protected:
    void resizeEvent(QResizeEvent* event) override;
    QString chosenFile() override;
    std::optional<io::ExportRecipe> recipeFor(const QString& path) override;
    const document::Fractal* queuedFractal() const override { return &m_fractal; }
    bool isPossible() const override;

private:
    void createFormat();
    void createPngOptions();
    void createSvgOptions();
    void connectOptions();

    std::optional<io::PictureFile> pixels() const; // chosen format, if it consists of pixels
    bool isSvg() const;                            // true for shapes: SVG or PDF
    bool isTransparent() const;
    io::PictureFormat::Depth depthOfColour() const;
    io::ShapeStyle style() const;
    attractor::Camera camera() const;
    io::ExportRecipe recipe(const attractor::Camera& camera) const;
    std::uint64_t memory() const;
    void update();
    void showPreview();
    void updateSvgPlan(); // computes in the background
    void showSvgPlan();
    void showPlan(const QString& text);
    void makeRoomForPlan();
    bool takeFormat(const QString& path); // reports names that determine no format

    document::Fractal m_fractal; // fractal at the opening of the dialog, with the camera of the canvas
    attractor::Camera m_camera;
    std::vector<document::SavedView> m_views;
    QComboBox* m_format = nullptr;
    QComboBox* m_section = nullptr;
    ExportSizeEditor* m_size = nullptr;
    ExportPreview* m_preview = nullptr;
    QCheckBox* m_transparent = nullptr;
    QCheckBox* m_triangle = nullptr;
    QComboBox* m_quality = nullptr;
    QSpinBox* m_supersample = nullptr;
    QComboBox* m_depthOfColour = nullptr;
    QLabel* m_memory = nullptr;
    QFormLayout* m_form = nullptr;
    QComboBox* m_style = nullptr;
    QSpinBox* m_points = nullptr;
    QCheckBox* m_autoDepth = nullptr;
    QSpinBox* m_depth = nullptr;
    QLabel* m_plan = nullptr;
    QWidget* m_options = nullptr;
    QTimer m_planTimer;
    // Extent of the exported fractal, found in the background.
    QFutureWatcher<std::optional<document::Box>> m_extent;
    QFutureWatcher<io::SvgPlan> m_planning;
    bool m_isPlanOld = false; // true if the plan being computed is obsolete
};

} // namespace view
