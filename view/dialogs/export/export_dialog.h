// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/document.h"
#include "document/fractal/fractal_geometry.h"
#include "document/saved_views.h"
#include "io/exports/export_recipe.h"

#include <QDialog>
#include <QFutureWatcher>
#include <QImage>
#include <QTimer>

#include <cstdint>
#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QWidget;

namespace view {

class ExportPreview;
class ExportProgress;
class ExportQueue;
class ExportSizeEditor;

// Exports what the camera shows, as pixels or as shapes. The work goes on in a thread of the model; the
// dialog stays responsive, and closing it stops the export.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    ExportDialog(document::Document* document, const attractor::Camera& camera, QWidget* parent = nullptr);
    ~ExportDialog() override;

    enum class Section { View, Attractor }; // behind them in the list: the saved views
    void setSection(Section section);       // what the picture shows; the view at first
    void setFolder(const QString& folder);  // to suggest before the first export
    void setQueue(ExportQueue* queue);      // which outlives it; without one, there is no Add to Queue
    // What the buttons do once a file is chosen, and somebody has been asked whether to replace it. The
    // ending of its name decides the format.
    void exportTo(const QString& path);
    void addToQueue(const QString& path);
    const ExportPreview& preview() const { return *m_preview; }

signals:
    void exported(const QString& path);
    void queued(); // the export was added
    void failed(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void createFormat();
    void createPngOptions();
    void createSvgOptions();
    QWidget* createProgress();
    void connectOptions();

    std::optional<io::PictureFile> pixels() const; // the chosen format, if it is made of them
    bool isSvg() const;                            // or PDF: shapes
    bool isTransparent() const;
    io::PngFormat::Depth depthOfColour() const;
    io::ShapeStyle style() const;
    attractor::Camera camera() const;
    io::ExportRecipe recipe(const attractor::Camera& camera) const;
    std::uint64_t memory() const;
    void update();
    void showPreview();
    void updateSvgPlan(); // beside the window
    void showSvgPlan();
    void showPlan(const QString& text);
    void makeRoomForPlan();
    QString chosenFile(); // empty: none
    bool takeFormat(const QString& path);
    void say(const QString& sentence);
    void finish(const io::ExportOutcome& outcome, const QString& path);
    void setBusy(bool busy);

    document::Fractal m_fractal; // as it was when the dialog opened, with what the camera showed
    attractor::Camera m_camera;
    std::vector<document::SavedView> m_views;
    QString m_folder;
    QComboBox* m_format = nullptr;
    QComboBox* m_section = nullptr;
    ExportSizeEditor* m_size = nullptr;
    ExportPreview* m_preview = nullptr;
    ExportQueue* m_queue = nullptr;
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
    QLabel* m_message = nullptr;
    ExportProgress* m_progress = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_enqueue = nullptr;
    QPushButton* m_close = nullptr;
    QTimer m_planTimer;
    QFutureWatcher<std::optional<document::Box>> m_extent; // of what is exported, found in the background
    QFutureWatcher<io::SvgPlan> m_planning;
    bool m_isPlanOld = false;             // what is worked out is no longer what is wanted
    std::unique_ptr<io::ExportJob> m_job; // last: stops before the rest goes
};

} // namespace view
