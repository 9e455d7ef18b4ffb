// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_checks.h"

#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "kinds/interbus/ring/link_figures.h"
#include "kinds/interbus/ring/ring_outline.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/ring/word_doubts.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct RingCheckText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingChecks)
};

template <typename Condition>
std::optional<Fault> faultWhere(const RingSession &bus, Condition condition)
{
    const std::vector<Fault> faults = ringFaults(bus);
    const auto found = std::ranges::find_if(faults, condition);
    return found == faults.end() ? std::nullopt : std::optional(*found);
}

std::optional<Fault> standstillOf(const RingSession &bus)
{
    return faultWhere(bus, [](const Fault &fault) { return fault.extent == Fault::Extent::standstill; });
}

// Which devices there are: by its master.
bool isTold(const RingSession &bus)
{
    return bus.master() != nullptr;
}

std::size_t indexIn(const RingSession &bus, NodeId node)
{
    const auto found = std::ranges::find(bus.structure(), node, &RingDevice::number);
    return static_cast<std::size_t>(found - bus.structure().begin());
}

DataCheck ringLinkCheck(const RingSession &bus)
{
    DataCheck check = linkCheck(bus, {});
    if (bus.state() != BusState::lost)
        return check;
    check.remedy = standstillOf(bus)->text;
    check.why = bus.latest().whyLost;
    return check;
}

// Since the link was made: a few are nothing to worry about.
DataCheck gatewayCheck(const RingSession &bus, const LinkFigures &figures)
{
    QStringList came{sentence(RingCheckText::tr("%1 requests, %2 without an answer"),
                              {numberText(static_cast<std::int64_t>(figures.transactions)),
                               numberText(static_cast<std::int64_t>(figures.noAnswers))})};
    for (const auto &[code, count] : figures.exceptions)
        came << sentence(RingCheckText::tr("exception %1: %2 times"),
                         {numberText(code), numberText(static_cast<std::int64_t>(count))});
    const DataStep step{DataCheck::Id::gateway, RingCheckText::tr("Gateway"), RingCheckText::tr("answers")};
    const auto blocked = faultWhere(
        bus, [](const Fault &fault) { return fault.actions == std::vector{FaultAction::acknowledge}; });
    if (blocked)
        return step.failed(blocked->shown.word, blocked->text, DataCheck::Action::registers);
    return step.passed(came.join(QStringLiteral("; ")));
}

QString stoppedText(StoppedBy stopped)
{
    switch (stopped) {
    case StoppedBy::alarmStop:
        return RingCheckText::tr("ALARM STOP has stopped the ring. Start it once it may run again.");
    case StoppedBy::program:
        return RingCheckText::tr("The ring was stopped from here. Start it.");
    case StoppedBy::fault:
        return RingCheckText::tr(
            "A fault has stopped the ring. It is not told any more: start the ring again.");
    case StoppedBy::other:
        break;
    }
    return RingCheckText::tr("The ring does not run, and was not stopped from here. Look at its master, then "
                             "start it.");
}

// "BUS FAIL at 3.0 (0D18 ...)"
QString standstillPlace(const Fault &fault)
{
    QString text = fault.node.isEmpty() ? fault.shown.word
                                        : sentence(RingCheckText::tr("%1 at %2", "a state, a device"),
                                                   {fault.shown.word, fault.node.toString()});
    return fault.code.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, fault.code);
}

// A gateway goes on showing the words of a ring that stands still.
bool isUntold(const Snapshot &ring)
{
    return ring.figures != nullptr && !ring.told;
}

QString untoldText(const Snapshot &ring)
{
    return ring.figures->status
               ? RingCheckText::tr("not known: what the bits of its status register mean is not set")
               : RingCheckText::tr("the gateway does not say: no status register is set");
}

DataCheck runningCheck(const RingSession &bus, StoppedBy stopped)
{
    const DataStep step{DataCheck::Id::running, RingCheckText::tr("Ring"), RingCheckText::tr("runs")};
    if (bus.isReadingIn())
        return step.failed(bus.outline().state().word,
                           RingCheckText::tr("The ring is being read in. Wait for it."));
    if (const auto fault = standstillOf(bus))
        return step.failed(standstillPlace(*fault), fault->text,
                           fault->actions.empty() ? DataCheck::Action::none : DataCheck::Action::start);
    if (isUntold(bus.latest()))
        return {step.id, DataCheck::Outcome::notKnown, step.what, step.expected, untoldText(bus.latest())};
    if (bus.isRunning())
        return step.passed(bus.latest().told ? step.expected : bus.outline().state().word);
    return step.failed(bus.outline().state().word, stoppedText(stopped), DataCheck::Action::start);
}

// Behind a gateway a device counts as gone while its words are not believed (WordGate).
DataCheck goneCheck(const DataStep &step, const RingSession &bus, NodeId node, const QString &state)
{
    if (bus.latest().figures != nullptr)
        return step.failed(
            RingCheckText::tr("words that do not agree"),
            sentence(RingCheckText::tr(
                         "The reads of %1 do not agree, so its word is not believed. Check the word order, "
                         "and where its registers begin. If they are right, stop the shaft or make the poll "
                         "interval shorter: a position that moves is believed where reads follow each other "
                         "closely."),
                     {node.toString()}),
            DataCheck::Action::registers);
    return step.failed(state, refusalText(bus.whyNotThere(bus.placeOf(node))));
}

