// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the cells, and what is typed into them.
#include "catalog/hex_code.h"
#include "widgets/look/roles.h"
#include "widgets/structure_editor/plan_model.h"

#include <QLocale>

#include <algorithm>
#include <functional>

namespace codewheel {
namespace {

QString addressCell(const std::optional<AddressRange> &range, AddressRules::Unit unit)
{
    return range ? addressText(range->first, unit) : QString();
}

QString noAddressText(const QString &text, AddressRules::Unit unit)
{
    const int largest = unit == AddressRules::Unit::byte ? largestAddress : largestAddress / 2;
    return PlanModel::tr("%1 is no address. Give a number from 0 to %2, or nothing to have it counted.")
        .arg(text, QLocale().toString(largest));
}

Role worst(const std::vector<Finding> &findings)
{
    const bool isFault = std::ranges::any_of(
        findings, [](const Finding &finding) { return finding.severity == Severity::fault; });
    return isFault ? Role::fault : Role::attention;
}

QString joined(const std::vector<Finding> &findings, const QString &between)
{
    QStringList texts;
    for (const Finding &finding : findings)
        texts << finding.text;
    return texts.join(between);
}

bool isAddress(int column)
{
    return column == PlanModel::inColumn || column == PlanModel::outColumn;
}

} // namespace

QVariant PlanModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const bool inBytes = ringPlan(m_document.project(), m_ring).addresses.unit == AddressRules::Unit::byte;
    switch (section) {
    case numberColumn:
        return tr("Number");
    case stationColumn:
        return tr("Station");
    case groupColumn:
        return tr("Group");
    case deviceColumn:
        return tr("Device");
    case profileColumn:
        return tr("Profile");
    case idCodeColumn:
        return tr("ID code");
    case wordsColumn:
        return tr("Words IN / OUT");
    case inColumn:
        return inBytes ? tr("IN byte") : tr("IN word");
    case outColumn:
        return inBytes ? tr("OUT byte") : tr("OUT word");
    case serialColumn:
        return tr("Serial number");
    case noteColumn:
        return tr("Note");
    case findingsColumn:
        return tr("Findings");
    default:
        return {};
    }
}

QVariant PlanModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const PlanRow &row = rowAt(index);
    switch (role) {
    case Qt::DisplayRole:
        return display(row, index.column());
    case Qt::EditRole:
        return isAddress(index.column()) ? display(row, index.column()).toString().section(u' ', 0, 0)
                                         : display(row, index.column());
    case Qt::DecorationRole:
        return decoration(row, index.column());
    case Qt::ToolTipRole:
        return toolTip(row, index.column());
    case Qt::TextAlignmentRole:
        return isAddress(index.column()) ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    default:
        return {};
    }
}

QVariant PlanModel::display(const PlanRow &row, int column) const
{
    const Participant &device = row.participant;
    switch (column) {
    case numberColumn:
        return device.number.toString();
    case stationColumn:
        return row.station;
    case groupColumn:
        return row.group;
    case deviceColumn:
        return row.name;
    case profileColumn:
        return row.profile;
    case idCodeColumn:
        return QStringLiteral("%1 = %2").arg(hexCode(device.idCode, 2)).arg(device.idCode);
    case wordsColumn:
        return QStringLiteral("%1 / %2").arg(device.inWords).arg(device.outWords);
    case inColumn:
        return addressCell(row.addresses.in, row.unit);
    case outColumn:
        return addressCell(row.addresses.out, row.unit);
    case serialColumn:
        return row.serialNumber;
    case noteColumn:
        return row.note;
    case findingsColumn:
        return joined(row.findings, QStringLiteral(" "));
    default:
        return {};
    }
}

QVariant PlanModel::decoration(const PlanRow &row, int column)
{
    // A finding is seen before its column is scrolled into view.
    if (!row.findings.empty() && (column == numberColumn || column == findingsColumn))
        return lineIcon(roleIcon(worst(row.findings)), worst(row.findings));
    if (column == numberColumn)
        return lineIcon(row.participant.idCode == busTerminalIdCode ? Icon::ring : Icon::encoder);
    return {};
}

