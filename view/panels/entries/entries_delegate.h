// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>

#include <functional>
#include <optional>

class QLineEdit;

namespace view {

// Draws an entry: its picture, name, a line of facts, a dot when modified, a badge when the reader reported
// something. Its name editor stays open, with the reason, until the name is possible.
class EntriesDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using NameCheck = std::function<std::optional<QString>(const QModelIndex& index, const QString& name)>;

    static constexpr int pictureSide = 44; // device-independent pixels

    EntriesDelegate(NameCheck check, QObject* parent);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

signals:
    void nameTyped(const QModelIndex& index, const QString& name) const; // sent for valid names
    void typingEnded() const; // sent before the model gets a name, and if it gets none

protected:
    bool eventFilter(QObject* editor, QEvent* event) override;

private:
    std::optional<QString> problem(const QLineEdit& editor) const;
    void showProblem(QLineEdit& editor) const;

    NameCheck m_check;
};

} // namespace view
