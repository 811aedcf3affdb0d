// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "dialogs/export/export_shell.h"
#include "document/document.h"
#include "document/saved_views.h"

#include <memory>
#include <optional>
#include <variant>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace view {

class ExportPreview;
class ExportSizeEditor;

// Exports an entry in space: the picture as the camera shows it, or a body to print.
class SpaceExportDialog : public ExportShell {
    Q_OBJECT

public:
    // `camera` in pixels of the screen.
    SpaceExportDialog(document::Document* document, const attractor::OrbitCamera& camera,
                      QWidget* parent = nullptr);
    ~SpaceExportDialog() override;

    struct OpenScad {
        friend bool operator==(OpenScad, OpenScad) = default;
    };
    // Pixels, alone or in a page of shapes; a body; or a program.
    using Format = std::variant<io::PictureFile, io::ShapeFile, io::MeshFormat, OpenScad>;
    void setFormat(const Format& format);
    void beginWithAttractor();                   // as the section, rather than the view on the canvas
    void exportTo(const QString& path) override; // format from the suffix of the name
    const ExportPreview& preview() const { return *m_preview; }

protected:
    QString chosenFile() override;
    std::optional<io::ExportRecipe> recipeFor(const QString& path) override;
    const document::Fractal* queuedFractal() const override { return &m_fractal; }
    bool isPossible() const override { return !m_obstacle; }
    bool isQueueable() const override {
        return !std::holds_alternative<OpenScad>(format());
    } // false for OpenSCAD programs, which are written at once
    QString sentenceFor(const io::ExportOutcome& outcome, const QString& path) const override;

private:
    void createPicture();
    void createBody();
    void showBody(const QString& text);
    QString bodyText() const; // settings of the body; empty for a picture
    Format format() const;
    std::optional<io::PictureFile> pictureFile() const; // nullopt: no picture
    std::optional<io::ShapeFile> page() const; // page in which the picture is embedded; nullopt: none
    bool isBody() const { return std::holds_alternative<io::MeshFormat>(format()); }
    QString suffix() const;
    attractor::OrbitCamera camera() const;
    std::optional<io::ExportRecipe> recipe() const; // nullopt for OpenSCAD programs
    io::Failure obstacle() const;                   // reason why nothing can be written in this format
    void update();
    void check(); // shows whether it can be written
    void showPreview();
    bool takeFormat(const QString& path); // reports names that determine no format

    document::Fractal m_fractal; // fractal at the opening of the dialog
    attractor::OrbitCamera m_camera;
    std::vector<document::SavedView> m_views;
    QFormLayout* m_form = nullptr;
    QComboBox* m_format = nullptr;
    QComboBox* m_section = nullptr; // canvas, then the saved views
    ExportSizeEditor* m_size = nullptr;
    ExportPreview* m_preview = nullptr;
    QSpinBox* m_supersample = nullptr;
    QComboBox* m_depth = nullptr;
    QCheckBox* m_transparent = nullptr;
    QCheckBox* m_cage = nullptr;
    QComboBox* m_stereo = nullptr;
    QDoubleSpinBox* m_longest = nullptr;
    QSpinBox* m_resolution = nullptr;
    QDoubleSpinBox* m_wall = nullptr;
    QCheckBox* m_fill = nullptr;
    io::Failure m_obstacle;
    // Sentences on the body that was written. A thread writes it, so that each export has its own.
    std::shared_ptr<QString> m_summary = std::make_shared<QString>();
};

} // namespace view
