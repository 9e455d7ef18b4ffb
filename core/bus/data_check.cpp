// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/data_check.h"

#include "bus/bus_outline.h"
#include "bus/encoder_bus.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "jobs/job_report.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/find_by.h"
#include "vocabulary/freshness_text.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/state_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// The translation context of these texts.
struct DataCheckText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DataCheck)
};

QString freshnessRemedy(Freshness::Reason reason)
{
    switch (reason) {
    case Freshness::Reason::notSeen:
        return DataCheckText::tr("Wait a moment. If nothing comes, check its supply and its place.");
    case Freshness::Reason::notAsked:
        return DataCheckText::tr("Wait for it, or end the search or the job.");
    case Freshness::Reason::watched:
        return DataCheckText::tr("Switch to Operate, where it is asked.");
    case Freshness::Reason::nodeStopped:
        return DataCheckText::tr("Start it (NMT), in Operate.");
    case Freshness::Reason::slept:
        return DataCheckText::tr("Wait for the next answer.");
    default:
        return {};
    }
}

QString joined(const QString &sentence, const QString &next)
{
    return next.isEmpty() ? sentence : sentence + u' ' + next;
}

const Freshness *freshnessOf(const EncoderBus &bus, NodeId node)
{
    if (const EncoderSession *encoder = bus.encoder(node))
        return &encoder->freshness();
    const WordChannel *channel = bus.channel(node);
    return channel != nullptr ? &channel->freshness() : nullptr;
}

constexpr auto stateNames = std::to_array<TextOf<EncoderState>>({
    {EncoderState::notSeen, QT_TRANSLATE_NOOP("codewheel::DataCheck", "not seen")},
    {EncoderState::operation, QT_TRANSLATE_NOOP("codewheel::DataCheck", "operation")},
    {EncoderState::parameterization, QT_TRANSLATE_NOOP("codewheel::DataCheck", "parameterization")},
    {EncoderState::readOut, QT_TRANSLATE_NOOP("codewheel::DataCheck", "self test or read-out")},
    {EncoderState::service, QT_TRANSLATE_NOOP("codewheel::DataCheck", "service mode")},
    {EncoderState::error, QT_TRANSLATE_NOOP("codewheel::DataCheck", "error")},
    {EncoderState::waiting, QT_TRANSLATE_NOOP("codewheel::DataCheck", "waiting")},
    {EncoderState::silent, QT_TRANSLATE_NOOP("codewheel::DataCheck", "silent")},
});

QString stateName(const EncoderSession &encoder)
{
    return DataCheckText::tr(
        textFor(stateNames, encoder.latest().state, QT_TRANSLATE_NOOP("codewheel::DataCheck", "unknown")));
}

QString stateRemedy(const EncoderSession &encoder)
{
    if (encoder.runningJob())
        return DataCheckText::tr("A job is at work on this encoder. Wait for its end, or cancel it.");
    switch (encoder.latest().state) {
    case EncoderState::parameterization:
        return DataCheckText::tr(
            "The encoder is in parameterization and shows what was written to it, not its "
            "position. Set OUT to 80000000 (run), in its monitor, until a position comes, then to 00000000.");
    case EncoderState::readOut:
        return DataCheckText::tr(
            "The encoder tests itself, or shows a value that was asked for, not its "
            "position. Wait for the end of the self test; otherwise set OUT to 00000000, "
            "in its monitor.");
    case EncoderState::service:
        return DataCheckText::tr(
            "The encoder answers a service and shows no position. Set OUT to 00000000, in "
            "its monitor, to bring it back.");
    case EncoderState::error:
        return DataCheckText::tr("The encoder reports an error. The messages say which.");
    case EncoderState::waiting:
        return waitingText();
    case EncoderState::unknown:
        return DataCheckText::tr("No manual says what this word means. Check which encoder is there, and in "
                                 "which order its bytes come.");
    default:
        return DataCheckText::tr("Wait a moment. If nothing comes, check its supply and its place.");
    }
}

// As the dial says it.
DataCheck noPositionCheck(const DataStep &step, const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    const QString came = DataCheckText::tr("no position");
    if (const EncoderState state = encoder.latest().state;
        state != EncoderState::operation && state != EncoderState::notSeen) // the state says why
        return step.failed(came, stateRemedy(encoder));
    if (device.isGeneric())
        return step.failed(came,
                           DataCheckText::tr("The make of the encoder is not known, and so neither is the "
                                             "coding of its position. Name it in the bus structure."));
    if (device.quirks.hasModes && !encoder.latest().mode)
        return step.failed(
            came,
            DataCheckText::tr(
                "IN may be a position, a speed or cams: the mode of the encoder is not known, and "
                "cannot be read. If it is in position mode, say so (Parameters, More)."),
            DataCheck::Action::positionMode);
    return step.failed(
        came, DataCheckText::tr("The coding of the position in IN is not known. Read the parameters, "
                                "write the coding, or set it manually under Parameters."));
}

} // namespace

