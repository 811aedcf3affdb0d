// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/saved_views.h"

#include <QDialog>

#include <functional>

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace view {

// Asks for the name of a view.
class SaveViewDialog : public QDialog {
    Q_OBJECT

public:
    explicit SaveViewDialog(const document::Fractal& fractal, QWidget* parent = nullptr);

    QString name() const; // name in its stored form

private:
    void check();

    std::vector<document::SavedView> m_views;
    QLineEdit* m_name;
    QLabel* m_note;
    QPushButton* m_save;
};

// The saved views of the current entry, each change a step of the history.
class SavedViewsDialog : public QDialog {
    Q_OBJECT

public:
    // The canvas that shows the entry.
    struct Canvas {
        std::function<document::SavedView::Camera()> camera;
        std::function<void(const document::SavedView::Camera&)> lookAt;
    };
    SavedViewsDialog(document::Document* document, Canvas canvas, QWidget* parent = nullptr);

private:
    QPushButton* addButton(const QString& text, const QString& tip,
                           const std::function<void(const document::SavedView&)>& operation);
    void refresh();
    void rename(const QListWidgetItem& item);
    std::optional<document::SavedView> chosen() const;

    document::Document* m_document;
    Canvas m_canvas;
    QListWidget* m_list;
    QList<QPushButton*> m_buttons; // buttons that need a chosen view
    bool m_isRefreshing = false;
};

} // namespace view
