// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/object_model.h"

#include "kinds/canopen/eds/octets_value.h"
#include "kinds/canopen/protocol/sdo_abort.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/canopen/dictionary/object_texts.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

namespace codewheel {
namespace {

const QString noValueText = QStringLiteral("\u2013");

// With the number of the node where that is needed and known.
std::optional<canopen::FileValue> defaultAt(const canopen::FileObject &object, std::optional<int> node)
{
    return object.factory ? object.factory->at(node) : std::nullopt;
}

QString valueTextOf(const std::optional<canopen::FileValue> &value, std::optional<canopen::DataType> type)
{
    return value ? objectValueText(*value, type) : QString();
}

} // namespace

bool ObjectRow::differsFromDefault(std::optional<int> node) const
{
    const auto its = defaultAt(object, node);
    return now && its && *now != *its;
}

ObjectModel::ObjectModel(QObject *parent)
    : TableModelBase(parent)
{}

std::vector<ObjectRow> ObjectModel::rowsOf(const canopen::DeviceFile &file)
{
    std::vector<ObjectRow> made;
    made.reserve(file.objects.size());
    for (const canopen::FileObject &each : file.objects)
        made.push_back({.object = each});
    return made;
}

void ObjectModel::show(std::vector<ObjectRow> shown, std::optional<int> node)
{
    m_node = node;
    setRows(std::move(shown));
}

int ObjectModel::rowOf(canopen::SdoObject wanted) const
{
    const auto found = std::ranges::lower_bound(
        rows(), orderOf(wanted), {}, [](const ObjectRow &row) { return orderOf(row.object.object); });
    return found != rows().end() && found->object.object == wanted ? static_cast<int>(found - rows().begin())
                                                                   : -1;
}

void ObjectModel::take(canopen::SdoObject which, const canopen::SdoOutcome &outcome, QTime at)
{
    using Kind = canopen::SdoOutcome::Kind;
    const int position = rowOf(which);
    if (position < 0)
        return;
    ObjectRow row = rowAt(position);
    row.at = at;
    row.now.reset();
    row.refused.clear();
    if (outcome.kind == Kind::read)
        row.now = canopen::fileValueOf(row.object.type, outcome.value);
    else if (outcome.kind == Kind::aborted) {
        const QString why = canopen::sdoAbortText(outcome.abortCode);
        row.refused = why.isEmpty() ? sentence(tr("Aborted with %1h."), {hexWord(outcome.abortCode)}) : why;
    } else
        row.refused = tr("No answer.");
    replace(position, std::move(row));
}

void ObjectModel::setDifferences(const std::vector<canopen::ObjectDifference> &differences)
{
    std::vector<ObjectRow> compared = rows();
    for (ObjectRow &row : compared)
        row.difference.reset();
    for (const canopen::ObjectDifference &each : differences)
        if (const int row = rowOf(each.object); row >= 0)
            compared[static_cast<std::size_t>(row)].difference = each;
    for (int row = 0; row < rowCount(); ++row)
        if (compared[static_cast<std::size_t>(row)].difference || rowAt(row).difference)
            replace(row, std::move(compared[static_cast<std::size_t>(row)]));
}

QVariant ObjectModel::headerCell(int column, int role) const
{
    struct Heading
    {
        QString text;
        QString tip;
    };
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const Heading headings[] = {
        {tr("Object"), tr("Index in hexadecimal, and subindex")},
        {tr("Name"), tr("As the file of the maker has it, or else CiA 301 and CiA 406")},
        {tr("Type"), tr("What the file says. How wide a value is, the node tells")},
        {tr("Access"), tr("Whether the object can be read and written")},
        {tr("Default"), tr("What the device has when it comes from the maker")},
        {tr("Value"), tr("What the node answered, in hexadecimal and decimal. A mark: not the default")},
        {tr("Meaning"), tr("What the bits say, or why there is no value")},
        {tr("Compared with"), tr("The value of the file that is compared with, where it is another")},
        {tr("Read"), tr("When the node was asked last")},
    };
    const Heading &heading = headings[column];
    return role == Qt::DisplayRole ? heading.text : heading.tip;
}

QString ObjectModel::textOf(const ObjectRow &row, int column) const
{
    switch (column) {
    case object:
        return row.object.object.text();
    case name:
        return row.object.name;
    case type:
        return row.object.type ? canopen::dataTypeKey(*row.object.type) : QString();
    case access:
        return objectAccessText(row.object.access);
    case factory: {
        const auto its = defaultAt(row.object, m_node);
        return valueTextOf(its ? its : row.object.factory, row.object.type);
    }
    case value:
        return valueTextOf(row.now, row.object.type);
    case meaning:
        return row.now ? objectMeaningText(row.object.object, *row.now) : row.refused;
    case other:
        return !row.difference ? QString()
               : row.difference->kind == canopen::ObjectDifference::Kind::missing
                   ? tr("not there")
                   : valueTextOf(row.difference->other, row.object.type);
    default:
        return row.at.isValid() ? row.at.toString(QStringLiteral("HH:mm:ss")) : QString();
    }
}

QString ObjectModel::tipOf(const ObjectRow &row, int column) const
{
    const QString text = textOf(row, column);
    return column == value && row.differsFromDefault(m_node)
               ? sentence(tr("%1, not the default: %2"), {text, textOf(row, factory)})
               : text;
}

QVariant ObjectModel::cell(const ObjectRow &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole: {
        const QString text = textOf(row, column);
        return text.isEmpty() && (column == value || column == factory) ? noValueText : text;
    }
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return tipOf(row, column);
    case Qt::DecorationRole:
        return column == value && row.differsFromDefault(m_node)
                   ? QVariant(lineIcon(Icon::setBit, Role::setBit))
                   : QVariant();
    case Qt::FontRole:
        return column == object || column == value || column == factory || column == other || column == readAt
                   ? QVariant(numberFont())
                   : QVariant();
    default:
        return {};
    }
}

} // namespace codewheel
