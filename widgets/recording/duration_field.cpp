// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/duration_field.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QComboBox>

namespace codewheel {
namespace {

constexpr double mostOfUnit = 9'999;
constexpr std::array<qint64, 4> secondsOfUnits{1, 60, 3'600, 86'400};

} // namespace

DurationField::DurationField(const char *id, const QString &name, const QString &tip, QWidget *parent)
    : QWidget(parent)
    , m_number(describe(new DecimalField(this), id, name, tip))
    , m_unit(describe(new QComboBox(this), tr("Unit: %1").arg(name), tip))
{
    m_number->setRange(0, mostOfUnit);
    m_number->setDecimals(1);
    m_unit->setObjectName(QLatin1String(id) + QStringLiteral("Unit"));
    const std::array names{QStringLiteral("s"), QStringLiteral("min"), QStringLiteral("h"), tr("days")};
    for (std::size_t i = 0; i < secondsOfUnits.size(); ++i)
        m_unit->addItem(names.at(i), secondsOfUnits.at(i));
    layOutRow(this, {m_number, m_unit, Stretch{1}}, {.spacing = grid::unit, .margins = QMargins()});
    setFocusProxy(m_number);
    connect(m_number, &QDoubleSpinBox::valueChanged, this, &DurationField::changed);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &DurationField::changed);
}

Instant DurationField::value() const
{
    const double seconds = m_number->value() * static_cast<double>(m_unit->currentData().toLongLong());
    return std::chrono::duration_cast<Instant>(std::chrono::duration<double>(seconds));
}

// In the largest unit that leaves no remainder.
void DurationField::setValue(Instant value)
{
    const double seconds = std::chrono::duration<double>(value).count();
    std::size_t unit = 0;
    for (std::size_t i = 1; i < secondsOfUnits.size(); ++i)
        if (value >= std::chrono::seconds(secondsOfUnits.at(i)) &&
            value % std::chrono::seconds(secondsOfUnits.at(i)) == Instant(0))
            unit = i;
    m_unit->setCurrentIndex(static_cast<int>(unit));
    m_number->setValue(seconds / static_cast<double>(secondsOfUnits.at(unit)));
}

} // namespace codewheel