DataChecks asFarAsKnown(DataChecks checks)
{
    const auto first = std::ranges::find(checks, DataCheck::Outcome::differs, &DataCheck::outcome);
    for (auto check = first == checks.end() ? first : first + 1; check != checks.end(); ++check) {
        if (check->id == DataCheck::Id::writing)
            continue;
        *check = {.id = check->id,
                  .outcome = DataCheck::Outcome::notKnown,
                  .what = check->what,
                  .expected = check->expected};
    }
    return checks;
}

const DataCheck *firstDifference(const DataChecks &checks)
{
    return findBy(checks, DataCheck::Outcome::differs, &DataCheck::outcome);
}

const DataCheck *findCheck(const DataChecks &checks, DataCheck::Id id)
{
    return findBy(checks, id, &DataCheck::id);
}

DataCheck DataStep::passed(const QString &came) const
{
    return {.id = id, .what = what, .expected = expected, .came = came};
}

DataCheck DataStep::failed(const QString &came, const QString &remedy, DataCheck::Action action) const
{
    return {id, DataCheck::Outcome::differs, what, expected, came, remedy, action};
}

DataCheck DataStep::remark(const QString &came, const QString &remedy, DataCheck::Action action) const
{
    return {id, DataCheck::Outcome::remark, what, expected, came, remedy, action};
}

DataCheck DataStep::faulty(const Fault &fault) const
{
    return fault.shown.role == Role::fault ? failed(fault.shown.word, fault.text)
                                           : remark(fault.shown.word, fault.text);
}

static DataStep linkStep(const QString &expected)
{
    return {DataCheck::Id::link, DataCheckText::tr("Link"),
            expected.isEmpty() ? DataCheckText::tr("connected") : expected};
}

DataCheck notConnectedCheck(const QString &expected, const std::optional<Refusal> &refused)
{
    DataCheck check = linkStep(expected).failed(
        DataCheckText::tr("not connected"),
        refused ? refusalText(*refused) : DataCheckText::tr("The bus is not connected. Connect it."),
        refused ? DataCheck::Action::connection : DataCheck::Action::connectBus);
    check.why = refused;
    return check;
}

DataCheck linkCheck(const EncoderBus &bus, const QString &expected)
{
    const DataStep step = linkStep(expected);
    const QString came = bus.outline().state().word;
    if (bus.state() == BusState::closed)
        return notConnectedCheck(expected, bus.whyRefused());
    if (bus.state() == BusState::opening)
        return step.failed(came, DataCheckText::tr("The program is connecting the bus. Wait for it."));
    if (bus.state() == BusState::lost)
        return step.failed(came, freshnessText(Freshness::Reason::linkLost), DataCheck::Action::connection);
    if (bus.isReplay())
        return step.remark(came, freshnessText(Freshness::Reason::recorded));
    return step.passed(DataCheckText::tr("connected"));
}

QString kindText(const EncoderBus &bus, const Participant &device)
{
    const DeviceDescription *described = bus.catalog().findFitting(device.deviceKey, device.deviceCode);
    const QString name = bus.nameOf(device, described);
    const unsigned code = described != nullptr ? described->idCode : 0;
    return code == 0 ? name : QStringLiteral("%1, %2").arg(name, hexCode(code, 2));
}

DataCheck kindCheck(const EncoderBus &bus, NodeId node, const std::vector<Participant> &planned,
                    QString (*text)(const EncoderBus &, const Participant &))
{
    DataStep step{DataCheck::Id::kind, DataCheckText::tr("Device", "the kind of device at a place"),
                  DataCheckText::tr("any: the project plans none here")};
    const auto found = bus.found(bus.placeOf(node));
    const QString came = found ? text(bus, *found) : DataCheckText::tr("none");
    const auto own = std::ranges::find(planned, node, &Participant::number);
    if (own == planned.end())
        return found ? step.passed(came) : step.failed(came, refusalText(bus.whyNotThere(bus.placeOf(node))));
    step.expected = text(bus, *own);
    const auto strangers = bus.strangers(planned);
    const auto stranger = strangers.find(node);
    const auto other = stranger != strangers.end() ? std::optional(stranger->second)
                                                   : bus.isOther(bus.placeOf(node), own->deviceKey, {});
    if (other)
        return step.failed(came, refusalText(*other), DataCheck::Action::compare);
    return step.passed(came);
}

QString withUnchanged(const QString &seen, const EncoderBus &bus, NodeId node)
{
    const EncoderSession *encoder = bus.encoder(node);
    const auto since = encoder != nullptr ? encoder->unchangedSince() : std::nullopt;
    const QString moment = since ? unchangedText(bus.dateTime(*since), bus.dateTime(bus.now())) : QString();
    return moment.isEmpty()
               ? seen
               : sentence(DataCheckText::tr("%1, the same since %2", "20 s ago, 14:02"), {seen, moment});
}

