// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_link_argument.h"
#include "cli/call/texts.h"
#include "cli/kinds/canopen/canopen_access.h"
#include "cli/kinds/canopen/canopen_link_kind.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "replay/can_log.h"
#include "replay/can_log_link.h"
#include "vocabulary/sentence.h"

#include <QDateTime>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// Which log is meant, and how it is taken.
struct CanLogMeant
{
    QString file{};
    QString interface {};         // empty: that of the first frame
    bool isUsuallyMapped = false; // the user says that the first PDOs hold the position, as CiA 406 has it
};

// A log of a CAN bus at the command line, as if it were the bus: what came then comes again, in virtual time.
// It can be listened to only.
class CanLogAccess final : public CanopenAccess
{
public:
    // Refused as by CanLog::look().
    static Checked<std::unique_ptr<BusAccess>> to(const CanLogMeant &meant, const Catalog &catalog, BusId id);

    Checked<void> open() override;
    std::optional<Complaint> whyNot(const Subcommand &command) const override;
    bool mayHave(NodeId node) const override;
    std::vector<Place> knownPlaces() const override; // of nodes that told something
    bool knowsItsPlaces() const override { return true; }
    // At once: no time passes.
    Checked<EncoderSession *> encoder(const Call &call, NodeId node, bool namesIt) override;
    std::optional<Instant> length() const override;
    QString linkKey() const override;

private:
    CanLogAccess(const CanLogMeant &meant, CanLogSummary summary, const Catalog &catalog, BusId id);
    bool hasHeard(int node) const;

    CanLogMeant m_meant;
    CanLogSummary m_summary;
};

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
               "notOnCanLog",
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
            notDone("nodeSilent",
                    sentence(CommandLine::tr("Node %1 tells nothing in this log. codewheel-cli scan lists "
                                             "those that do."),
                             {address.shown()}),
                    {address.place().toString()}));
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

const QString interfaceKey = QStringLiteral("interface");
const QString mappingKey = QStringLiteral("usual-mapping");

Checked<CanLogMeant> logMeant(LinkText text)
{
    CanLogMeant meant{.file = text.where};
    meant.interface = text.take(interfaceKey).value_or(QString());
    const auto mapping = text.take(mappingKey);
    meant.isUsuallyMapped = mapping.has_value();
    if (mapping && *mapping != QStringLiteral("yes"))
        return badInput("canAgreementWrong",
                        CommandLine::tr("%1 cannot be \"%2\": write %1=yes, or leave it out."),
                        {mappingKey, *mapping});
    if (!text.settings.isEmpty())
        return badInput(
            "unknownCanSetting", CommandLine::tr("A log has no setting \"%1\". Its settings are: %2."),
            {text.settings.front(), QStringList{interfaceKey, mappingKey}.join(QStringLiteral(", "))});
    return meant;
}

// Logs of CAN buses with CANopen at the command line.
class CanLogLinkKind final : public LinkKind
{
public:
    QString bus() const override { return QString::fromLatin1(canopenKind); }
    QStringList schemes() const override { return {QStringLiteral("log")}; }
    bool leadsToPlanned() const override { return false; }
    bool leadsToFile() const override { return true; }
    QString help() const override
    {
        return CommandLine::tr(
            "log:FILE, the log of a CAN bus, which can be listened to, as log:candump.log");
    }
    bool isPlace(const QString &typed) const override { return CanopenAddress::read(typed).has_value(); }
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const override
    {
        return logMeant(text).map([&](const CanLogMeant &meant) {
            return std::vector<MakeLink>{[meant, id = numberOf(*this, project)](const Catalog &catalog) {
                return CanLogAccess::to(meant, catalog, id);
            }};
        });
    }
    // Those of the project are buses that are there.
    Checked<MakeLink> planned(const Project &, BusId, const QStringList &) const override
    {
        return MakeLink();
    }
    MakeLink training(const Project *) const override { return {}; }
    QStringList settingKeys(const QString &) const override { return {interfaceKey, mappingKey}; }
};

} // namespace

std::unique_ptr<const LinkKind> canLogLinkKind()
{
    return std::make_unique<CanLogLinkKind>();
}

} // namespace codewheel
