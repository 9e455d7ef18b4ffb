// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/can_log_access.h"

#include "can/can_link_argument.h"
#include "cli/call/texts.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "replay/can_log_link.h"
#include "vocabulary/sentence.h"

#include <QDateTime>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr std::array onLogs{"scan", "monitor", "record"};

// Without a date it does not begin today.
QDateTime beginOf(const CanLogSummary &summary)
{
    const auto first = std::chrono::floor<std::chrono::milliseconds>(summary.first);
    return QDateTime::fromMSecsSinceEpoch(summary.isSince1970 ? first.count() : 0, Qt::UTC);
}

// The bus that was logged, where it has the name of an interface.
CanopenLink linkLike(const CanLogSummary &summary)
{
    CanopenLink link{.isLog = true};
    const QString name = QStringLiteral("can:") + QString::fromStdString(summary.interface);
    if (parseCanLink(name))
        link.settings.link = name;
    return link;
}

} // namespace

Checked<std::unique_ptr<BusAccess>> CanLogAccess::to(const CanLogMeant &meant, const Catalog &catalog,
                                                     BusId id)
{
    const auto summary = CanLog(meant.file, meant.interface.toStdString()).look();
    if (!summary)
        return tl::unexpected(complaintAbout(summary.error()));
    return std::unique_ptr<BusAccess>(new CanLogAccess(meant, *summary, catalog, id));
}

CanLogAccess::CanLogAccess(const CanLogMeant &meant, CanLogSummary summary, const Catalog &catalog, BusId id)
    : CanopenAccess(linkLike(summary), std::make_unique<CanopenSession>(
                                           std::make_unique<CanLogLink>(meant.file, summary.interface),
                                           catalog, beginOf(summary), nullptr, id))
    , m_meant(meant)
    , m_summary(std::move(summary))
{
    if (m_meant.isUsuallyMapped)
        session().takeUsualMapping();
}

Checked<void> CanLogAccess::open()
{
    if (session().isOpen())
        return {};
    const auto opened = session().open({}, CanopenSession::Start::watching, CanopenSession::Drive::byHand);
    return opened ? Checked<void>() : tl::unexpected(complaintAbout(opened.error()));
}

std::optional<Complaint> CanLogAccess::whyNot(const Subcommand &command) const
{
    if (std::ranges::find(onLogs, std::string_view(command.name)) != onLogs.end())
        return std::nullopt;
    return badInput(
               QStringLiteral("notOnCanLog"),
               CommandLine::tr("%1 is a log: what is in it is over. It can be looked at by scan, monitor "
                               "and record."),
               {m_meant.file})
        .value();
}

bool CanLogAccess::hasHeard(int node) const
{
    using What = canopen::CobId::Service;
    constexpr std::array services{What::errorControl, What::emcy, What::sdoAnswer};
    const auto has = [&](const canopen::CobId &what) {
        return m_summary.identifiers.contains(what.identifier());
    };
    constexpr int predefinedPdos = 4;
    for (int number = 1; number <= predefinedPdos; ++number)
        if (has({What::tpdo, node, number}))
            return true;
    return std::ranges::any_of(services, [&](What service) { return has({service, node}); });
}

bool CanLogAccess::mayHave(NodeId node) const
{
    return hasHeard(CanopenAddress::of(node).node);
}

std::vector<Place> CanLogAccess::knownPlaces() const
{
    std::vector<Place> places;
    for (int node = 1; node <= canopen::lastNode; ++node)
        if (hasHeard(node))
            places.push_back(bus().placeOf(CanopenAddress{node}.place()));
    return places;
}

Checked<EncoderSession *> CanLogAccess::encoder(const Call &call, NodeId node, bool /*namesIt*/)
{
    if (const auto opened = open(); !opened)
        return tl::unexpected(opened.error());
    const CanopenAddress address = CanopenAddress::of(node);
    if (!hasHeard(address.node))
        return tl::unexpected(
            Complaint{ExitCode::refused,
                      QStringLiteral("nodeSilent"),
                      sentence(CommandLine::tr("Node %1 tells nothing in this log. codewheel-cli scan lists "
                                               "those that do."),
                               {address.shown()}),
                      {address.place().toString()}});
    if (session().encoder(node) == nullptr) {
        const auto device = deviceOnNode(call, bus().placeOf(address.place()));
        if (!device)
            return tl::unexpected(device.error());
        if (const auto added = session().add(address.node, device->isEmpty() ? usualDeviceOnNode() : *device);
            !added)
            return tl::unexpected(complaintAbout(added.error()));
    }
    return session().encoder(node);
}

// To the last frame, and what is told of it.
std::optional<Instant> CanLogAccess::length() const
{
    constexpr Instant untilTold = std::chrono::milliseconds(200);
    return m_summary.length() + untilTold;
}

QString CanLogAccess::linkKey() const
{
    return m_meant.file;
}

} // namespace codewheel
