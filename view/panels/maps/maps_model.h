// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"
#include "document/edits/maps/maps_edits.h"
#include "ifs/system/decomposition.h"
#include "widgets/numbers/number_text.h"

#include <QAbstractTableModel>
#include <QItemSelection>

#include <optional>
#include <variant>
#include <vector>

namespace view {

document::Rows rowsIn(const QItemSelection& selection); // complete rows, sorted

// The maps of the entry being edited, one a row: code, facts, and the effective code under the current cage.
// Empty for an entry that could not be read.
class MapsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    // The columns of a system in the plane. In space, the coefficients a … l stand in the place of a … f, in
    // the code and in the effective code, and the columns after them are at columnOf().
    enum Column {
        Enabled,
        Lock,
        Colour, // includes a thumbnail of its image
        Name,
        A,
        B,
        C,
        D,
        E,
        F,
        Weight,
        Determinant,
        Contraction,
        Kind,
        EffectiveA,
        EffectiveB,
        EffectiveC,
        EffectiveD,
        EffectiveE,
        EffectiveF,
        ColumnCount,
    };
    enum Role {
        DecimalsRole = Qt::UserRole, // int: most decimals of a number in this column, for aligning the points
        WarningRole,                 // QString: problem of the map in this row; empty: none
        LockedRole,                  // bool: map of this row cannot be edited
    };

    explicit MapsModel(document::Document* document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value,
                 int role = Qt::EditRole) override; // one undo step
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    // The typing in one cell: shown live, one undo step on commit. The kind: see EditGesture::describe().
    void preview(const QModelIndex& index, double value, int kind = -1);
    void previewName(const QModelIndex& index, const QString& name);
    void revert() override { cancelEdit(); } // called by item views on Esc
    void commitEdit() { m_edit.commit(); }
    // Remembers the text of the number in the cell, if it is not a plain number.
    void keepTyped(const QModelIndex& index, double value, const QString& text);
    QString typedText(const QModelIndex& index) const;
    void cancelEdit() { m_edit.cancel(); }

    bool isMoving() const { return m_isMoving; } // true: the numbers are those of a moment
    void limitDecimals(int decimals);            // most decimals shown for code and weights
    // Why the cell cannot be edited, as a sentence; empty where it can, and where nothing could be in any
    // row.
    QString editObstacle(const QModelIndex& index) const;
    QString remark(const QModelIndex& index) const; // remark on a number that may be a mistake; empty: none
    bool hasNames() const;                          // true if any map has a name

    // The map that is shown alone, as its row says; None: no map is.
    ifs::MapId solo() const { return m_solo; }
    void setSolo(ifs::MapId map);

    ifs::MapId idAt(int row) const;
    // Rows in the order of the ids; maps that are gone have none.
    std::vector<int> rowsOf(const std::vector<ifs::MapId>& ids) const;
    int dimension() const { return m_shown.index() == 0 ? 2 : 3; }
    int coefficientCount() const { return dimension() * (dimension() + 1); }
    int columnOf(Column column) const; // column of A, EffectiveA and all that are no coefficients
    bool isNumber(int column) const;
    bool isEditable(int column) const { return column >= A && column <= columnOf(Weight); }

private:
    template <int Dim> struct Shown {
        std::vector<ifs::WeightedMap<Dim>> maps;
        std::vector<ifs::Link> links;               // links, which determine the maps that take part
        std::optional<ifs::AffineMap<Dim>> display; // nullopt if the placement is flat or bends
    };
    // Content of a column: A or EffectiveA for the coefficient `which`, else the enumerator.
    struct Meaning {
        Column kind;
        int which = 0;
    };
    Meaning meaningOf(int column) const;
    template <class Use> auto withMap(int row, Use use) const {
        return std::visit([&](const auto& shown) { return use(shown.maps[static_cast<std::size_t>(row)]); },
                          m_shown);
    }
    bool isCodeShown(const document::Fractal& fractal) const;
    bool areRowsShown(const document::Fractal& fractal) const;
    void follow(const document::Change& change);
    void reload(bool sameCode);
    std::optional<double> number(int row, int column) const;
    QString columnName(int column) const;
    QString columnTip(int column) const;
    QString tip(int row, int column) const;
    QString warning(int row) const; // problem of the map; empty: none
    bool isEnabled(int row) const;
    document::MapLabel labelOf(int row) const;
    QString title(int row) const; // number and, in parentheses, name
    QString mark(int row, Column column) const;
    QString spoken(int row, Column column) const; // text of a cell without text, for screen readers
    bool switchMap(int row, bool on);
    bool colourMap(int row, const QColor& colour);
    std::optional<double> weightOf(int row) const;
    ifs::MapKind kindOf(int row) const;
    QString placeOf(int row, int column) const;
    QString editText(int row, int column, double value) const;
    QVariant alignment(int column) const;
    int maxDecimalsOf(int column) const { return column <= columnOf(Weight) ? m_maxDecimals : maxDecimals; }
    QString textOf(double value, int column) const;
    int decimals(int column) const;
    void change(document::Fractal& fractal, const QModelIndex& index, double value,
                const QString& text = {}) const;

    document::Document* m_document;
    document::LiveEdit m_edit;
    std::variant<Shown<2>, Shown<3>> m_shown;
    std::vector<double> m_probabilities;
    bool m_isMoving = false; // the entry has an animation
    int m_maxDecimals = maxDecimals;
    ifs::MapId m_solo = ifs::MapId::None;
    mutable std::vector<std::optional<int>> m_decimals; // one for each column; computed on demand
};

} // namespace view
