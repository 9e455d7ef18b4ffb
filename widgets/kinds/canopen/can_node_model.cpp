// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/can_node_model.h"

#include "kinds/canopen/bus/canopen_session.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QLocale>

#include <set>

namespace codewheel {
namespace {

const QString nothingToTell = QStringLiteral("\u2013");

// Its number is the row's own column; that it is doubled stands with its errors.
bool isShownFact(const CanopenNodeFact &fact)
{
    const QLatin1String key(fact.key);
    return key != QLatin1String("node") && key != QLatin1String("doubled");
}

std::vector<const CanopenNodeFact *> shownFacts()
{
    std::vector<const CanopenNodeFact *> shown;
    for (const CanopenNodeFact &fact : canopenNodeFacts())
        if (isShownFact(fact))
            shown.push_back(&fact);
    return shown;
}

// That of the newest error is the last of what is wrong.
QString factText(const CanopenNodeFact &fact, const CanopenSnapshot::Node &node)
{
    return QLatin1String(fact.key) == QLatin1String("error") ? nodeTroubles(node).join(QStringLiteral("; "))
                                                             : fact.text(node);
}

} // namespace

CanNodeModel::CanNodeModel(QObject *parent)
    : TableModelBase(parent)
{}

int CanNodeModel::columns() const
{
    static const int all = firstFact + static_cast<int>(shownFacts().size()) + 1;
    return all;
}

int CanNodeModel::rowOf(int wanted) const
{
    const auto found = std::ranges::find(rows(), wanted, &CanNodeRow::node);
    return found == rows().end() ? -1 : static_cast<int>(found - rows().begin());
}

CanNodeRow CanNodeModel::rowFor(const CanopenSession &bus, int number)
{
    CanNodeRow row{.node = number, .name = {}, .facts = {}, .since = {}};
    const Place place = bus.placeOf(CanopenAddress{number}.place());
    if (const EncoderSession *encoder = bus.encoder(place))
        row.name = encoder->device().fullName();
    const CanopenSnapshot::Node *heard = bus.latest().heard(number);
    row.isHeard = heard != nullptr;
    if (heard == nullptr) {
        m_conditions.erase(number);
        return row;
    }
    for (const CanopenNodeFact *fact : shownFacts())
        row.facts.push_back(factText(*fact, *heard));
    row.isInTrouble = !nodeTroubles(*heard).isEmpty();
    auto [condition, isNew] = m_conditions.try_emplace(number);
    if (isNew || condition->second.facts != row.facts)
        condition->second = {row.facts,
                             bus.dateTime(bus.now()).toLocalTime().toString(QStringLiteral("HH:mm:ss"))};
    row.since = condition->second.since;
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
    if (column == name)
        return isTip ? tr("What its encoder is taken for. Nothing: it is no encoder of this bus")
                     : tr("Name");
    if (column == sinceColumn())
        return isTip ? tr("When its state, heartbeat and errors became what they are") : tr("Since");
    const CanopenNodeFact &fact =
        column == node
            ? canopenNodeFacts().front()
            : *shownFacts().at(static_cast<std::size_t>(column) - static_cast<std::size_t>(firstFact));
    return isTip ? fact.toolTip() : fact.label();
}

QString CanNodeModel::textOf(const CanNodeRow &row, int column) const
{
    if (column == node)
        return CanopenAddress{row.node}.shown();
    if (column == name)
        return row.name.isEmpty() ? nothingToTell : row.name;
    if (!row.isHeard)
        return column == firstFact ? tr("not heard") : nothingToTell;
    const QString text =
        column == sinceColumn()
            ? row.since
            : row.facts.at(static_cast<std::size_t>(column) - static_cast<std::size_t>(firstFact));
    return text.isEmpty() ? nothingToTell : text;
}

QVariant CanNodeModel::cell(const CanNodeRow &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return textOf(row, column);
    case Qt::DecorationRole:
        if (column != node)
            return {};
        return lineIcon(row.isInTrouble ? Icon::fault
                        : row.isHeard   ? Icon::running
                                        : Icon::inactive,
                        row.isInTrouble ? Role::fault
                        : row.isHeard   ? Role::running
                                        : Role::inactive);
    case Qt::FontRole:
        return column == node || column == sinceColumn() ? QVariant(numberFont()) : QVariant();
    default:
        return {};
    }
}

} // namespace codewheel
