// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/fonts.h"

#include <QAbstractTableModel>
#include <QCoreApplication>

#include <algorithm>
#include <functional>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace codewheel {

// What stands above a column. Its texts are translated in the context of the model's class.
struct ColumnHead
{
    const char *title;
    Qt::AlignmentFlag alignment{}; // none: as the view does it
    const char *tip = nullptr;
};

// What all our tables have in common: it keeps the rows and notifies the views of each change. A subclass
// gives heads(), or the number of columns and headerCell(), and the text() of its cells; what they have
// besides is in its cell(), by roles of Qt (decoration, accessible text). Q_OBJECT works in the subclass.
template <typename Row>
class TableModelBase : public QAbstractTableModel
{
public:
    using QAbstractTableModel::QAbstractTableModel;

    int rowCount(const QModelIndex &parent = {}) const final
    {
        return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
    }
    int columnCount(const QModelIndex &parent = {}) const final { return parent.isValid() ? 0 : columns(); }

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const final
    {
        if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
            return {};
        return cell(rowAt(index.row()), index.column(), role);
    }

    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const final
    {
        if (orientation == Qt::Vertical)
            return section < 0 || section >= rowCount() ? QVariant() : rowHead(rowAt(section), role);
        return section < 0 || section >= columns() ? QVariant() : headerCell(section, role);
    }

    const std::vector<Row> &rows() const { return m_rows; }
    const Row &rowAt(int row) const { return m_rows.at(static_cast<std::size_t>(row)); }

    // Resets all rows and loses selections, so only for new content.
    void setRows(std::vector<Row> rows)
    {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }

    void append(std::vector<Row> rows)
    {
        if (rows.empty())
            return;
        const int first = rowCount();
        beginInsertRows({}, first, first + static_cast<int>(rows.size()) - 1);
        std::move(rows.begin(), rows.end(), std::back_inserter(m_rows));
        endInsertRows();
    }

    void insertAt(int row, Row content)
    {
        beginInsertRows({}, row, row);
        m_rows.insert(m_rows.begin() + row, std::move(content));
        endInsertRows();
    }

    void replace(int row, Row content)
    {
        m_rows.at(static_cast<std::size_t>(row)) = std::move(content);
        Q_EMIT dataChanged(index(row, 0), index(row, columns() - 1));
    }

    // Removes all rows, and takes `more` that were not shown yet. The newest `most` of what has been cleared
    // since rows were last brought back can be brought back before newer rows.
    void clearRows(std::vector<Row> more, int most)
    {
        for (auto *part : {&m_rows, &more})
            std::move(part->begin(), part->end(), std::back_inserter(m_cleared));
        if (const auto surplus = std::ssize(m_cleared) - most; surplus > 0)
            m_cleared.erase(m_cleared.begin(), m_cleared.begin() + surplus);
        setRows({});
    }
    bool hasCleared() const { return !m_cleared.empty(); }
    void bringRowsBack()
    {
        if (!hasCleared())
            return;
        beginInsertRows({}, 0, static_cast<int>(m_cleared.size()) - 1);
        std::move(m_rows.begin(), m_rows.end(), std::back_inserter(m_cleared));
        m_rows = std::exchange(m_cleared, {});
        endInsertRows();
    }

    void removeAt(int row) { removeSpan(row, 1); }

    // The oldest rows, where a table is bounded.
    void removeFirst(int count) { removeSpan(0, std::min(count, rowCount())); }
    // Rows anywhere, one flag for each row. All at once, so that the cost does not grow with the gaps between
    // them.
    void removeChosen(const std::vector<bool> &chosen)
    {
        moveToFront(chosen);
        removeFirst(static_cast<int>(std::ranges::count(chosen, true)));
    }

protected:
    virtual std::span<const ColumnHead> heads() const { return {}; }
    virtual int columns() const { return static_cast<int>(heads().size()); }
    virtual QVariant headerCell(int column, int role) const
    {
        const ColumnHead &head = heads()[static_cast<std::size_t>(column)];
        const char *context = metaObject()->className();
        switch (role) {
        case Qt::DisplayRole:
            return QCoreApplication::translate(context, head.title);
        case Qt::ToolTipRole:
            return head.tip != nullptr ? QCoreApplication::translate(context, head.tip) : QVariant();
        case Qt::TextAlignmentRole:
            return head.alignment != 0 ? QVariant(head.alignment | Qt::AlignVCenter) : QVariant();
        default:
            return {};
        }
    }
    virtual QVariant rowHead(const Row & /*row*/, int /*role*/) const { return {}; }
    // What stands in a cell, and in its tooltip, for where it is cut off.
    virtual QString text(const Row & /*row*/, int /*column*/) const { return {}; }
    virtual bool isNumber(int /*column*/) const { return false; } // its digits stand below each other
    virtual QVariant cell(const Row &row, int column, int role) const
    {
        switch (role) {
        case Qt::DisplayRole:
        case Qt::ToolTipRole:
            return text(row, column);
        case Qt::TextAlignmentRole: // as its head
            return headerCell(column, role);
        case Qt::FontRole:
            return isNumber(column) ? QVariant(numberFont()) : QVariant();
        default:
            return {};
        }
    }

private:
    // In their order, and the others behind them in theirs.
    void moveToFront(const std::vector<bool> &chosen)
    {
        if (std::ranges::is_sorted(chosen, std::greater<>()))
            return;
        int front = 0;
        int behind = static_cast<int>(std::ranges::count(chosen, true));
        std::vector<int> rowNow(m_rows.size());
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            rowNow[i] = chosen[i] ? front++ : behind++;
        Q_EMIT layoutAboutToBeChanged();
        std::vector<Row> moved(m_rows.size());
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            moved[static_cast<std::size_t>(rowNow[i])] = std::move(m_rows[i]);
        m_rows = std::move(moved);
        const QModelIndexList before = persistentIndexList();
        QModelIndexList now;
        for (const QModelIndex &kept : before)
            now << index(rowNow[static_cast<std::size_t>(kept.row())], kept.column());
        changePersistentIndexList(before, now);
        Q_EMIT layoutChanged();
    }

    void removeSpan(int first, int count)
    {
        if (count <= 0)
            return;
        beginRemoveRows({}, first, first + count - 1);
        m_rows.erase(m_rows.begin() + first, m_rows.begin() + first + count);
        endRemoveRows();
    }

    std::vector<Row> m_rows;
    std::vector<Row> m_cleared;
};

} // namespace codewheel
