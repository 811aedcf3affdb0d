// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/export/export_shell.h"
#include "document/fractal/fractal_geometry.h"
#include "document/tops/theft_thread.h"

#include <QFutureWatcher>

#include <optional>

class QComboBox;
class QFormLayout;

namespace view {

class ExportPreview;
class ExportSizeEditor;

// Exports the picture that a fractal transformation steals, as PNG: what the canvas shows or the whole
// attractor, in any size.
class TheftExportDialog : public ExportShell {
    Q_OBJECT

public:
    // The job's view of F in pixels of the screen. Later edits do not change the job.
    explicit TheftExportDialog(const document::TheftJob& job, QWidget* parent = nullptr);

    const document::TheftJob& job() const { return m_job; }

    enum class Section { View, Attractor };
    void setSection(Section section);
    void exportTo(const QString& path) override;
    ExportSizeEditor& sizeEditor() { return *m_size; }
    const ExportPreview& preview() const { return *m_preview; }

protected:
    QString chosenFile() override;

private:
    QFormLayout* createOptions();
    QSize pixels() const;
    attractor::Camera camera(const QSize& size) const;
    void update();

    document::TheftJob m_job;
    QComboBox* m_section = nullptr;
    ExportSizeEditor* m_size = nullptr;
    ExportPreview* m_preview = nullptr;
    QFutureWatcher<std::optional<document::Box>> m_extent; // extent of F, found in the background
};

} // namespace view
