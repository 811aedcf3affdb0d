// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "document/document.h"
#include "document/saved_views.h"
#include "io/exports/export_recipe.h"

#include <QDialog>

#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace view {

class ExportPreview;
class ExportProgress;
class ExportQueue;
class ExportSizeEditor;

// Exports an entry in space: the picture as the camera shows it, or a body to print. The work goes on in a
// thread of the model; closing the dialog stops it.
class SpaceExportDialog : public QDialog {
    Q_OBJECT

public:
    // `camera` in pixels of the screen.
    SpaceExportDialog(document::Document* document, const attractor::OrbitCamera& camera,
                      QWidget* parent = nullptr);
    ~SpaceExportDialog() override;

    enum class Format { Png, Jpeg, WebP, Tiff, Exr, Svg, Pdf, Stl, Obj, Glb, Ply, OpenScad };
    void setFormat(Format format);
    void setQueue(ExportQueue* queue); // which outlives it; without one, there is no Add to Queue
    // What the buttons do once a file is chosen.
    void exportTo(const QString& path);
    void addToQueue(const QString& path);
    const ExportPreview& preview() const { return *m_preview; }
    QString message() const; // what came of it
    bool canExport() const;

signals:
    void exported(const QString& path);
    void queued(); // the export was added

private:
    void createPicture();
    void createBody();
    void showBody(const QString& text);
    QString bodyText() const;          // its settings; empty of a picture
    void say(const QString& sentence); // with room for it
    Format format() const;
    std::optional<io::PictureFile> pictureFile() const; // nullopt: no picture
    std::optional<io::ShapeFile> page() const;          // that it is embedded in
    bool isBody() const { return !pictureFile() && format() != Format::OpenScad; }
    QString suffix() const;
    attractor::OrbitCamera camera() const;
    std::optional<io::ExportRecipe> recipe() const; // nullopt of a program, which takes no time
    io::Export toExport();
    io::Failure obstacle() const; // why nothing can be written in this format
    void update();
    void check(); // whether it can be written, and says so
    void enableButtons();
    void showPreview();
    QString chosenFile(); // empty: none
    void finish(const io::ExportOutcome& outcome, const QString& path);

    document::Fractal m_fractal; // as it was when the dialog opened
    attractor::OrbitCamera m_camera;
    std::vector<document::SavedView> m_views;
    QFormLayout* m_form = nullptr;
    QComboBox* m_format = nullptr;
    QComboBox* m_section = nullptr; // the canvas, then the saved views
    ExportSizeEditor* m_size = nullptr;
    ExportPreview* m_preview = nullptr;
    ExportQueue* m_queue = nullptr;
    QSpinBox* m_supersample = nullptr;
    QComboBox* m_depth = nullptr;
    QCheckBox* m_transparent = nullptr;
    QComboBox* m_stereo = nullptr;
    QDoubleSpinBox* m_longest = nullptr;
    QSpinBox* m_resolution = nullptr;
    QDoubleSpinBox* m_wall = nullptr;
    QCheckBox* m_fill = nullptr;
    QLabel* m_message = nullptr;
    QWidget* m_options = nullptr;
    ExportProgress* m_progress = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_enqueue = nullptr;
    QPushButton* m_close = nullptr;
    io::Failure m_obstacle;
    QString m_summary;                    // of the body that was written
    std::unique_ptr<io::ExportJob> m_job; // last: stops before the rest goes
};

} // namespace view
