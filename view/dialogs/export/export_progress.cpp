// SPDX-License-Identifier: MIT
#include "dialogs/export/export_progress.h"

#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

namespace view {

namespace {

constexpr double enough = 0.01;  // share that reveals the speed
constexpr qint64 patience = 700; // milliseconds; shorter exports show no time

QString timeText(qint64 milliseconds) {
    const qint64 seconds = (milliseconds + 999) / 1000;
    if (seconds < 60) return ExportProgress::tr("About %n second(s) left.", nullptr, int(seconds));
    const qint64 minutes = (seconds + 30) / 60;
    if (minutes < 120) return ExportProgress::tr("About %n minute(s) left.", nullptr, int(minutes));
    return ExportProgress::tr("About %n hour(s) left.", nullptr, int((minutes + 30) / 60));
}

} // namespace

ExportProgress::ExportProgress(QWidget* parent)
    : QWidget(parent), m_bar(new QProgressBar(this)), m_left(new QLabel(this)) {
    m_bar->setRange(0, 1000);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Progress of the export"));
    m_left->setAccessibleName(tr("Time left"));
    m_left->setMinimumHeight(fontMetrics().lineSpacing()); // constant height, even without text
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_bar);
    layout->addWidget(m_left);
    QSizePolicy policy = sizePolicy();
    policy.setRetainSizeWhenHidden(true); // keeps the buttons in place
    setSizePolicy(policy);
    setVisible(false);
}

void ExportProgress::begin(const QString& firstStep) {
    m_bar->setValue(0);
    m_left->setText(firstStep);
    m_clock.start();
    setVisible(true);
}

void ExportProgress::setFraction(double fraction) {
    m_bar->setValue(int(1000 * fraction));
    const qint64 passed = m_clock.elapsed();
    if (fraction < enough || passed < patience) return;
    m_left->setText(timeText(qint64(double(passed) * (1 - fraction) / fraction)));
}

void ExportProgress::end() {
    setVisible(false);
}

} // namespace view
