// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "io/exchange/text_formats.h"
#include "io/export_job.h"

#include <QDialog>
#include <QFutureWatcher>

#include <functional>
#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace view {

class ColumnOrders;
class ExportProgress;

// Hands the numbers of the current entry to other programs: flames, IFStile, tables, points. Shows what the
// file will hold while its options are chosen.
class ExportDataDialog : public QDialog {
    Q_OBJECT

public:
    explicit ExportDataDialog(document::Document* document, QWidget* parent = nullptr);
    ~ExportDataDialog() override;

    void exportTo(const QString& path); // what the Export button does once a file is chosen

signals:
    void exported(const QString& path);

private:
    void createOptions(QFormLayout* form);
    void chooseFormat(int remembered);
    std::optional<io::TextFormat> textFormat() const; // nullopt: points
    io::PointFormat pointFormat() const;
    QString suffix() const;
    std::shared_ptr<const document::Fractal> fractalToExport() const;
    std::function<QByteArray()> textMaker() const; // of the text in the file, for any thread
    QString loss() const;
    void update();
    void startPreview();
    void showPreview();
    void chooseFile();
    void copy();
    void finish(const io::ExportOutcome& outcome, const QString& path);
    void say(const QString& sentence);
    void sayWithLoss(const QString& sentence);

    const document::Fractal m_fractal;                // as it was when the dialog opened
    std::shared_ptr<const document::Fractal> m_baked; // null where there is nothing to bake, or it cannot be
    QFormLayout* m_form = nullptr;
    QComboBox* m_format = nullptr;
    ColumnOrders* m_columns = nullptr;
    QSpinBox* m_points = nullptr;
    QCheckBox* m_turnY = nullptr;
    QCheckBox* m_bake = nullptr;
    QPlainTextEdit* m_preview = nullptr;
    QFutureWatcher<QByteArray> m_previewed; // the beginning of the text
    QLabel* m_message = nullptr;
    QWidget* m_options = nullptr;
    ExportProgress* m_progress = nullptr;
    QPushButton* m_export = nullptr;
    QPushButton* m_copy = nullptr;
    QPushButton* m_close = nullptr;
    std::unique_ptr<io::ExportJob> m_job; // last: stops before the rest goes
};

} // namespace view