QString PlanModel::toolTip(const PlanRow &row, int column)
{
    if (column == findingsColumn)
        return joined(row.findings, QStringLiteral("\n"));
    const auto how = [](const std::optional<AddressRange> &range) {
        if (!range)
            return tr("It has no such words.");
        const QString bytes = tr("Bytes %1 to %2").arg(range->first).arg(range->last());
        return bytes + u'\n' +
               (range->byHand ? tr("Given by hand. Delete the number to have it counted again.")
                              : tr("Counted in ring order. Type a number to give it by hand."));
    };
    if (isAddress(column))
        return how(column == inColumn ? row.addresses.in : row.addresses.out);
    const QString device =
        tr("%1  %2\nID code %3, device code %4\nWords: IN %5, OUT %6")
            .arg(
                row.participant.number.toString(), row.name,
                QStringLiteral("%1 = %2").arg(hexCode(row.participant.idCode, 2)).arg(row.participant.idCode),
                hexCode(row.participant.deviceCode, 4))
            .arg(row.participant.inWords)
            .arg(row.participant.outWords);
    return row.findings.empty() ? device : device + u'\n' + joined(row.findings, QStringLiteral("\n"));
}

QString PlanModel::complaint(const QModelIndex &index, const QString &text) const
{
    const QString typed = text.trimmed();
    const AddressRules::Unit unit = rowAt(index).unit;
    const bool isGood = !isAddress(index.column()) || typed.isEmpty() || parseAddress(typed, unit);
    return isGood ? QString() : noAddressText(typed, unit);
}

bool PlanModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const auto id = idAt(index);
    if (!id || role != Qt::EditRole)
        return false;
    const QString text = value.toString().trimmed();
    if (isAddress(index.column())) {
        setAddress(*id, index.column() == inColumn, text);
        return true;
    }
    const Place number = rowAt(index).place;
    const auto edit = [&](const QString &what, auto field) {
        m_document.editDevice(number, what.arg(number.toString()),
                              [&](ProjectDevice &device) { std::invoke(field, device) = text; });
        return true;
    };
    switch (index.column()) {
    case stationColumn:
        return edit(tr("Station of %1"), &ProjectDevice::station);
    case groupColumn:
        return edit(tr("Group of %1"), &ProjectDevice::group);
    case serialColumn:
        return edit(tr("Serial number of %1"),
                    [](ProjectDevice &device) -> QString & { return device.label.serialNumber; });
    case noteColumn:
        return edit(tr("Note on %1"), &ProjectDevice::note);
    default:
        return false;
    }
}

void PlanModel::setAddress(Id id, bool isIn, const QString &text)
{
    const PlanRow &row = m_nodes.at(id)->shown;
    const auto &now = isIn ? row.addresses.in : row.addresses.out;
    const auto given = parseAddress(text, row.unit);
    if (!text.isEmpty() && !given) {
        Q_EMIT badInput(noAddressText(text, row.unit));
        return;
    }
    // What was only looked at stays automatic.
    const bool isUnchanged =
        now && given &&
        (now->first == *given || addressText(now->first, row.unit).section(u' ', 0, 0) == text);
    if (!now || isUnchanged)
        return;
    const QString number = row.participant.number.toString();
    m_document.editDevice(row.place, (isIn ? tr("IN address of %1") : tr("OUT address of %1")).arg(number),
                          [&](ProjectDevice &device) {
                              (isIn ? device.inAddress : device.outAddress) =
                                  text.isEmpty() ? std::nullopt : given;
                          });
}

Qt::ItemFlags PlanModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return Qt::ItemIsDropEnabled;
    const PlanRow &row = rowAt(index);
    Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsDragEnabled;
    if (row.participant.idCode == busTerminalIdCode)
        flags |= Qt::ItemIsDropEnabled;
    const int column = index.column();
    const bool hasAddress =
        (column == inColumn && row.addresses.in) || (column == outColumn && row.addresses.out);
    const bool isText = column == stationColumn || column == groupColumn || column == noteColumn;
    const bool hasLabel = row.participant.idCode != busTerminalIdCode;
    if (isText || hasAddress || (column == serialColumn && hasLabel))
        flags |= Qt::ItemIsEditable;
    return flags;
}

} // namespace codewheel
