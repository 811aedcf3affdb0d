// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edits/agreement_picture.h"
#include "panels/collage/collage_numbers.h"
#include "panels/collage/fit_box.h"
#include "widgets/background/newest_work.h"

#include <QPointer>
#include <QWidget>

#include <atomic>
#include <memory>

class QComboBox;
class QLabel;
class QTimer;
class QToolButton;

namespace view {

class CanvasView;
class CollageLayer;
class SuggestionList;
class TargetBox;

// A fractal for a picture: chooses the target, measures the fractal against it, and fits the fractal to it.
// Everything that takes long runs in the background, and each result is one step of the history.
class CollagePanel : public QWidget {
    Q_OBJECT

public:
    // The shape compared with the target on the canvas.
    enum class Agreement { OfCollage, OfAttractor, Hidden };
    CollagePanel(document::Document* document, CanvasView* canvas, QWidget* parent = nullptr);
    ~CollagePanel() override;

    TargetBox* target() const { return m_target; }
    // Returns true if nothing runs in the background, and the results shown are those of the fractal as it
    // is.
    bool isSettled() const;
    // Shows the controls beyond the three steps: a picture, suggestions, a choice. Remembered between runs.
    void showMore(bool shown);

signals:
    void message(const QString& sentence); // sentence for the status bar

private:
    struct Result {
        std::vector<collage::Suggestion> suggestions;
        std::optional<document::Fractal> fractal;
        std::optional<double> shadesBound = {}; // bound for fitted weights
        std::optional<Refinement> refinement = {};
    };
    struct Running {
        FitBox::Task task;
        QString text; // text of the undo step
        std::shared_ptr<const document::Fractal> before;
    };
    using Work = std::function<Result(const std::stop_token&)>;

    QToolButton* makeMoreButton();
    void layMore();
    void connectParts();
    void bringTargetIntoView();
    void follow(const document::Change& change);
    void showSuggestions();
    void measure(document::Detail detail = document::Detail::Full);
    void showMeasured(std::optional<document::MeasuredFractal> measured);
    void showRefinement(const Refinement& refinement);
    void forgetResults();
    void showShadesBound(const std::optional<double>& pixels);
    void run(FitBox::Task task);
    static Result refined(std::optional<document::Fractal> after, const document::Fractal& before,
                          const document::TracedPicture& traced, document::Compared compared);
    Work workFor(FitBox::Task task, const std::shared_ptr<const document::Fractal>& fractal);
    void finish(std::optional<Result> result);
    void cancel();
    void use(int suggestion);
    void lock(bool lock);
    void showLocks();
    std::vector<ifs::MapId> fixedMaps() const; // maps that a fit must not change
    void updatePossible();

    document::Document* m_document;
    CanvasView* m_canvas;
    QPointer<CollageLayer> m_layer; // owned by the canvas, which may be destroyed first
    TargetBox* m_target;
    QComboBox* m_compared;
    CollageNumbers* m_numbers;
    FitBox* m_fit;
    QLabel* m_refined; // numbers after the last refinement
    QLabel* m_shades;  // bound for the weights fitted last
    SuggestionList* m_suggestions;
    QWidget* m_more;
    QToolButton* m_moreButton = nullptr;
    std::shared_ptr<const document::TracedPicture> m_suggestedFor; // target of the suggestions
    document::EntryId m_suggested = document::EntryId::None;       // entry in which one of them was used
    std::optional<document::MeasuredFractal> m_measured;
    std::optional<Running> m_running;
    std::shared_ptr<std::atomic<double>> m_progress; // progress of the running computation
    QTimer* m_progressTimer;
    QTimer* m_liveTimer; // running while numbers wait for the picture in a drag
    NewestWork<document::MeasuredFractal> m_measuring;
    NewestWork<Result> m_fitting; // last member: its thread uses the others
};

} // namespace view
