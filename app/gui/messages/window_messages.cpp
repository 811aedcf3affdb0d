// SPDX-License-Identifier: MIT
#include "messages/window_messages.h"

#include <QApplication>
#include <QMainWindow>
#include <QMessageBox>
#include <QStatusBar>

namespace {

constexpr int sayingTime = 8000; // milliseconds

// Adds a failure: as much as a screen holds is shown at once; the rest is behind the button for details.
void addFailure(QMessageBox& box, const QString& text) {
    constexpr qsizetype atOnce = 6;
    if (const QString before = box.informativeText(); before.count(u'\n') < atOnce)
        box.setInformativeText(before + u'\n' + text);
    else
        box.setDetailedText(box.detailedText() + text + u'\n');
}

} // namespace

WindowMessages::WindowMessages(QMainWindow* window) : QObject(window), m_window(window) {}

void WindowMessages::say(const QString& sentence) {
    m_window->statusBar()->showMessage(sentence, sayingTime);
}

void WindowMessages::fail(const QString& title, const QString& sentence) {
    if (m_failures.size() > 1) return addFailure(*m_failures.last(), title + QStringLiteral(". ") + sentence);
    auto* box = new QMessageBox(QMessageBox::Critical, QApplication::applicationDisplayName(), title + u'.',
                                QMessageBox::Ok, m_window);
    box->setInformativeText(sentence);
    box->setAttribute(Qt::WA_DeleteOnClose);
    // Boxes open one after the other: with two open, keys would reach neither. Failures in between are shown
    // together.
    connect(box, &QMessageBox::finished, this, [this, box] {
        m_failures.removeOne(box);
        if (!m_failures.isEmpty()) m_failures.first()->open();
    });
    m_failures << box;
    if (m_failures.size() == 1) box->open();
}
