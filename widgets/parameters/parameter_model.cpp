// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_model.h"

#include "catalog/value_text.h"
#include "vocabulary/freshness_text.h"
#include "vocabulary/known_words.h"
#include "vocabulary/refusal_text.h"
#include "widgets/job/known_text.h"
#include "widgets/look/fonts.h"
#include "widgets/look/roles.h"
#include "widgets/models/age_text.h"
#include "widgets/parameters/parameter_words.h"
#include "widgets/parameters/value_input.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {

namespace {

bool isRegister(const ParameterDescription &parameter)
{
    return parameter.isDetail;
}

bool isWritable(const ParameterDescription &parameter)
{
    return parameter.canBeWritten;
}

bool isReadOnlyValue(const ParameterDescription &parameter)
{
    return !isWritable(parameter) && !isRegister(parameter);
}

// Its heading says so to whoever sees it.
bool isOnlyRead(const ParameterRow &row)
{
    return row.isReadOnly() && !row.isTold();
}

ParameterRow head(ParameterRow::Head kind)
{
    ParameterRow row;
    row.head = kind;
    return row;
}

} // namespace

ParameterModel::ParameterModel(WantedValues &wanted, QObject *parent)
    : TableModelBase(parent)
    , m_wanted(wanted)
{
    connect(&m_wanted, &WantedValues::changed, this, &ParameterModel::refresh);
}

void ParameterModel::setEncoder(const ShownEncoder &encoder)
{
    if (EncoderSession *before = m_encoder.session())
        before->disconnect(this);
    m_encoder = encoder;
    std::vector<ParameterRow> rows;
    if (EncoderSession *session = encoder.session()) {
        connect(session, &EncoderSession::knownChanged, this, &ParameterModel::refresh);
        connect(session, &EncoderSession::freshnessChanged, this, &ParameterModel::showAge);
    }
    if (encoder.isThere()) {
        rows = rowsOf(isWritable);
        const std::vector<ParameterRow> readOnly = rowsOf(isReadOnlyValue);
        if (!readOnly.empty())
            rows.push_back(head(ParameterRow::Head::readOnly));
        rows.insert(rows.end(), readOnly.begin(), readOnly.end());
        if (!rowsOf(isRegister).empty())
            rows.push_back(head(ParameterRow::Head::registersClosed));
    }
    setRows(std::move(rows));
}

std::vector<ParameterRow> ParameterModel::rowsOf(bool (*belongs)(const ParameterDescription &)) const
{
    std::vector<ParameterRow> rows;
    for (const ParameterDescription &parameter : m_encoder.device().parameters)
        if (belongs(parameter))
            rows.push_back(rowFor(parameter));
    return rows;
}

bool ParameterModel::isFoldable(const QModelIndex &index) const
{
    return index.isValid() && rowAt(index.row()).head >= ParameterRow::Head::registersClosed;
}

bool ParameterModel::showsRegisters() const
{
    return std::ranges::find(rows(), ParameterRow::Head::registersOpen, &ParameterRow::head) != rows().end();
}

// The registers are the last rows.
void ParameterModel::toggleRegisters()
{
    const auto isFoldingHead = [](const ParameterRow &row) {
        return row.head >= ParameterRow::Head::registersClosed;
    };
    const auto found = std::ranges::find_if(rows(), isFoldingHead);
    if (found == rows().end())
        return;
    const bool opens = found->head == ParameterRow::Head::registersClosed;
    const int headRow = static_cast<int>(found - rows().begin());
    replace(headRow, head(opens ? ParameterRow::Head::registersOpen : ParameterRow::Head::registersClosed));
    if (opens)
        append(rowsOf(isRegister));
    else
        while (rowCount() > headRow + 1)
            removeAt(rowCount() - 1);
}

int ParameterModel::rowOf(Parameter parameter) const
{
    const auto found = std::ranges::find_if(rows(), [parameter](const ParameterRow &row) {
        return !row.isHead() && row.parameter.parameter == parameter;
    });
    return found == rows().end() ? -1 : static_cast<int>(found - rows().begin());
}