DataCheck upToDateCheck(const EncoderBus &bus, NodeId node)
{
    const DataStep step{DataCheck::Id::upToDate, DataCheckText::tr("Last word or answer"),
                        DataCheckText::tr("up to date")};
    const Freshness *freshness = freshnessOf(bus, node);
    if (freshness == nullptr)
        return step.passed(DataCheckText::tr("the device has none"));
    const QString seen = freshness->state() == Freshness::State::unknown
                             ? DataCheckText::tr("none yet")
                             : agoText(bus.dateTime(freshness->seen()), bus.dateTime(bus.now()));
    if (freshness->isLive())
        return step.passed(withUnchanged(seen, bus, node));
    if (freshness->isOfRecording())
        return step.remark(freshnessBrief(freshness->reason()), freshnessText(freshness->reason()));
    return step.failed(seen,
                       joined(freshnessText(freshness->reason()), freshnessRemedy(freshness->reason())));
}

DataCheck stateCheck(const EncoderBus &bus, NodeId node)
{
    const DataStep step{DataCheck::Id::state, DataCheckText::tr("State of the encoder"),
                        DataCheckText::tr("operation")};
    const EncoderSession *encoder = bus.encoder(node);
    if (encoder == nullptr)
        return step.remark(
            DataCheckText::tr("not described"),
            DataCheckText::tr("This program has no description of this device: only its words are shown."));
    const Reading &reading = encoder->latest();
    if (reading.state == EncoderState::operation)
        return step.passed(stateName(*encoder));
    const WordChannel *channel = bus.channel(node);
    QString came = stateName(*encoder);
    if (channel != nullptr && reading.state != EncoderState::notSeen)
        came = QStringLiteral("%1 (IN %2)").arg(came, hexWord(reading.in));
    return step.failed(came, stateRemedy(*encoder),
                       channel != nullptr ? DataCheck::Action::monitor : DataCheck::Action::none);
}

DataCheck positionCheck(const EncoderBus &bus, NodeId node)
{
    const DataStep step{DataCheck::Id::position, DataCheckText::tr("Position"), DataCheckText::tr("valid")};
    const EncoderSession *encoder = bus.encoder(node);
    if (encoder == nullptr)
        return step.passed(DataCheckText::tr("not described"));
    const Reading &reading = encoder->latest();
    if (reading.suspect)
        return step.failed(DataCheckText::tr("suspect"),
                           DataCheckText::tr("The position jumped further than the encoder can turn, and is "
                                             "being asked for again. If that happens often, check shield and "
                                             "termination of the line."));
    if (reading.position)
        return step.passed(numberText(*reading.position));
    const auto left = encoder->leftInMode(); // by a job that was cut off: nobody chose that mode
    const auto other = [&](const QString &came) {
        return left ? step.failed(came, messageText(leftModeMessage({reading.mode, reading.camProgram})))
                    : step.passed(came);
    };
    if (reading.velocity)
        return other(sentence(DataCheckText::tr("a speed: %1 rpm"), {numberText(*reading.velocity)}));
    if (reading.cams)
        return other(DataCheckText::tr("cams: the encoder is in cam mode"));
    return noPositionCheck(step, *encoder);
}

DataCheck writingCheck(const EncoderBus &bus)
{
    const DataStep step{DataCheck::Id::writing, DataCheckText::tr("Writing"),
                        DataCheckText::tr("as you want it")};
    if (bus.isOperating())
        return step.passed(DataCheckText::tr("Operate"));
    if (bus.isReplay())
        return step.passed(DataCheckText::tr("never to a recording"));
    return step.remark(
        DataCheckText::tr("Watch"),
        DataCheckText::tr("Watch: values are read, and nothing can be written. Switch to Operate "
                          "to write."),
        bus.isOpen() ? DataCheck::Action::operate : DataCheck::Action::none);
}

DataCheck devicesCheck(const EncoderBus &bus)
{
    DataStep step{DataCheck::Id::devices, DataCheckText::tr("Devices"), DataCheckText::tr("at least one")};
    if (bus.places().empty())
        return step.failed(
            DataCheckText::tr("none"),
            DataCheckText::tr("No device is planned on this bus, so nothing is asked. Search for "
                              "what is there, or enter it in the bus structure."),
            DataCheck::Action::search);
    step.expected = DataCheckText::tr("no fault");
    const auto faults = bus.outline().faults();
    const auto worst = std::ranges::find_if(faults, [](const Fault &fault) {
        return fault.extent == Fault::Extent::device && fault.shown.role == Role::fault;
    });
    if (worst == faults.end())
        return step.passed(DataCheckText::tr("%n devices", nullptr, static_cast<int>(bus.places().size())));
    return step.failed(QStringLiteral("%1: %2").arg(worst->node.toString(), worst->shown.word), worst->text);
}

} // namespace codewheel
