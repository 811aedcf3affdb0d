// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/request/orbit_camera.h"
#include "document/document.h"
#include "document/saved_views.h"
#include "io/animation/cluster_job.h"
#include "io/export_job.h"

#include <QDialog>
#include <QMessageBox>
#include <QPointer>

#include <memory>
#include <optional>
#include <variant>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace view {

class AttractorWatch;
class ClusterQueue;
class ExportProgress;

// Exports the animation of the current entry as it is when the dialog opens: as a video, as pictures, or as a
// folder from which a cluster draws it. The work goes on in a thread of the model while the window is used;
// closing the dialog stops it, after a question.
class AnimationExportDialog : public QDialog {
    Q_OBJECT

public:
    using Camera = std::variant<attractor::View, attractor::OrbitCamera>; // what the canvas shows
    AnimationExportDialog(document::Document* document, const Camera& camera, QWidget* parent = nullptr);
    ~AnimationExportDialog() override;

    enum class Section { View, Animation }; // behind them in the list: the saved views
    void setSection(Section section);       // what is shown where no camera key says
    enum Format { Mp4, WebM, Mkv, Gif, WebP, Apng, Pictures };
    void setFormat(Format format);
    void exportTo(const QString& path);         // what Export does once a file is chosen …
    void prepareCluster(const QString& folder); // … and On a Cluster once a folder is
    QString message() const;                    // what came of it
    bool mayClose();                            // asks the user while an export is under way
    void reject() override;

signals:
    void exported(const QString& path);

private:
    void createFormat();
    void createFrames();
    QWidget* createResult();
    void createButtons();
    void adoptEnding(const QString& path); // a video of the format that the file is named after
    io::AnimationExport chosen() const;
    document::Fractal entryInView() const;
    QString suffix() const;
    void update();
    void chooseFile();
    bool mayReplace(const QString& path); // asks the user where pictures would replace others
    void chooseFolder();
    void startWork();
    void finish(const io::ExportOutcome& outcome, const QString& path);
    void say(const QString& sentence);

    document::Fractal m_entry; // as it was when the dialog opened
    Camera m_camera;
    std::vector<document::SavedView> m_views;
    QFormLayout* m_form = nullptr;
    QComboBox* m_format = nullptr;
    QComboBox* m_section = nullptr;
    QSpinBox* m_width = nullptr;
    QSpinBox* m_height = nullptr;
    QSpinBox* m_first = nullptr;
    QSpinBox* m_last = nullptr;
    QComboBox* m_quality = nullptr;
    QSpinBox* m_shutter = nullptr;
    QComboBox* m_exposure = nullptr;
    QSpinBox* m_tasks = nullptr;
    QLabel* m_plan = nullptr;
    QLabel* m_lost = nullptr; // says when there is no attractor
    QLabel* m_message = nullptr;
    QWidget* m_options = nullptr;
    ExportProgress* m_progress = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_cluster = nullptr;
    QPushButton* m_close = nullptr;
    ClusterQueue* m_queue = nullptr;
    AttractorWatch* m_watch;
    QPointer<QMessageBox> m_question;     // whether to stop; nobody need answer once the work has ended
    std::unique_ptr<io::ExportJob> m_job; // last: stops before the rest goes
};

} // namespace view
