// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace codewheel {

// A table as high as its rows, for one that is scrolled together with what stands below it. Beyond a dozen
// rows it scrolls by itself, so that the heading stays in sight.
class WholeTable : public QTableView
{
    Q_OBJECT

public:
    explicit WholeTable(QWidget *parent = nullptr);

    int heightOf(int rows) const; // the first ones, with the heading
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void heightChanged();

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void tellHeight();
};

} // namespace codewheel
