// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_index.h"

#include <QAbstractListModel>
#include <QStringList>

namespace codewheel {

// The entries that match what was typed, best first; before anything is typed, those used last and the usual
// ones.
class PaletteModel : public QAbstractListModel
{
    Q_OBJECT

public:
    enum Role {
        contextRole = Qt::UserRole, // QString: kind and place, or why it is not available
        keyRole,                    // QString
        isEnabledRole,              // bool
    };

    using QAbstractListModel::QAbstractListModel;

    void clear();
    void setUsed(const QStringList &ids); // last one first
    void add(std::vector<PaletteEntry> entries);
    void setTyped(const QString &typed);
    const QStringList &words() const { return m_words; } // typed, folded

    const PaletteEntry &entry(int row) const { return m_index.at(m_rows[static_cast<std::size_t>(row)]); }

    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;

private:
    void list();

    PaletteIndex m_index;
    QStringList m_used;
    QString m_typed;
    QStringList m_words;
    std::vector<std::size_t> m_rows;
};

} // namespace codewheel
