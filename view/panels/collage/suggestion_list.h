// SPDX-License-Identifier: MIT
#pragma once

#include "collage/suggestions.h"
#include "document/fractal/fractal.h"
#include "widgets/thumbnails.h"

#include <QListWidget>

#include <memory>
#include <vector>

namespace view {

// Systems that look like the target, the best first, each with a picture and its numbers. Activating one uses
// it.
class SuggestionList : public QListWidget {
    Q_OBJECT

public:
    explicit SuggestionList(QWidget* parent);

    // `fractals` are those that the suggestions make of the entry.
    void show(const std::vector<collage::Suggestion>& suggestions,
              std::vector<std::shared_ptr<const document::Fractal>> fractals);
    void forget();
    // Highlights the suggestion that this fractal has the maps and the cage of, or none.
    void highlight(const document::Fractal& current);
    const std::shared_ptr<const document::Fractal>& fractal(int row) const {
        return m_fractals.at(std::size_t(row));
    }

    QSize sizeHint() const override;

signals:
    void chosen(int row);

private:
    void showPicture(int row);

    Thumbnails* m_thumbnails;
    quint64 m_sheet = 0; // number of the sheet, part of the keys of the pictures
    std::vector<std::shared_ptr<const document::Fractal>> m_fractals;
};

} // namespace view