int ParameterModel::differing() const
{
    return static_cast<int>(std::ranges::count_if(rows(), &ParameterRow::differs));
}

QString ParameterModel::whyTaken(const ParameterValue &wanted) const
{
    if (m_encoder.session() == nullptr)
        return {};
    const auto planned = m_encoder.session()->planned({WriteParameters{.values = {wanted}, .previous = {}}});
    return !planned && planned.error().id == RefusalId::lineAddressTaken ? refusalText(planned.error())
                                                                         : QString();
}

ParameterRow ParameterModel::rowFor(const ParameterDescription &parameter) const
{
    return {withRange(parameter), m_encoder.known(parameter.parameter),
            m_wanted.value(m_encoder.place(), parameter.parameter)};
}

// The format of a scaling factor decides its range.
ParameterDescription ParameterModel::withRange(const ParameterDescription &parameter) const
{
    return withOptions(parameter, valueOptionsOf(m_encoder.session()));
}

void ParameterModel::refresh()
{
    if (!m_encoder.isThere())
        return;
    for (int row = 0; row < rowCount(); ++row) {
        if (rowAt(row).isHead())
            continue;
        if (ParameterRow now = rowFor(rowAt(row).parameter); now != rowAt(row))
            replace(row, std::move(now));
    }
}

void ParameterModel::showAge()
{
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, knownColumn), index(rowCount() - 1, knownColumn));
}

// The value was known once, but the encoder has not been heard of since.
bool ParameterModel::isKnownOfBefore(const ParameterRow &row) const
{
    return row.known && m_encoder.session() != nullptr && m_encoder.session()->freshness().isOld();
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = TableModelBase::flags(index);
    if (!index.isValid() || index.column() != wantedColumn)
        return flags;
    const ParameterRow &row = rowAt(index.row());
    if (m_encoder.session() != nullptr && m_encoder.session()->freshness().isOfRecording())
        return flags;
    const bool canBeTold = row.isTold() && m_encoder.session() != nullptr; // whose known value it becomes
    if (!row.isReadOnly() || canBeTold)
        flags |= Qt::ItemIsEditable;
    return flags;
}

bool ParameterModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::EditRole || !m_encoder.isThere() || !(flags(index) & Qt::ItemIsEditable))
        return false;
    const auto typed = valueFromVariant(value);
    if (rowAt(index.row()).isTold())
        m_encoder.session()->tell(rowAt(index.row()).parameter.parameter, typed);
    else
        m_wanted.set(m_encoder.place(), rowAt(index.row()).parameter.parameter, typed);
    return true;
}

