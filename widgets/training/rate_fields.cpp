// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/rate_fields.h"

#include "widgets/input/number_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/training_fields.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <QSpinBox>

namespace codewheel {

using namespace training_fields;

namespace {

constexpr int longestDelay = 1'000; // ms

} // namespace

RateFields::RateFields(const std::vector<Row> &rows, const QString &delayToolTip, QWidget *parent)
    : QWidget(parent)
    , m_delay(new IntegerField(this))
{
    auto *fields = layOut<QGridLayout>(this, grid::unit);
    fields->setHorizontalSpacing(grid::groupGap);
    fields->setColumnStretch(1, 1);
    for (const Row &row : rows)
        addRow(fields, row);
    addDelay(fields, delayToolTip);
}

void RateFields::addRow(QGridLayout *grid, const Row &row)
{
    const int number = static_cast<int>(m_rates.size());
    auto *field = new IntegerField(this);
    m_rates.push_back(field);
    field->setRange(0, row.most);
    prepare(field, 5);
    describe(field, tr("%1, of 1000").arg(row.name), row.toolTip);
    addCaption(grid, 2 * number, tr("%1, of 1000").arg(row.name), field);
    grid->addWidget(field, 2 * number, 1);
    grid->addWidget(wrongInput(field, this), 2 * number + 1, 0, 1, 2);
    connect(field, &QSpinBox::valueChanged, this,
            [this, number](int count) { Q_EMIT rateSet(number, count); });
}

void RateFields::addDelay(QGridLayout *grid, const QString &toolTip)
{
    const int row = 2 * static_cast<int>(m_rates.size());
    m_delay->setRange(1, longestDelay);
    prepare(m_delay, 5);
    describe(m_delay, tr("Delay in ms"), toolTip);
    addCaption(grid, row, tr("Delay, ms"), m_delay);
    grid->addWidget(m_delay, row, 1);
    grid->addWidget(wrongInput(m_delay, this), row + 1, 0, 1, 2);
    connect(m_delay, &QSpinBox::valueChanged, this, &RateFields::delaySet);
}

void RateFields::showRates(std::span<const int> counts, std::chrono::milliseconds delay)
{
    for (std::size_t row = 0; row < m_rates.size(); ++row) {
        const QSignalBlocker silent(m_rates[row]);
        m_rates[row]->setValue(counts[row]);
    }
    const QSignalBlocker silent(m_delay);
    m_delay->setValue(static_cast<int>(delay.count()));
}

} // namespace codewheel
