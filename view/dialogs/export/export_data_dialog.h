// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/export/export_shell.h"
#include "document/document.h"
#include "io/exchange/point_format.h"
#include "io/exchange/text_formats.h"

#include <QFutureWatcher>

#include <functional>
#include <memory>
#include <optional>
#include <variant>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace view {

class ColumnOrders;

// Hands the numbers of the current entry to other programs: flames, IFStile, tables, points. Shows what the
// file will hold while its options are chosen.
class ExportDataDialog : public ExportShell {
    Q_OBJECT

public:
    using Format = std::variant<io::TextFormat, io::PointFormat>;

    explicit ExportDataDialog(document::Document* document, QWidget* parent = nullptr);
    ~ExportDataDialog() override;

    void exportTo(const QString& path) override;

protected:
    QString chosenFile() override;
    bool isPossible() const override { return m_isPossible; }
    QString sentenceFor(const io::ExportOutcome& outcome, const QString& path) const override;

private:
    void createOptions(QFormLayout* form);
    void chooseFormat(const Format& remembered);
    Format format() const;
    std::optional<io::TextFormat> textFormat() const; // nullopt: points
    io::PointFormat pointFormat() const;
    QString suffix() const;
    std::shared_ptr<const document::Fractal> fractalToExport() const;
    std::function<QByteArray()> textMaker() const; // thread-safe function that returns the text of the file
    QString loss() const;
    void update();
    void startPreview();
    void showPreview();
    void copy();
    QString withLoss(const QString& sentence) const;

    const document::Fractal m_fractal;                // fractal at the opening of the dialog
    std::shared_ptr<const document::Fractal> m_baked; // null if it needs no baking, or cannot be baked
    QFormLayout* m_form = nullptr;
    QComboBox* m_format = nullptr;
    ColumnOrders* m_columns = nullptr;
    QSpinBox* m_points = nullptr;
    QCheckBox* m_turnY = nullptr;
    QCheckBox* m_bake = nullptr;
    QPlainTextEdit* m_preview = nullptr;
    QFutureWatcher<QByteArray> m_previewed; // beginning of the text
    QPushButton* m_copy = nullptr;
    bool m_isPossible = true;
};

} // namespace view
