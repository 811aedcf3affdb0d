// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/branches/addresses.h"
#include "document/fractal/fractal.h"

#include <QDialog>

#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace view {

// Asks where in the plane the canvas is to look: a centre and a height. An address or the fixed point of a
// map fills in the centre.
class GoToDialog : public QDialog {
    Q_OBJECT

public:
    GoToDialog(std::shared_ptr<const document::Fractal> fractal, const attractor::View& now,
               QWidget* parent = nullptr);

    // The requested view, turned as the view was; nullopt while a field has no number.
    std::optional<attractor::View> view() const;

private:
    QLineEdit* numberField(double value, const QString& name, const QString& help);
    void layFields();
    void fillCentre(const ifs::Word& word); // point whose address repeats the word
    void readAddress();
    void chooseMap();
    void check();

    std::shared_ptr<const document::Fractal> m_fractal;
    document::Addresses m_addresses;
    attractor::View m_now;
    QLineEdit* m_x;
    QLineEdit* m_y;
    QLineEdit* m_height;
    QLineEdit* m_address;
    QComboBox* m_map;
    QLabel* m_note;
    QPushButton* m_go;
};

// The maps that an address such as "3 2 1" names, as indices in a system of `maps` maps; nullopt where a part
// of it is no number of a map.
std::optional<ifs::Word> wordOf(const QString& address, std::size_t maps);

} // namespace view
