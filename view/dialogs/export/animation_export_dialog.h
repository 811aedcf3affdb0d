// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/request/orbit_camera.h"
#include "dialogs/export/export_shell.h"
#include "document/document.h"
#include "document/saved_views.h"
#include "io/animation/cluster_job.h"
#include "io/video/format/video_format.h"

#include <optional>
#include <variant>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace view {

class AttractorWatch;
class ClusterQueue;
class ExportPreview;
class FrameSizeEditor;

// Exports the animation of the current entry as it is when the dialog opens: as a video, as pictures, or as a
// folder from which a cluster draws it. Closing the dialog while it works asks first.
class AnimationExportDialog : public ExportShell {
    Q_OBJECT

public:
    using Camera = std::variant<attractor::View, attractor::OrbitCamera>; // camera of the canvas
    AnimationExportDialog(document::Document* document, const Camera& camera, QWidget* parent = nullptr);
    ~AnimationExportDialog() override;

    enum class Section { View = -2, Animation = -1 }; // saved views have the numbers from 0
    void setSection(Section section);              // fixed part; the default is the view, without camera keys
    using Format = std::optional<io::VideoFormat>; // nullopt: one picture for each frame
    void setFormat(Format format);
    void exportTo(const QString& path) override;
    void prepareCluster(const QString& folder); // prepares On a Cluster after the choice of a folder
    void escape() override { reject(); }        // asks first
    void reject() override;

protected:
    QString chosenFile() override;
    bool isPossible() const override { return !m_obstacle; }
    void whenFinished() override;
    QString sentenceFor(const io::ExportOutcome& outcome, const QString& path) const override;
    Unfinished unfinished() const override;

private:
    bool isPictures() const;
    void createFormat();
    void createFrames();
    void createSize();
    void createPlan(QWidget* options);
    QWidget* createPreview();
    void proposeSize();
    void showPreview();
    void createButtons();
    void adoptEnding(const QString& path); // video format from the suffix of the file
    io::AnimationExport chosen() const;
    document::Fractal entryInView() const;
    QString suffix() const;
    void update();
    bool mayReplace(const QString& path); // asks the user if pictures would be replaced
    void chooseFolder();

    document::Fractal m_entry; // entry at the opening of the dialog
    Camera m_camera;
    std::vector<document::SavedView> m_views;
    QFormLayout* m_form = nullptr;
    QComboBox* m_format = nullptr;
    QComboBox* m_section = nullptr;
    FrameSizeEditor* m_size = nullptr;
    bool m_isSizeProposed = true; // false once the user has chosen a size
    QSpinBox* m_first = nullptr;
    QSpinBox* m_last = nullptr;
    QComboBox* m_quality = nullptr;
    QSpinBox* m_supersample = nullptr; // lit solids only
    QSpinBox* m_shutter = nullptr;
    QComboBox* m_exposure = nullptr;
    QSpinBox* m_tasks = nullptr; // visible if Slurm is installed or a cluster was requested before
    ExportPreview* m_preview = nullptr;
    QSlider* m_previewed = nullptr; // number of the previewed frame
    QLabel* m_plan = nullptr;
    QLabel* m_lost = nullptr; // message about frames without an attractor
    QPushButton* m_cluster = nullptr;
    ClusterQueue* m_queue = nullptr;
    AttractorWatch* m_watch;
    io::Failure m_obstacle;
};

} // namespace view
