// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/theft_bridge.h"
#include "document/tops/partner_document.h"
#include "ifs/tops/tear.h"
#include "io/tops/picture_to_embed.h"
#include "transformation/transformation_bar.h"
#include "widgets/background/newest_work.h"

#include <QFutureWatcher>
#include <QSet>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

class QSplitter;

namespace view {

class CanvasView;
class MapOrder;
class PictureSource;

// The canvas of the plane, and while it is shown the window of fractal transformations: F in that canvas with
// the colours it steals, its partner G beside it with the picture, the order of the maps, and the choices
// below. docs/decisions/0015-fractal-transformations-in-the-window.md.
class TransformationView : public QWidget {
    Q_OBJECT

public:
    // The canvas becomes a part of it.
    TransformationView(document::Document* document, RenderBridge* render, CanvasView* canvas,
                       QWidget* parent = nullptr);
    ~TransformationView() override;

    void setTransformationShown(bool shown);
    bool isTransformationShown() const { return m_isShown; }

    // Null or empty before it was shown for the first time:
    CanvasView* partnerCanvas() const { return m_partnerCanvas; }
    bool cancelGesture();   // cancels a gesture on the partner; false if there was none
    bool isPainted() const; // true if the canvases show a fractal transformation
    void chooseExport();    // dialog with a choice of both pictures; no effect if none is shown
    const TransformationBar* bar() const { return m_bar; }
    const TheftBridge* theft() const { return m_theft.get(); }

    void usePicture(const QString& path); // reads the picture and then adds a step to the history

signals:
    void message(const QString& sentence);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    struct Continuity { // empty if there is no transformation
        std::optional<ifs::Tear> there, back;
        ifs::Homeomorphism verdict = ifs::Homeomorphism::Unknown;
    };

    void create();
    void connectBar();
    void connectSource();
    void followTools();
    void arrange(Qt::Orientation orientation); // equal room for both canvases
    void refresh();
    void showPicture();
    void showProblem();
    void measureLater();
    void measure();
    void keep(const QString& text, const document::KeptTheft& theft);
    void start(document::TheftFamily family);
    document::KeptTheft placed(document::KeptTheft theft, const document::Fractal& partner) const;
    void choosePicture();
    void keepPicture();
    void embedPicture(bool embedded); // embeds the picture in the entry after reading it
    struct Embedding {
        io::PictureToEmbed found;
        bool isForeign = false;
    };
    void keepEmbedded(std::optional<Embedding> read);
    QString picturePath() const; // absolute path of the entry's picture
    void refuseForeign();        // blocks the picture until the user agrees
    void openForeign();
    void forgetAgreement();
    bool isOverPartner(const QPoint& position) const;
    QString folder() const; // folder of the file; empty before the first save
    document::TheftJob job() const;

    document::Document* m_document;
    RenderBridge* m_render;
    CanvasView* m_canvas;
    QSplitter* m_splitter;
    bool m_isShown = false;

    // Members made when they are shown for the first time:
    std::unique_ptr<document::PartnerDocument> m_partner;
    RenderBridge* m_partnerRender = nullptr;
    CanvasView* m_partnerCanvas = nullptr;
    std::unique_ptr<TheftBridge> m_theft;
    PictureSource* m_source = nullptr;
    MapOrder* m_order = nullptr;
    TransformationBar* m_bar = nullptr;

    document::KeptTheft m_kept;                               // settings of the entry, or suggested ones
    document::EntryId m_guessedFor = document::EntryId::None; // entry for which m_kept was suggested
    QString m_wanted;                                         // picture to be kept once it is read
    bool m_isOwnPicture = false; // true if the shown picture belongs to this entry
    QString m_pictureFailure;    // reason why the entry's picture is not shown
    bool m_isForeign = false;    // true if the picture is outside the folder of the file
    QSet<QString> m_agreed;      // absolute paths that the user has chosen or accepted for this file
    bool m_isMoving = false;     // true while the folder of another file is being found out
    QString m_refusal;           // reason why a chosen picture was refused
    NewestWork<Embedding> m_embedding;
    QTimer m_rest; // delay before the continuity is measured
    QFutureWatcher<Continuity> m_measuring;
};

} // namespace view
