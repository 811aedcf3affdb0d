// SPDX-License-Identifier: MIT
#include "dialogs/export/large_export.h"

#include "document/text/text.h"
#include "widgets/numbers/number_text.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace view {

namespace {

constexpr double manyPixels = 500e6;
constexpr std::uint64_t muchMemory = std::uint64_t(8) << 30;
constexpr int bytesOfPixel = 4;

} // namespace

QString largeExportSentence(const QSize& pixels, std::uint64_t memory) {
    const double count = double(pixels.width()) * pixels.height();
    if (count < manyPixels && memory < muchMemory) return {};
    const auto size = [](double bytes) { return QLocale::c().formattedDataSize(qint64(bytes)); };
    QString sentence =
        Text::tr(
            "%1 × %2 are %3 million pixels. Drawing them may take hours, and the file may need up to %4.")
            .arg(groupedNumber(pixels.width()), groupedNumber(pixels.height()), groupedNumber(count / 1e6),
                 size(count * bytesOfPixel));
    if (memory > 0) sentence += u' ' + Text::tr("Memory needed: about %1.").arg(size(double(memory)));
    return sentence;
}

bool confirmLargeExport(QWidget* parent, const QSize& pixels, std::uint64_t memory) {
    const QString sentence = largeExportSentence(pixels, memory);
    if (sentence.isEmpty()) return true;
    QMessageBox box(QMessageBox::Warning, Text::tr("Very large picture"),
                    Text::tr("This picture is very large."), QMessageBox::Cancel, parent);
    box.setInformativeText(sentence);
    const QPushButton* go = box.addButton(Text::tr("&Export Anyway"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == go;
}

} // namespace view
