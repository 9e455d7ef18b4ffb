// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>

namespace codewheel {

class LineRowModel;

// The rows of a line, without those of the position polling where that is wanted: they would push away what
// was typed. What is hidden is kept.
class LineRowFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit LineRowFilter(LineRowModel &rows, QObject *parent = nullptr);

    void hidePolls(bool hide);
    bool hidesPolls() const { return m_hidesPolls; }

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    LineRowModel &m_rows;
    bool m_hidesPolls = true;
};

} // namespace codewheel
