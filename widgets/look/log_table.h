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

    // Never narrower than so many letters: the table is scrolled sideways otherwise.
    void setTextColumn(int column, int fewestLetters);
    // Another column, which gives way to the text down to its least width as long as that has fewer than the
    // wanted letters. It stays as the user drags it.
    struct Elastic
    {
        int column = -1;
        int least = 0; // px
        int most = 0;
        int wantedLetters = 0;
    };
    void setElasticColumn(const Elastic &elastic);
    // Checked while the newest row is kept in sight. Scrolling up, or choosing another row, unchecks it.
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

private:
    bool isFollowing() const;
    void shiftBy(int pixels);      // after rows came above
    int widthOf(int column) const; // as it is seen
    void fitTextColumn();
    void keepDragged(int column, int width);
    bool fitRows(); // those in sight; true: one was not fitting
    int heightOf(int row) const;
    void setLineHeight();

    int m_textColumn = -1;
    int m_fewestLetters = 0;
    Elastic m_elastic;
    QAction *m_follow = nullptr;
    std::function<bool(int)> m_isHeading;
    int m_shift = 0; // px, of rows added or removed above and not laid out yet
    bool m_isFitting = false;
};

} // namespace codewheel
