// SPDX-License-Identifier: MIT
#include "messages/window_messages.h"

#include <QApplication>
#include <QMainWindow>
#include <QMessageBox>
#include <QStatusBar>

namespace {

constexpr int sayingTime = 8000; // milliseconds

} // namespace

WindowMessages::WindowMessages(QMainWindow* window) : QObject(window), m_window(window) {}

void WindowMessages::say(const QString& sentence) {
    m_window->statusBar()->showMessage(sentence, sayingTime);
}

void WindowMessages::fail(const QString& title, const QString& sentence) {
    auto* box = new QMessageBox(QMessageBox::Critical, QApplication::applicationDisplayName(), title + u'.',
                                QMessageBox::Ok, m_window);
    box->setInformativeText(sentence);
    box->setAttribute(Qt::WA_DeleteOnClose);
    // One after the other: with two open, keys would reach neither.
    connect(box, &QMessageBox::finished, this, [this, box] {
        m_failures.removeOne(box);
        if (!m_failures.isEmpty()) m_failures.first()->open();
    });
    m_failures << box;
    if (m_failures.size() == 1) box->open();
}
