// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/known_table.h"

#include "catalog/device_description.h"
#include "encoder/encoder_session.h"
#include "widgets/job/known_text.h"
#include "widgets/look/fonts.h"

namespace codewheel {

void KnownTable::show(const EncoderSession &encoder)
{
    std::vector<KnownRow> now;
    for (const ParameterDescription &parameter : encoder.device().parameters) {
        if (isOpcRegister(parameter.parameter))
            continue; // nothing a wizard asks for
        const auto known = encoder.known(parameter.parameter);
        now.push_back({parameter.parameter,
                       known ? valueWithUnit(encoder.device(), {parameter.parameter, known->value},
                                             valueOptionsOf(&encoder))
                             : QString(QChar(0x2013)),
                       known});
    }
    const bool sameDevice = std::ranges::equal(now, rows(), {}, &KnownRow::parameter, &KnownRow::parameter);
    if (!sameDevice) {
        setRows(std::move(now));
        return;
    }
    for (int i = 0; i < rowCount(); ++i)
        if (rowAt(i) != now[static_cast<std::size_t>(i)])
            replace(i, now[static_cast<std::size_t>(i)]);
}

QVariant KnownTable::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int((column == value ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    return column == name ? tr("Parameter") : column == value ? tr("Value") : tr("Known by");
}

QVariant KnownTable::cell(const KnownRow &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return column == name    ? parameterName(row.parameter)
               : column == value ? row.value
                                 : evidenceText(row.known);
    case Qt::TextAlignmentRole:
        return int((column == value ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::FontRole:
        return column == value ? QVariant(numberFont()) : QVariant();
    case Qt::ToolTipRole:
        return evidenceExplanation(row.known);
    default:
        return {};
    }
}

} // namespace codewheel
