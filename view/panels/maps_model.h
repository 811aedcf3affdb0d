// SPDX-License-Identifier: MIT
#pragma once

#include "panels/live_edit.h"

#include <QAbstractTableModel>

#include <optional>
#include <vector>

namespace view {

// The maps of the entry being edited, one a row: code, facts, and the effective code under the current cage.
// Empty for an entry that holds no plane system.
class MapsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        Enabled,
        Colour,
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
        DecimalsRole =
            Qt::UserRole, // int: the most decimals a number of this column shows, to align the points
        WarningRole,      // QString: what is wrong with the map of this row; empty when nothing is
    };

    explicit MapsModel(document::Document* document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value,
                 int role = Qt::EditRole) override; // one undo step
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    // The typing in one cell: shown live, one undo step on commit.
    void preview(const QModelIndex& index, double value);
    void revert() override { cancelEdit(); } // what item views call on Esc
    void commitEdit() { m_edit.commit(); }
    void cancelEdit() { m_edit.cancel(); }

    ifs::MapId idAt(int row) const;
    const std::vector<ifs::WeightedMap<2>>& maps() const { return m_maps; }
    static bool isNumber(int column) { return column >= A && column != Kind && column < ColumnCount; }
    static bool isEditable(int column) { return column >= A && column <= Weight; }

private:
    void follow(const document::Change& change);
    void reload(bool sameCode);
    std::optional<double> number(int row, int column) const;
    QString tip(int row, int column) const;
    QString editText(int row, int column) const;
    QVariant alignment(int column) const;
    int decimals(int column) const;
    void change(document::Fractal& fractal, const QModelIndex& index, double value) const;

    document::Document* m_document;
    LiveEdit m_edit;
    std::vector<ifs::WeightedMap<2>> m_maps;
    std::vector<double> m_probabilities;
    std::optional<ifs::AffineMap<2>> m_display;         // nullopt while the placement is flat or bends
    mutable std::vector<std::optional<int>> m_decimals; // per column, once they are asked for
};

} // namespace view
