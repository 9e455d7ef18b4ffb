// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_checks.h"

#include "bus/bus_outline.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_facts.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/device_profile.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace codewheel {
namespace {

constexpr double muchLoad = 0.85;

// The translation context of these texts.
struct CanopenCheckText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenChecks)
};

DataCheck canLinkCheck(const CanopenSession &bus)
{
    DataCheck check = linkCheck(bus, sentence(CanopenCheckText::tr("%1, %2 kBit/s"),
                                              {bus.linkName(), QLocale().toString(bus.rate() / 1'000)}));
    if (bus.state() != BusState::lost || !bus.latest().whyLost)
        return check;
    check.remedy = refusalText(*bus.latest().whyLost);
    check.why = bus.latest().whyLost;
    return check;
}

// In Watch nobody may be asked, and everybody is heard.
DataCheck askingCheck(const CanopenSession &bus)
{
    const DataStep step{DataCheck::Id::running, CanopenCheckText::tr("Listening and asking"),
                        CanopenCheckText::tr("runs")};
    const QString came = bus.outline().state().word;
    if (!bus.isRunning())
        return step.failed(came, CanopenCheckText::tr("No node is asked: that was stopped. Start it."),
                           DataCheck::Action::start);
    const CanopenSnapshot &latest = bus.latest();
    if (const auto held = whyHeldBack(latest))
        return step.remark(came, refusalText(*held));
    return step.passed(came);
}

struct NoFrames
{
    QString came;
    QString remedy;
};

std::optional<NoFrames> whyNoFrames(const CanopenSession &bus)
{
    const CanopenSnapshot &latest = bus.latest();
    const CanopenFigures &figures = latest.figures;
    if (figures.notAcknowledged > 0)
        return NoFrames{
            CanopenCheckText::tr("nobody acknowledges what is sent"),
            CanopenCheckText::tr("Nobody on the bus takes what is sent. Check the rate, the wires and both "
                                 "terminators, and that a device is connected that does not only listen.")};
    if (figures.received > 0)
        return std::nullopt;
    if (figures.errorFrames == 0)
        return NoFrames{CanopenCheckText::tr("none"),
                        CanopenCheckText::tr("Nothing is heard on the bus. Check the supply of the devices "
                                             "and the wires. Nodes that wait to be asked are silent, too: in "
                                             "Operate they are asked.")};
    if (bus.isOperating())
        return NoFrames{CanopenCheckText::tr("only errors"),
                        CanopenCheckText::tr("Only disturbed frames are heard. The rate differs from that of "
                                             "the bus, or wires or terminators are missing.")};
    return NoFrames{CanopenCheckText::tr("only errors"),
                    CanopenCheckText::tr("Only disturbed frames are heard. The rate differs from that of the "
                                         "bus, or a single device is there: its frames are acknowledged by "
                                         "nobody while they are only watched.")};
}

// Here and there one is nothing.
bool isDisturbed(const CanopenSnapshot &bus)
{
    constexpr std::uint64_t manyErrors = 100;
    constexpr std::uint64_t framesForEach = 100;
    const bool isInErrors = bus.status.state == CanState::warning || bus.status.state == CanState::passive;
    const std::uint64_t errors = bus.figures.errorFrames;
    return isInErrors || (errors >= manyErrors && errors * framesForEach > bus.figures.received);
}

DataCheck framesCheck(const CanopenSession &bus)
{
    const DataStep step{DataCheck::Id::bytes, CanopenCheckText::tr("Frames"), CanopenCheckText::tr("some")};
    const QString received = QLocale().toString(qulonglong{bus.latest().figures.received});
    if (const auto why = whyNoFrames(bus))
        return step.failed(why->came, why->remedy, DataCheck::Action::connection);
    const double load = bus.latest().figures.load;
    if (isDisturbed(bus.latest()))
        return step.remark(
            received, sentence(CanopenCheckText::tr("Error frames: %1, others: %2. Frames are disturbed: two "
                                                    "devices may have one number, one may have another "
                                                    "rate, or a terminator or a wire is missing."),
                               {QLocale().toString(qulonglong{bus.latest().figures.errorFrames}), received}));
    if (load < muchLoad)
        return step.passed(received);
    return step.remark(received, sentence(CanopenCheckText::tr("The bus is %1 % full: what has a high "
                                                               "identifier may come late or not at all."),
                                          {QLocale().toString(std::lround(load * 100))}));
}

DataCheck protocolCheck(const CanopenSession &bus)
{
    const DataStep step{DataCheck::Id::sense, CanopenCheckText::tr("Protocol"), QStringLiteral("CANopen")};
    if (bus.latest().figures.isOnlyJ1939())
        return step.failed(QStringLiteral("J1939"),
                           CanopenCheckText::tr("All frames have 29 bits: what is there speaks J1939, not "
                                                "CANopen. It is another variant of the device."));
    return step.passed();
}

QString heardNumbers(const CanopenSession &bus)
{
    QStringList numbers;
    for (const CanopenSnapshot::Node &node : bus.latest().nodes)
        numbers << QString::number(node.node);
    return numbers.isEmpty() ? CanopenCheckText::tr("no node") : numbers.join(QStringLiteral(", "));
}

// Whether it is there at all, and alone with its number.
DataCheck heardCheck(const CanopenSession &bus, int number)
{
    const DataStep step{DataCheck::Id::reached, CanopenCheckText::tr("Node on the bus"),
                        CanopenCheckText::tr("heard")};
    const CanopenSnapshot::Node *node = bus.latest().heard(number);
    if (node == nullptr)
        return step.failed(
            sentence(CanopenCheckText::tr("heard: %1"), {heardNumbers(bus)}),
            sentence(CanopenCheckText::tr("Node %1 was not heard. It may have another number or another "
                                          "rate, be switched off, or be silent until it is asked."),
                     {QString::number(number)}),
            DataCheck::Action::search);
    if (node->isDoubled)
        return step.failed(CanopenCheckText::tr("twice"),
                           canopenFaultOf(bus, bus.placeOf(CanopenAddress{number}.place()))->text);
    if (node->heartbeat == canopen::Heartbeat::lost)
        return step.failed(CanopenCheckText::tr("its heartbeat is lost"),
                           canopenFaultOf(bus, bus.placeOf(CanopenAddress{number}.place()))->text);
    const Freshness freshness = bus.encoder(CanopenAddress{number}.place())->freshness();
    if (freshness.reason() == Freshness::Reason::silent && isDisturbed(bus.latest()))
        return step.failed(
            CanopenCheckText::tr("heard, and silent"),
            sentence(CanopenCheckText::tr("Node %1 was heard and does not answer, and frames are disturbed: "
                                          "two devices may have its number. Connect one of them alone. If "
                                          "it is the only one, see to rate, terminators and wires."),
                     {QString::number(number)}));
    return step.passed();
}

// The data may come all the same, and mean something else.
DataCheck otherProfileCheck(std::uint32_t deviceType, int number)
{
    const QString told = canopen::profileText(canopen::profileOf(deviceType));
    const DataStep step{DataCheck::Id::kind, CanopenCheckText::tr("Device profile"),
                        canopen::profileText(canopen::encoderProfile)};
    return step.failed(
        told, sentence(CanopenCheckText::tr("Node %1 tells the device profile %2 (object 1000h), not that of "
                                            "encoders: what it sends means something else, and no values are "
                                            "written to it. See whether the right device has this number."),
                       {QString::number(number), told}));
}

// The data comes all the same.
void addKeptIdentifiers(DataChecks &checks, const CanopenSnapshot::Node *node)
{
    if (node == nullptr)
        return;
    for (const canopen::KeptIdentifier &kept : node->kept)
        checks.push_back(DataStep{DataCheck::Id::answer,
                                  sentence(CanopenCheckText::tr("Identifier of %1"), {kept.name()}),
                                  hexNumber(kept.predefined, 3)}
                             .remark(hexNumber(kept.identifier, 3), messageText(kept.message())));
}

QString stateText(const CanopenSnapshot::Node *node)
{
    const QString text = node != nullptr ? nodeStateText(*node) : QString();
    return text.isEmpty() ? CanopenCheckText::tr("not known") : text;
}

DataCheck nodeStateCheck(const CanopenSession &bus, int number)
{
    using canopen::NmtState;
    const DataStep step{DataCheck::Id::state, CanopenCheckText::tr("State of the node"),
                        nmtStateText(NmtState::operational)};
    const CanopenSnapshot::Node *node = bus.latest().heard(number);
    const auto state = node != nullptr ? node->stateOrCommanded() : std::nullopt;
    if (state == NmtState::stopped)
        return step.failed(stateText(node),
                           CanopenCheckText::tr("The node is stopped: it sends no positions and answers "
                                                "nothing. Start it (NMT), in Operate."),
                           bus.isOperating() ? DataCheck::Action::startNode : DataCheck::Action::operate);
    if (state == NmtState::preOperational && !bus.isOperating())
        return step.failed(stateText(node),
                           CanopenCheckText::tr("The node is pre-operational: it sends no positions by "
                                                "itself. Start it (NMT), or switch to Operate, where it is "
                                                "asked for them."),
                           DataCheck::Action::operate);
    if (node != nullptr && node->hasBooted)
        return step.remark(
            stateText(node),
            CanopenCheckText::tr("The node has booted, and does not tell its state: most then wait "
                                 "to be started (NMT), some start by themselves."),
            bus.isOperating() ? DataCheck::Action::startNode : DataCheck::Action::operate);
    if (state != NmtState::preOperational)
        return step.passed(stateText(node));
    return step.remark(
        stateText(node),
        CanopenCheckText::tr("The node is pre-operational: it is asked for its position. Its PDOs "
                             "come once it is started (NMT)."),
        DataCheck::Action::startNode);
}

DataCheck nodeAlarmCheck(const CanopenSession &bus, Place place)
{
    const DataStep step{DataCheck::Id::alarms, CanopenCheckText::tr("Alarms and warnings"),
                        CanopenCheckText::tr("none")};
    const auto fault = canopenFaultOf(bus, place);
    return fault ? step.faulty(*fault) : step.passed();
}

void addOfNode(DataChecks &checks, const CanopenSession &bus, NodeId node,
               const std::vector<Participant> &planned)
{
    const int number = CanopenAddress::of(node).node;
    const bool isAdded = bus.encoder(node) != nullptr;
    if (isAdded) {
        checks.push_back(heardCheck(bus, number));
        if (const auto *heard = bus.latest().heard(number);
            heard != nullptr && canopen::isOfOtherProfile(heard->deviceType))
            checks.push_back(otherProfileCheck(*heard->deviceType, number));
        checks.push_back(nodeStateCheck(bus, number));
        checks.push_back(canopenPdoCheck(bus, number));
        addKeptIdentifiers(checks, bus.latest().heard(number));
    }
    checks.push_back(kindCheck(bus, node, planned));
    if (!isAdded)
        return;
    checks.push_back(upToDateCheck(bus, node));
    checks.push_back(nodeAlarmCheck(bus, bus.placeOf(node)));
    checks.push_back(positionCheck(bus, node));
}

} // namespace

DataChecks canopenChecks(const CanopenSession &bus, NodeId node, const std::vector<Participant> &planned)
{
    DataChecks checks{canLinkCheck(bus)};
    if (!bus.isOpen())
        return checks;
    checks.push_back(askingCheck(bus));
    checks.push_back(framesCheck(bus));
    checks.push_back(protocolCheck(bus));
    if (node.isEmpty())
        checks.push_back(devicesCheck(bus));
    else
        addOfNode(checks, bus, node, planned);
    checks.push_back(writingCheck(bus));
    return asFarAsKnown(std::move(checks));
}

} // namespace codewheel