std::span<const ColumnHead> ParameterModel::heads() const
{
    static constexpr ColumnHead all[] = {{QT_TR_NOOP("Parameter"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Known"), Qt::AlignRight},
                                         {QT_TR_NOOP("Wanted"), Qt::AlignRight}};
    return all;
}

// Spans all columns.
QVariant ParameterModel::headCell(const ParameterRow &row, int column, int role) const
{
    const bool isReadOnly = row.head == ParameterRow::Head::readOnly;
    const bool isOpen = row.head == ParameterRow::Head::registersOpen;
    const QString name = isReadOnly ? tr("Read only") : tr("Registers of the bus chip");
    switch (role) {
    case Qt::DisplayRole:
        if (column != nameColumn)
            return {};
        return isReadOnly ? name : QStringLiteral("%1 %2").arg(QChar(isOpen ? 0x25BE : 0x25B8)).arg(name);
    case Qt::AccessibleTextRole:
        if (column != nameColumn || isReadOnly)
            return column == nameColumn ? name : QString();
        return isOpen ? tr("%1, open").arg(name) : tr("%1, closed").arg(name);
    case Qt::ToolTipRole:
        if (isReadOnly)
            return tr("What the encoder reports and nobody can write");
        return isOpen ? tr("Click, or Enter: hides the registers")
                      : tr("Click, or Enter: shows the registers of the INTERBUS chip. While they are shown, "
                           "Read from encoder reads them, too.");
    case Qt::FontRole:
        return textFont(TextSize::small);
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    case isPaleRole:
        return isReadOnly;
    default:
        return {};
    }
}

QVariant ParameterModel::cell(const ParameterRow &row, int column, int role) const
{
    if (row.isHead())
        return headCell(row, column, role);
    const bool isPale = column == knownColumn ? !row.known : column == wantedColumn && !row.wanted;
    switch (role) {
    case Qt::EditRole:
        if (column == wantedColumn && row.isTold() && row.known)
            return variantOf(row.known->value);
        return column == wantedColumn ? variantOf(row.wanted) : QVariant();
    case Qt::ToolTipRole:
        return toolTip(row, column);
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1 %2").arg(text(row, column), detail(row, column)).trimmed();
    case Qt::FontRole:
        return column == nameColumn || isPale || !row.parameter.choices.empty() ? textFont() : numberFont();
    case detailRole:
        return column == wantedColumn && isOnlyRead(row) ? QString() : detail(row, column);
    case shortDetailRole: // without the time, which the tooltip gives
        if (column == wantedColumn && isOnlyRead(row))
            return QString();
        return column == knownColumn && row.known ? known_words::word(row.known) : detail(row, column);
    case detailMarkRole:
        return column == wantedColumn && row.differs() ? QVariant(static_cast<int>(Role::attention))
                                                       : QVariant();
    case isPaleRole:
        return isPale || (column == knownColumn && isKnownOfBefore(row));
    default:
        return TableModelBase::cell(row, column, role);
    }
}

// The unit follows the value, unless the parameter's name contains it: "Measuring length in steps".
QString ParameterModel::text(const ParameterRow &row, int column) const
{
    const Parameter parameter = row.parameter.parameter;
    if (column == nameColumn)
        return parameterName(row.parameter);
    const auto shown = [&](const Value &value) {
        const auto options = valueOptionsOf(m_encoder.session());
        return parameterNameInText(parameter).contains(unitText(row.parameter.unit))
                   ? valueText(row.parameter, value, options)
                   : valueWithUnit(m_encoder.device(), {parameter, value}, options);
    };
    if (column == knownColumn)
        return row.known ? shown(row.known->value) : known_words::word(row.known);
    if (row.isTold())
        return m_encoder.session() != nullptr ? tr("set it") : QString();
    if (row.isReadOnly())
        return {};
    return row.wanted ? shown(*row.wanted) : tr("unchanged");
}

QString ParameterModel::detail(const ParameterRow &row, int column) const
{
    if (column == knownColumn && m_encoder.session() != nullptr &&
        m_encoder.session()->freshness().isOfRecording()) // which does not say how it came to be known
        return row.known ? tr("recorded", "value") : freshnessBrief(Freshness::Reason::notRecorded);
    if (column == knownColumn && row.known) {
        const QTime time = m_encoder.session()->dateTime(row.known->at).time();
        return tr("%1 %2", "how known, time: read 14:02")
            .arg(known_words::word(row.known), QLocale().toString(time, QLocale::ShortFormat));
    }
    if (column == knownColumn && m_encoder.session() != nullptr && !row.isTold())
        return m_encoder.can().reads ? tr("not read yet") : tr("cannot be read");
    if (column != wantedColumn)
        return {};
    if (row.isTold())
        return tr("from its label");
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
        return row.isTold() && m_encoder.session() == nullptr
                   ? tr("%1\nIt can be set once the encoder is connected.").arg(parameterName(row.parameter))
                   : QStringLiteral("%1\n%2").arg(parameterName(row.parameter), range);
    if (m_encoder.session() == nullptr)
        return tr("Not connected: what the encoder has is not known.");
    QString how = howKnown(row.known, *m_encoder.session());
    if (isKnownOfBefore(row))
        how += u'\n' + ageSentence(*m_encoder.session());
    if (!row.known)
        how = (how + u'\n' + whyNotToldByWord(row.parameter.parameter, *m_encoder.session())).trimmed();
    return row.known ? QStringLiteral("%1\n%2").arg(valueWithUnit(m_encoder.device(),
                                                                  {row.parameter.parameter, row.known->value},
                                                                  valueOptionsOf(m_encoder.session())),
                                                    how)
                     : how;
}

} // namespace codewheel
