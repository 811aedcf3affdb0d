// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/export/handout_page.h"
#include "document/document.h"
#include "io/export_job.h"
#include "io/overlay/overlay_marks.h"

#include <QDialog>

#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace view {

// Chooses entries of the file and how they are printed for a class, and shows the print preview.
class HandoutDialog : public QDialog {
    Q_OBJECT

public:
    static constexpr int maxEntries = 60;  // limit for one print, whose pictures are held at once
    static constexpr int maxListed = 2000; // limit of the list

    explicit HandoutDialog(const document::Document* document, QWidget* parent = nullptr);

    void setName(const QString& name) { m_name = name; } // name of the document, in place of its entry's
    QString printedName() const;
    HandoutOptions options() const;
    std::vector<std::shared_ptr<const document::Fractal>> chosen() const; // in the order of the file
    void showPreview(); // prepared in the background, with progress

signals:
    void written(const QString& path); // where paper is a file

private:
    void createEntries(const document::Document& document);
    void createOptions();
    void update();

    std::vector<std::shared_ptr<const document::Fractal>> m_fractals; // indexed by row of the list
    QString m_name;
    QListWidget* m_entries;
    QComboBox* m_kind;
    QComboBox* m_perPage;
    QCheckBox* m_maps;
    QCheckBox* m_formulas;
    QCheckBox* m_nameLine;
    QLabel* m_message; // message about the last print
    QPushButton* m_preview = nullptr;
};

// The picture of a handout: the displayed attractor on paper, with the cage and its numbered images where
// the options want them.
io::PlaneExport handoutPicture(const document::Fractal& fractal, const HandoutOptions& options);
// The same of an entry in space, seen as at first.
struct HandoutPictureInSpace {
    io::SpaceExport picture;
    io::OverlayMarks marks; // drawn over the picture
};
HandoutPictureInSpace handoutPictureInSpace(const document::Fractal& fractal, const HandoutOptions& options);

} // namespace view
