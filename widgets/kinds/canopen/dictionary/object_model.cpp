// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/object_model.h"

#include "kinds/canopen/eds/typed_value.h"
#include "kinds/canopen/protocol/sdo_abort.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/canopen/dictionary/object_texts.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <algorithm>

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

ObjectModel::ObjectModel(QObject *parent)
    : TableModelBase(parent)
{}

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
    row.heard.reset();
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

void ObjectModel::hear(canopen::SdoObject which, canopen::Octets octets, QTime at)
{
    const int position = rowOf(which);
    if (position < 0)
        return;
    ObjectRow row = rowAt(position);
    row.heard = canopen::fileValueOf(row.object.type, octets);
    row.heardAt = at;
    replace(position, std::move(row));
}

void ObjectModel::setDifferences(const std::vector<canopen::ObjectDifference> &differences)
{
    auto next = differences.begin();
    for (int position = 0; position < rowCount(); ++position) {
        const auto order = canopen::orderOf(rowAt(position).object.object);
        while (next != differences.end() && canopen::orderOf(next->object) < order)
            ++next;
        const bool differs = next != differences.end() && canopen::orderOf(next->object) == order;
        if (!differs && !rowAt(position).difference)
            continue;
        ObjectRow row = rowAt(position);
        row.difference = differs ? std::optional(*next) : std::nullopt;
        replace(position, std::move(row));
    }
}

void ObjectModel::setWanted(const std::vector<canopen::WantedObject> &wanted)
{
    for (int position = 0; position < rowCount(); ++position) {
        const auto found =
            std::ranges::find(wanted, rowAt(position).object.object, &canopen::WantedObject::object);
        const auto its = found != wanted.end() ? std::optional(*found) : std::nullopt;
        if (its == rowAt(position).wanted)
            continue;
        ObjectRow row = rowAt(position);
        row.wanted = its;
        replace(position, std::move(row));
    }
}

bool ObjectModel::isDifferent(const ObjectRow &row) const
{
    return row.difference || row.differsFromProject() || row.differsFromFile(m_node);
}

bool ObjectModel::isInOneFileOnly(const ObjectRow &row) const
{
    return row.difference && row.difference->kind != canopen::ObjectDifference::Kind::differs &&
           !row.differsFromProject() && !row.differsFromFile(m_node);
}

std::span<const ColumnHead> ObjectModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Object"), Qt::AlignLeft, QT_TR_NOOP("Index in hexadecimal, and subindex")},
        {QT_TR_NOOP("Name"), Qt::AlignLeft,
         QT_TR_NOOP("As the file of the maker has it, or else CiA 301 and CiA 406")},
        {QT_TR_NOOP("Value"), Qt::AlignLeft,
         QT_TR_NOOP("What the node answered, to us or to others, in hexadecimal and decimal. A mark: not the "
                    "default")},
        {QT_TR_NOOP("Meaning"), Qt::AlignLeft, QT_TR_NOOP("What the bits say, or why there is no value")},
        {QT_TR_NOOP("Access"), Qt::AlignLeft, QT_TR_NOOP("Whether the object can be read and written")},
        {QT_TR_NOOP("Type"), Qt::AlignLeft,
         QT_TR_NOOP("What the file says. How wide a value is, the node tells")},
        {QT_TR_NOOP("Project"), Qt::AlignLeft,
         QT_TR_NOOP("What the project wants the node to have. A mark: the node has another value")},
        {QT_TR_NOOP("In the file"), Qt::AlignLeft,
         QT_TR_NOOP(
             "The value that the file gives this device (ParameterValue). A mark: the node has another")},
        {QT_TR_NOOP("Default"), Qt::AlignLeft,
         QT_TR_NOOP("What the device has when it comes from the maker")},
        {QT_TR_NOOP("Compared with"), Qt::AlignLeft,
         QT_TR_NOOP("The value of the file that is compared with, where it is another")},
        {QT_TR_NOOP("Read"), Qt::AlignLeft,
         QT_TR_NOOP(
             "When the node was asked last. Heard: another master has asked or written, or it was in a PDO")},
    };
    return all;
}

QString ObjectModel::textOf(const ObjectRow &row, int column) const
{
    switch (column) {
    case object:
        return row.object.object.text();
    case name:
        return row.object.name;
    case value:
        return valueTextOf(row.shown(), row.object.type);
    case meaning:
        return meaningOf(row);
    case access:
        return objectAccessText(row.object.access);
    case type:
        return row.object.type ? canopen::dataTypeKey(*row.object.type) : QString();
    case project:
        return row.wanted ? wantedObjectText(*row.wanted, row.object.type) : QString();
    case inFile: {
        const auto its = row.object.value ? row.object.value->at(m_node) : std::nullopt;
        return row.source == ObjectRow::Source::compared
                   ? QString()
                   : valueTextOf(its ? its : row.object.value, row.object.type);
    }
    case factory: {
        const auto its = defaultAt(row.object, m_node);
        return valueTextOf(its ? its : row.object.factory, row.object.type);
    }
    case other:
        return otherOf(row);
    default:
        return timeOf(row);
    }
}

QString ObjectModel::meaningOf(const ObjectRow &row) const
{
    if (row.shown())
        return objectMeaningText(row.object.object, *row.shown());
    if (!row.refused.isEmpty())
        return row.refused;
    switch (row.source) {
    case ObjectRow::Source::compared:
        return tr("Only in the file that is compared with.");
    case ObjectRow::Source::project:
        return tr("Not in the file; the project wants it.");
    case ObjectRow::Source::file:
        break;
    }
    return {};
}

QString ObjectModel::otherOf(const ObjectRow &row) const
{
    if (!row.difference)
        return {};
    if (row.difference->kind == canopen::ObjectDifference::Kind::missing)
        return tr("not there");
    const QString text = valueTextOf(row.difference->other, row.object.type);
    return text.isEmpty() ? tr("there, no value") : text;
}

QString ObjectModel::timeOf(const ObjectRow &row)
{
    const auto format = QStringLiteral("HH:mm:ss");
    if (row.heard)
        return sentence(tr("heard, at %1"), {row.heardAt.toString(format)});
    return row.at.isValid() ? row.at.toString(format) : QString();
}

// Another value than its own is what the eye looks for.
bool ObjectModel::isMarked(const ObjectRow &row, int column) const
{
    return (column == value && row.differsFromDefault(m_node)) ||
           (column == inFile && row.differsFromFile(m_node)) ||
           (column == project && row.differsFromProject());
}

QString ObjectModel::tipOf(const ObjectRow &row, int column) const
{
    const QString text = textOf(row, column);
    if (column == readAt && row.heard && row.now)
        return sentence(tr("%1; read at %2: %3"), {text, row.at.toString(QStringLiteral("HH:mm:ss")),
                                                   valueTextOf(row.now, row.object.type)});
    if (column == value && row.differsFromDefault(m_node))
        return sentence(tr("%1, not the default: %2"), {text, textOf(row, factory)});
    if ((column == inFile || column == project) && isMarked(row, column))
        return sentence(tr("%1, but the node has %2"), {text, textOf(row, value)});
    return text;
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
        return isMarked(row, column) ? QVariant(lineIcon(Icon::setBit, Role::setBit)) : QVariant();
    case Qt::FontRole:
        return column == name || column == type || column == access || column == meaning
                   ? QVariant()
                   : QVariant(numberFont());
    default:
        return {};
    }
}

} // namespace codewheel