DataCheck reachedCheck(const RingSession &bus, NodeId node)
{
    const DataStep step{DataCheck::Id::reached, RingCheckText::tr("Place in the ring"), node.toString()};
    const std::size_t index = indexIn(bus, node);
    if (index >= bus.structure().size())
        return step.failed(RingCheckText::tr("no such device"),
                           refusalText(bus.whyNotThere(bus.placeOf(node))), DataCheck::Action::compare);
    const auto &devices = bus.latest().devices;
    if (index < devices.size() && !devices[index].inRing)
        return goneCheck(step, bus, node, bus.outline().state(index).shown.word);
    return step.passed(isTold(bus) ? RingCheckText::tr("there")
                                   : RingCheckText::tr("its registers are read"));
}

// "bus terminal, 0Ch"
QString ringKindText(const EncoderBus &bus, const Participant &device)
{
    const QString name = bus.nameOf(device, bus.catalog().findFitting(device.deviceKey, device.deviceCode));
    const unsigned code = ringDevice(device).idCode();
    return code == 0 ? name : QStringLiteral("%1, %2").arg(name, hexCode(code, 2));
}

// No link without a master says which devices there are: that is the project's word.
DataCheck ringKindCheck(const RingSession &bus, NodeId node, const std::vector<Participant> &planned)
{
    DataCheck check = kindCheck(bus, node, planned, ringKindText);
    if (!isTold(bus) && check.outcome == DataCheck::Outcome::asExpected)
        check.came = RingCheckText::tr("the gateway does not say");
    return check;
}

// Of a device, or, without a node, of the bus.
DataCheck masterCheck(const RingSession &bus, NodeId node)
{
    const DataStep step{DataCheck::Id::master, RingCheckText::tr("Reports of the master"),
                        RingCheckText::tr("no fault")};
    const auto fault = faultWhere(bus, [node](const Fault &its) {
        return its.extent == Fault::Extent::bus && (node.isEmpty() || its.node == node);
    });
    if (!fault)
        return step.passed();
    return step.remark(QStringLiteral("%1: %2").arg(fault->node.toString(), fault->shown.word), fault->text,
                       DataCheck::Action::confirm); // the ring runs on
}

DataCheck ringStateCheck(const RingSession &bus, NodeId node)
{
    DataCheck check = stateCheck(bus, node);
    const std::size_t index = indexIn(bus, node);
    const auto fault = encoderFault(bus, index);
    if (!fault)
        return check;
    check.outcome =
        fault->shown.role == Role::fault ? DataCheck::Outcome::differs : DataCheck::Outcome::remark;
    check.came = QStringLiteral("%1 (IN %2)").arg(fault->shown.word, hexWord(bus.latest().devices[index].in));
    check.remedy = fault->text;
    check.action = DataCheck::Action::monitor;
    return check;
}

// An encoder without supply shows 00000000, too.
DataCheck ringPositionCheck(const RingSession &bus, NodeId node)
{
    DataCheck check = positionCheck(bus, node);
    const std::size_t index = indexIn(bus, node);
    const auto fault = encoderFault(bus, index);
    if (!fault || !bus.doubts().mayBeOff(index) || check.outcome != DataCheck::Outcome::asExpected)
        return check;
    check.outcome = DataCheck::Outcome::remark;
    check.came = sentence(RingCheckText::tr("%1, or no supply", "a position"), {check.came});
    check.remedy = fault->text;
    return check;
}

bool takesWords(const RingSession &bus, NodeId node)
{
    const std::size_t index = indexIn(bus, node);
    return index >= bus.structure().size() || bus.structure()[index].outWords > 0;
}

void addOfDevice(DataChecks &checks, const RingSession &bus, NodeId node,
                 const std::vector<Participant> &planned)
{
    checks.push_back(reachedCheck(bus, node));
    const std::size_t index = indexIn(bus, node);
    if (index >= bus.latest().devices.size())
        return;
    if (bus.master() != nullptr)
        checks.push_back(masterCheck(bus, node));
    checks.push_back(ringKindCheck(bus, node, planned));
    checks.push_back(upToDateCheck(bus, node));
    if (auto order = bus.checkWord(index))
        checks.push_back(*std::move(order));
    checks.push_back(ringStateCheck(bus, node));
    checks.push_back(ringPositionCheck(bus, node));
}

} // namespace

DataChecks ringChecks(const RingSession &bus, StoppedBy stopped, NodeId node,
                      const std::vector<Participant> &planned)
{
    DataChecks checks{ringLinkCheck(bus)};
    if (!bus.isOpen())
        return checks;
    if (const auto &figures = bus.latest().figures)
        checks.push_back(gatewayCheck(bus, *figures));
    checks.push_back(runningCheck(bus, stopped));
    if (!node.isEmpty()) {
        addOfDevice(checks, bus, node, planned);
    } else {
        if (bus.master() != nullptr)
            checks.push_back(masterCheck(bus, {}));
        checks.push_back(devicesCheck(bus));
    }
    if (node.isEmpty() || takesWords(bus, node))
        checks.push_back(writingCheck(bus));
    return asFarAsKnown(std::move(checks));
}

} // namespace codewheel
