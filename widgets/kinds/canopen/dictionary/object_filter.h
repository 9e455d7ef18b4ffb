// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/kinds/canopen/dictionary/object_model.h"

#include <QSortFilterProxyModel>

namespace codewheel {

// The objects that are looked for.
class ObjectFilter final : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    // By index.
    enum class Group : std::uint8_t { all, communication, maker, profile };

    explicit ObjectFilter(ObjectModel &rows, QObject *parent = nullptr);

    void setText(const QString &text); // in object, name, value or meaning
    void setGroup(Group group);
    void setOnlyDifferent(bool only); // ObjectModel::isDifferent(), those of other values first
    int inOneFileOnly() const;        // of the rows shown

    static bool isIn(Group group, canopen::SdoObject object);

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;
    bool lessThan(const QModelIndex &left, const QModelIndex &right) const override;

private:
    bool hasText(int row) const;

    ObjectModel &m_rows;
    QString m_text;
    Group m_group = Group::all;
    bool m_isOnlyDifferent = false;
};

} // namespace codewheel
