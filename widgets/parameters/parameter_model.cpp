// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_model.h"

#include "catalog/value_text.h"
#include "widgets/look/fonts.h"
#include "widgets/look/roles.h"
#include "widgets/parameters/parameter_words.h"
#include "widgets/wizard/known_text.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {

ParameterModel::ParameterModel(WantedValues &wanted, QObject *parent)
    : TableModelBase(parent)
    , m_wanted(wanted)
{
    connect(&m_wanted, &WantedValues::changed, this, &ParameterModel::refresh);
}

void ParameterModel::setEncoder(EncoderSession *encoder)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    std::vector<ParameterRow> rows;
    if (encoder != nullptr) {
        connect(encoder, &EncoderSession::knownChanged, this, &ParameterModel::refresh);
        for (const ParameterDescription &parameter : encoder->device().parameters)
            if (!isOpcRegister(parameter.parameter))
                rows.push_back(rowFor(parameter));
        std::ranges::stable_partition(rows, std::not_fn(&ParameterRow::isReadOnly));
    }
    setRows(std::move(rows));
}

int ParameterModel::differing() const
{
    return static_cast<int>(std::ranges::count_if(rows(), &ParameterRow::differs));
}

ParameterRow ParameterModel::rowFor(const ParameterDescription &parameter) const
{
    return {parameter, m_encoder->known(parameter.parameter),
            m_wanted.value(m_encoder->number(), parameter.parameter)};
}

void ParameterModel::refresh()
{
    if (!m_encoder)
        return;
    for (int row = 0; row < rowCount(); ++row)
        if (ParameterRow now = rowFor(rowAt(row).parameter); now != rowAt(row))
            replace(row, std::move(now));
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = TableModelBase::flags(index);
    if (index.isValid() && index.column() == wantedColumn && !rowAt(index.row()).isReadOnly())
        flags |= Qt::ItemIsEditable;
    return flags;
}

bool ParameterModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::EditRole || !m_encoder || !(flags(index) & Qt::ItemIsEditable))
        return false;
    const auto number = value.isValid() ? std::optional<std::int64_t>(value.toLongLong()) : std::nullopt;
    m_wanted.set(m_encoder->number(), rowAt(index.row()).parameter.parameter, number);
    return true;
}

QVariant ParameterModel::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant(column == nameColumn ? Qt::AlignLeft | Qt::AlignVCenter
                                             : Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case nameColumn:
        return tr("Parameter");
    case knownColumn:
        return tr("Known");
    default:
        return tr("Wanted");
    }
}

QVariant ParameterModel::cell(const ParameterRow &row, int column, int role) const
{
    const bool isPale = column == knownColumn ? !row.known : column == wantedColumn && !row.wanted;
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::EditRole:
        return column == wantedColumn && row.wanted ? QVariant(qlonglong{*row.wanted}) : QVariant();
    case Qt::ToolTipRole:
        return toolTip(row, column);
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1 %2").arg(text(row, column), detail(row, column)).trimmed();
    case Qt::TextAlignmentRole:
        return QVariant(column == nameColumn ? Qt::AlignLeft | Qt::AlignVCenter
                                             : Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole:
        return column == nameColumn || isPale || !row.parameter.choices.empty() ? textFont() : numberFont();
    case detailRole:
        return detail(row, column);
    case detailMarkRole:
        return column == wantedColumn && row.differs() ? QVariant(static_cast<int>(Role::attention))
                                                       : QVariant();
    case isPaleRole:
        return isPale;
    default:
        return {};
    }
}

// The unit stands behind the value, except where the parameter is called like its unit.
QString ParameterModel::text(const ParameterRow &row, int column) const
{
    const Parameter parameter = row.parameter.parameter;
    if (column == nameColumn)
        return parameterName(parameter);
    if (column == knownColumn) {
        if (!row.known)
            return evidenceText(row.known);
        return unitText(row.parameter.unit) == parameterNameInText(parameter)
                   ? valueText(row.parameter, row.known->value)
                   : valueWithUnit(m_encoder->device(), {parameter, row.known->value});
    }
    if (row.isReadOnly())
        return {};
    return row.wanted ? valueText(row.parameter, *row.wanted) : tr("as it is");
}

QString ParameterModel::detail(const ParameterRow &row, int column) const
{
    if (column == knownColumn && row.known) {
        const QTime time = m_encoder->dateTime(row.known->at).time();
        return tr("%1 %2", "how known, time: read 14:02")
            .arg(evidenceText(row.known), QLocale().toString(time, QLocale::ShortFormat));
    }
    if (column != wantedColumn)
        return {};
    if (row.isReadOnly())
        return tr("read only");
    if (!row.wanted)
        return {};
    if (!row.known)
        return tr("not compared");
    return row.differs() ? tr("differs") : tr("the same");
}

QString ParameterModel::toolTip(const ParameterRow &row, int column) const
{
    const QString range = parameter_words::rangeAndFactory(row.parameter);
    if (column != knownColumn)
        return QStringLiteral("%1\n%2").arg(parameterName(row.parameter.parameter), range);
    const QDateTime when = row.known ? m_encoder->dateTime(row.known->at) : QDateTime();
    const QString how = parameter_words::howKnown(row.known, when);
    return row.known
               ? QStringLiteral("%1\n%2").arg(
                     valueWithUnit(m_encoder->device(), {row.parameter.parameter, row.known->value}), how)
               : how;
}

} // namespace codewheel
