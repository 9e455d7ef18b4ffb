// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/can_node_model.h"

#include "kinds/canopen/bus/canopen_session.h"
#include "vocabulary/sentence.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <array>
#include <set>

namespace codewheel {
namespace {

const QString nothingToTell = QStringLiteral("\u2013");

// What stands below its NMT state.
constexpr std::array besideState{"heartbeat", "sendsPdos"};

const CanopenNodeFact &nodeFact(const char *key)
{
    return *std::ranges::find_if(canopenNodeFacts(), [key](const CanopenNodeFact &fact) {
        return QLatin1String(fact.key) == QLatin1String(key);
    });
}

// "pre-operational", "Heartbeat: comes".
QString stateWithMore(const CanopenSnapshot::Node &node)
{
    const QString state = nodeFact("state").text(node);
    QStringList lines{state.isEmpty() ? CanNodeModel::tr("state not known") : state};
    for (const char *key : besideState)
        if (const QString text = nodeFact(key).text(node); !text.isEmpty())
            lines << sentence(CanNodeModel::tr("%1: %2", "of a node"), {nodeFact(key).label(), text});
    return lines.join(u'\n');
}

} // namespace

CanNodeModel::CanNodeModel(QObject *parent)
    : TableModelBase(parent)
{}

int CanNodeModel::columns() const
{
    return columnCountOfIt;
}

int CanNodeModel::rowOf(int wanted) const
{
    const auto found = std::ranges::find(rows(), wanted, &CanNodeRow::node);
    return found == rows().end() ? -1 : static_cast<int>(found - rows().begin());
}

CanNodeRow CanNodeModel::rowFor(const CanopenSession &bus, int number)
{
    CanNodeRow row{.node = number, .name = {}, .state = {}, .errors = {}, .since = {}};
    const Place place = bus.placeOf(CanopenAddress{number}.place());
    if (const EncoderSession *encoder = bus.encoder(place))
        row.name = encoder->device().fullName();
    const CanopenSnapshot::Node *heard = bus.latest().heard(number);
    row.isHeard = heard != nullptr;
    if (heard == nullptr) {
        m_conditions.erase(number);
        return row;
    }
    row.state = stateWithMore(*heard);
    row.errors = nodeTroubles(*heard).join(QStringLiteral("; "));
    auto [condition, isNew] = m_conditions.try_emplace(number);
    Condition &known = condition->second;
    if (isNew || known.state != row.state || known.errors != row.errors || known.bootUps != heard->bootUps)
        known = {row.state, row.errors, heard->bootUps,
                 bus.dateTime(bus.now()).toLocalTime().toString(QStringLiteral("HH:mm:ss"))};
    row.isInTrouble = !row.errors.isEmpty();
    const auto nmtState = heard->stateOrCommanded();
    row.isWaiting = heard->hasBooted || nmtState == canopen::NmtState::stopped ||
                    nmtState == canopen::NmtState::preOperational;
    row.since = known.since;
    row.isOld = !bus.latest().connected;
    return row;
}

void CanNodeModel::show(const CanopenSession *bus)
{
    std::set<int> numbers;
    if (bus != nullptr && bus->isOpen()) {
        for (const Place place : bus->places())
            numbers.insert(CanopenAddress::of(place.node).node);
        for (const CanopenSnapshot::Node &heard : bus->latest().nodes)
            numbers.insert(heard.node);
    } else {
        m_conditions.clear();
    }
    std::vector<CanNodeRow> fresh;
    for (const int number : numbers)
        fresh.push_back(rowFor(*bus, number));
    if (!std::ranges::equal(fresh, rows(), {}, &CanNodeRow::node, &CanNodeRow::node)) {
        setRows(std::move(fresh));
        return;
    }
    for (std::size_t i = 0; i < fresh.size(); ++i)
        if (fresh[i] != rows()[i])
            replace(static_cast<int>(i), std::move(fresh[i]));
}

QVariant CanNodeModel::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const bool isTip = role == Qt::ToolTipRole;
    switch (column) {
    case node:
        return isTip ? nodeFact("node").toolTip() + u'\n' +
                           tr("Below it what its encoder is taken for; nothing: it is no encoder of this bus")
                     : nodeFact("node").label();
    case state:
        return isTip
                   ? nodeFact("state").toolTip() + u'\n' +
                         tr("Below it heartbeat and PDOs, and since when state and errors are what they are")
                   : nodeFact("state").label();
    default:
        return isTip ? nodeFact("error").toolTip() : nodeFact("error").label();
    }
}

QString CanNodeModel::text(const CanNodeRow &row, int column) const
{
    if (column == node) {
        const QString number = CanopenAddress{row.node}.shown();
        return row.name.isEmpty() ? number : number + u'\n' + row.name;
    }
    if (column == error)
        return row.errors.isEmpty() ? nothingToTell : row.errors;
    if (!row.isHeard)
        return tr("not heard");
    const QString since = row.state + u'\n' + sentence(tr("since %1", "a time of day"), {row.since});
    return row.isOld ? tr("before the link was lost:") + u'\n' + since : since;
}

QVariant CanNodeModel::cell(const CanNodeRow &row, int column, int role) const
{
    if (role != Qt::DecorationRole || column != node)
        return TableModelBase::cell(row, column, role);
    if (row.isOld)
        return lineIcon(Icon::inactive, Role::inactive);
    if (row.isInTrouble)
        return lineIcon(Icon::fault, Role::fault);
    if (row.isWaiting)
        return lineIcon(Icon::attention, Role::attention);
    return row.isHeard ? lineIcon(Icon::running, Role::running) : lineIcon(Icon::inactive, Role::inactive);
}

} // namespace codewheel
