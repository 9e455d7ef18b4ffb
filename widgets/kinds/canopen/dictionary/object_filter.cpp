// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/object_filter.h"

#include <algorithm>
#include <utility>

namespace codewheel {

ObjectFilter::ObjectFilter(ObjectModel &rows, QObject *parent)
    : QSortFilterProxyModel(parent)
    , m_rows(rows)
{
    setSourceModel(&rows);
}

void ObjectFilter::setText(const QString &text)
{
    m_text = text.trimmed();
    invalidateFilter();
}

void ObjectFilter::setGroup(Group group)
{
    m_group = group;
    invalidateFilter();
}

void ObjectFilter::setOnlyDifferent(bool only)
{
    m_isOnlyDifferent = only;
    invalidateFilter();
    sort(only ? 0 : -1);
}

int ObjectFilter::inOneFileOnly() const
{
    int count = 0;
    for (int row = 0; row < rowCount(); ++row)
        count += m_rows.isInOneFileOnly(m_rows.rowAt(mapToSource(index(row, 0)).row())) ? 1 : 0;
    return count;
}

bool ObjectFilter::lessThan(const QModelIndex &left, const QModelIndex &right) const
{
    const auto rank = [this](const QModelIndex &its) {
        return std::pair(m_rows.isInOneFileOnly(m_rows.rowAt(its.row())), its.row());
    };
    return rank(left) < rank(right);
}

bool ObjectFilter::isIn(Group group, canopen::SdoObject object)
{
    switch (group) {
    case Group::communication:
        return object.index >= 0x1000 && object.index < 0x2000;
    case Group::maker:
        return object.index >= 0x2000 && object.index < 0x6000;
    case Group::profile:
        return object.index >= 0x6000 && object.index < 0xA000;
    case Group::all:
        break;
    }
    return true;
}

bool ObjectFilter::hasText(int row) const
{
    constexpr ObjectModel::Column searched[] = {ObjectModel::object, ObjectModel::name, ObjectModel::value,
                                                ObjectModel::meaning, ObjectModel::project};
    return m_text.isEmpty() || std::ranges::any_of(searched, [&](ObjectModel::Column column) {
               return m_rows.index(row, column).data().toString().contains(m_text, Qt::CaseInsensitive);
           });
}

bool ObjectFilter::filterAcceptsRow(int row, const QModelIndex & /*parent*/) const
{
    const ObjectRow &its = m_rows.rowAt(row);
    return (!m_isOnlyDifferent || m_rows.isDifferent(its)) && isIn(m_group, its.object.object) &&
           hasText(row);
}

} // namespace codewheel
