// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

#include <functional>

class QAction;

namespace codewheel {

// A table that grows at its end: messages, handshake trace, terminal. One text column gets the room that the
// others leave, and wraps; only visible rows are measured, so there may be a million of them. What one reads
// stays in place when rows come or go above it.
class LogTable : public QTableView
{
    Q_OBJECT

public:
    explicit LogTable(const QString &name, QWidget *parent = nullptr);

    // The text column is never narrower than the fewest letters; the columns after it are in sight as long as
    // it has the wanted letters, and are scrolled to otherwise.
    struct Letters
    {
        int fewest = 0;
        int wanted = 0;
    };
    void setTextColumn(int column, Letters letters);
    // Checked while the newest row is kept in sight. Scrolling up, or selecting another row, unchecks it.
    void setFollow(QAction &follow);
    // Rows with one text across all columns.
    void setHeadings(std::function<bool(int row)> isHeading);

    void setModel(QAbstractItemModel *model) override;
    void reset() override;

Q_SIGNALS:
    void chosenChanged(); // the current row or the selection

protected:
    void rowsInserted(const QModelIndex &parent, int first, int last) override;
    void rowsAboutToBeRemoved(const QModelIndex &parent, int first, int last) override;
    void updateGeometries() override;
    void scrollContentsBy(int dx, int dy) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    void selectionChanged(const QItemSelection &selected, const QItemSelection &deselected) override;
    void changeEvent(QEvent *event) override;

private:
    bool isFollowing() const;
    void shiftBy(int pixels); // after rows were added above
    void fitTextColumn();
    bool fitRows(); // the visible ones; true: one did not fit
    int heightOf(int row) const;
    void setLineHeight();

    int m_textColumn = -1;
    Letters m_letters;
    QAction *m_follow = nullptr;
    std::function<bool(int)> m_isHeading;
    int m_shift = 0; // px, of rows added or removed above and not laid out yet
    bool m_isFitting = false;
};

} // namespace codewheel
