// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"

#include <QWidget>

#include <chrono>
#include <span>
#include <vector>

class QGridLayout;

namespace codewheel {

// How many of 1000 bytes or frames something happens to, and how long those that are delayed are. Part of the
// training panel.
class RateFields : public QWidget
{
    Q_OBJECT

public:
    struct Row
    {
        QString name; // "Lost bytes"
        QString toolTip;
        int most = 1'000;
    };

    RateFields(const std::vector<Row> &rows, const QString &delayToolTip, QWidget *parent = nullptr);

    void showRates(std::span<const int> counts, std::chrono::milliseconds delay); // by row

Q_SIGNALS:
    void rateSet(int row, int count);
    void delaySet(int milliseconds);

private:
    void addRow(QGridLayout *grid, const Row &row);
    void addDelay(QGridLayout *grid, const QString &toolTip);

    std::vector<IntegerField *> m_rates; // by row
    IntegerField *m_delay;
};

} // namespace codewheel
