// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/command_list.h"

#include "kinds/esc/line/typed_request.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "vocabulary/sentence.h"
#include "widgets/look/fonts.h"

#include <QLocale>

namespace codewheel {

CommandList::CommandList(QObject *parent)
    : TableModelBase(parent)
{
    const auto commands = esc::allCommands();
    setRows({commands.begin(), commands.end()});
}

void CommandList::setAddress(const QString &digits)
{
    if (digits == m_address)
        return;
    m_address = digits;
    Q_EMIT dataChanged(index(0, request), index(rowCount() - 1, request));
}

void CommandList::setFractionBits(int bits)
{
    if (bits == m_fractionBits)
        return;
    m_fractionBits = bits;
    Q_EMIT dataChanged(index(0, meaning), index(rowCount() - 1, meaning));
}

QString CommandList::meaningOf(const esc::CommandShape &shape) const
{
    const QString name = esc::commandName(shape.command);
    if (!shape.writes)
        return sentence(tr("reads: %1"), {name});
    const esc::ValueRange range = esc::valueRange(shape.command, m_fractionBits);
    return sentence(tr("writes: %1; %2 to %3, up to %4 hexadecimal digits"),
                    {name, bothNotations(range.smallest), bothNotations(range.largest),
                     QLocale().toString(shape.digits)});
}

QVariant CommandList::headerCell(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    return column == request ? tr("Request") : tr("Meaning");
}

QVariant CommandList::cell(const esc::CommandShape &shape, int column, int role) const
{
    if (role == Qt::FontRole && column == request)
        return numberFont();
    if (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole)
        return {};
    if (column == meaning || role == Qt::ToolTipRole)
        return meaningOf(shape);
    return QString(m_address +
                   QLatin1String(shape.letters.data(), static_cast<qsizetype>(shape.letters.size())));
}

} // namespace codewheel
