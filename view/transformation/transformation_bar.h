// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/tops/kept_theft.h"
#include "document/tops/theft_starters.h"

#include <QWidget>

#include <utility>

class QAction;
class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace view {

class ElidedLabel;

// Settings of a fractal transformation, under the two canvases: partner, mode and picture, with messages.
class TransformationBar : public QWidget {
    Q_OBJECT

public:
    explicit TransformationBar(QWidget* parent = nullptr);

    // Shows the entry, the others of the file, and the kept transformation.
    void show(const document::FractalFile& file, document::EntryId current, document::EntryId partner,
              const document::KeptTheft& theft);
    void showContinuity(const QString& sentence);
    enum class Remedy { None, DivideWords, ResetOrder, FindPicture, OpenForeignPicture };
    void showProblem(const QString& sentence, Remedy remedy); // empty sentence: no problem
    QString problem() const;
    QString continuity() const;
    void setExportable(bool exportable); // true if there is a picture to export
    void addSliders(QWidget* sliders);

signals:
    void partnerChosen(document::EntryId id);
    void modeChosen(document::TheftMode mode);
    void patternChosen(attractor::Pattern pattern);
    void pictureWanted(); // sent to choose a picture file
    void foreignPictureWanted();
    void embedWanted(bool embedded);
    void starterChosen(document::TheftFamily family);
    void divideWanted();
    void resetOrderWanted();
    void exportWanted();
    void overlaid(bool on); // partner over the fractal, translucent
    void stacked(bool on);  // true: canvases above each other; false: side by side

private:
    void addButtons();
    void addPictures();
    void addStarters();
    struct RemedyTexts { // texts of the remedy's button
        const char* id;
        QString name;
        QString tip;
    };
    static RemedyTexts textsOf(Remedy remedy);
    void showStatus();

    QLabel* m_from;
    QComboBox* m_partner;
    QComboBox* m_mode;
    QToolButton* m_picture;
    QAction* m_embed;
    QToolButton* m_starters;
    QToolButton* m_export;
    ElidedLabel* m_status;
    QToolButton* m_remedy;
    QToolButton* m_overlay;
    QToolButton* m_stack;
    QString m_continuity;
    QString m_problem;
    Remedy m_wanted = Remedy::None;
    QVBoxLayout* m_rows;
};

} // namespace view
