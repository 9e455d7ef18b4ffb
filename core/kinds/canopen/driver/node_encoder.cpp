// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/driver/node_encoder.h"

#include "catalog/kept_values.h"
#include "jobs/position_scale.h"
#include "kinds/canopen/protocol/canopen_messages.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/find_by.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace codewheel::canopen {
namespace {

constexpr unsigned onlyCamProgram = 1;

constexpr std::uint32_t keyOf(SdoObject object)
{
    return std::uint32_t{object.index} << 8 | object.sub;
}

// Of objects that a description need not name.
struct TypeRow
{
    SdoObject object;
    ObjectType type;
};
constexpr std::array typeRows{
    TypeRow{object::speed, ObjectType::i16},    TypeRow{object::alarms, ObjectType::u16},
    TypeRow{object::warnings, ObjectType::u16}, TypeRow{object::operatingParameters, ObjectType::u16},
    TypeRow{{0x6301, 1}, ObjectType::u8},       TypeRow{{0x6302, 1}, ObjectType::u8},
};

bool isCamLimit(SdoObject object)
{
    return object.index >= 0x6310 && object.index < 0x6330;
}
bool isCamHysteresis(SdoObject object)
{
    return object.index >= 0x6330 && object.index < 0x6338;
}

bool isOfCams(SdoObject object)
{
    return object.index >= 0x6301 && object.index < 0x6338;
}

} // namespace

NodeEncoder::NodeEncoder(const DeviceDescription &description, int its, const NodeTimes &how)
    : device(description)
    , node(its)
    , settings(how)
    , watch(its)
{
    reading.coding = PositionCoding::binary;
    for (const ParameterDescription &parameter : device.parameters)
        if (const CanopenReach *reach = canopenReach(parameter))
            m_described.emplace_back(reach->object, reach->type);
}

ObjectType NodeEncoder::typeOf(SdoObject object) const
{
    if (const auto *described = findBy(m_described, object, &std::pair<SdoObject, ObjectType>::first))
        return described->second;
    if (const auto *row = findBy(typeRows, object, &TypeRow::object))
        return row->type;
    if (isCamHysteresis(object))
        return ObjectType::u16;
    const bool isSigned = isCamLimit(object) || ((object == object::position || object == object::preset) &&
                                                 canopenDevice(device).isLinear);
    return isSigned ? ObjectType::i32 : ObjectType::u32;
}

std::optional<NmtState> NodeEncoder::state() const
{
    const auto shown = watch.state();
    return shown ? shown : watch.commandedState();
}

bool NodeEncoder::mayRun() const
{
    const auto its = state();
    return !its || its == NmtState::operational;
}

Refusal NodeEncoder::wouldStop() const
{
    return {RefusalKind::busy,
            state() ? CanopenRefusalId::nodeWouldStop : CanopenRefusalId::nodeMayRun,
            {std::int64_t{node}}};
}

void NodeEncoder::take(const CanFrame &frame, Instant now)
{
    const int bootUps = watch.bootUps();
    watch.take(frame, now);
    if (watch.bootUps() != bootUps)
        hasBooted(now);
    takeEmergency(frame, now);
    showState();
}

void NodeEncoder::wasCommanded(NmtCommand command, Instant now)
{
    watch.take(NmtRequest{command, node}.frame(), now);
    showState();
}

// A node that waits to be started may show its position all the same, a stopped one answers nothing.
void NodeEncoder::showState()
{
    const auto now = state();
    if (!now)
        return;
    reading.state = now == NmtState::operational ? EncoderState::operation : EncoderState::waiting;
    if (now == NmtState::stopped) {
        reading.position.reset();
        forgetPosition();
    }
}

// It has started anew: what was not stored is lost.
void NodeEncoder::hasBooted(Instant now)
{
    bootedAt = now;
    if (reading.state != EncoderState::notSeen)
        reading.state = EncoderState::operation;
    forgetPosition();
    m_widths.clear();
    for (const ParameterValue &value : values.values())
        if (const auto known = values.known(value.parameter); hasToBeStored(device, *known))
            values.forget(value.parameter);
    takeCams({});
    flush();
}

void NodeEncoder::takeEmergency(const CanFrame &frame, Instant now)
{
    const auto its = frame.isExtended ? std::nullopt : CobId::of(frame.id);
    const auto emcy = its && its->service == CobId::Service::emcy && its->node == node
                          ? Emcy::read(frame.data())
                          : std::nullopt;
    if (!emcy)
        return;
    if (emcy->isGone())
        tell(now, Severity::information, CanopenMessageId::emergencyGone);
    else
        tell(now, Severity::attention, CanopenMessageId::emergency,
             {Word{emcy->code}, Word{emcy->errorRegister}});
}

void NodeEncoder::isHeard(Instant now)
{
    reading.at = now;
    if (reading.state == EncoderState::silent || reading.state == EncoderState::notSeen)
        reading.state = EncoderState::operation;
    showState();
}

void NodeEncoder::fallSilent()
{
    reading.state = EncoderState::silent;
    forgetPosition();
}

Value NodeEncoder::valueOf(SdoObject object, Octets octets, bool isSizeTold) const
{
    return objectValue(typeOf(object), octets, isSizeTold);
}

std::size_t NodeEncoder::widthOf(SdoObject object) const
{
    const auto told = m_widths.find(keyOf(object));
    return told != m_widths.end() ? told->second : canopen::widthOf(typeOf(object));
}

void NodeEncoder::take(SdoObject object, const SdoOutcome &answer, Instant now)
{
    const Value whole = valueOf(object, answer.value, answer.isSizeTold);
    if (answer.isSizeTold && !whole.isText())
        m_widths[keyOf(object)] = answer.value.size();
    if (object == object::position)
        takePosition(whole.number(), now);
    showBits(object, whole.number());
    for (const ParameterDescription &its : device.parameters)
        if (const CanopenReach *reach = canopenReach(its); reach != nullptr && reach->object == object)
            values.learn({its.parameter, reach->in(whole), Evidence::read, now});
}

void NodeEncoder::take(const PdoValue &mapped, Instant now)
{
    showBits(mapped.object, mapped.number);
    if (mapped.object == object::position)
        takePosition(mapped.number, now);
    if (mapped.object == object::speed)
        compareSpeed(mapped.number, now);
}

PdoType NodeEncoder::pdoType(SdoObject object) const
{
    constexpr int bitsOfOctet = 8;
    const auto told = m_widths.find(keyOf(object));
    return {isSigned(typeOf(object)), told != m_widths.end()
                                          ? std::optional(static_cast<int>(told->second) * bitsOfOctet)
                                          : std::nullopt};
}

void NodeEncoder::showBits(SdoObject object, std::int64_t bits)
{
    if (object == object::alarms)
        reading.alarms = static_cast<std::uint16_t>(bits);
    if (object == object::warnings)
        reading.warnings = static_cast<std::uint16_t>(bits);
}

// The position is believed: what it does for some time while the speed says otherwise is told once.
void NodeEncoder::compareSpeed(std::int64_t told, Instant now)
{
    constexpr double slow = 10; // steps per second
    constexpr int manyInARow = 20;
    const double speed = reading.stepsPerSecond.value_or(0);
    const bool isZero = told == 0;
    const bool isAtOdds = std::abs(speed) > slow && (isZero || (told < 0) != (speed < 0));
    m_speedsAtOdds = isAtOdds ? m_speedsAtOdds + 1 : 0;
    if (m_speedsAtOdds < manyInARow || std::exchange(m_isSpeedTold, true))
        return;
    tell(now, Severity::attention,
         isZero ? CanopenMessageId::speedStandsStill : CanopenMessageId::speedIsOpposite,
         {object::speed.text()});
}

void NodeEncoder::takePosition(std::int64_t position, Instant now)
{
    m_speed.setScale(speedScaleOf(device, [this](Parameter parameter) { return values.value(parameter); }));
    reading.at = now;
    reading.position = position;
    reading.stepsPerSecond = m_speed.after(reading.position, now);
    reading.mayMissTurns = m_speed.mayMissTurns();
}

void NodeEncoder::forgetPosition()
{
    m_speed.restart();
    reading.stepsPerSecond.reset();
    reading.mayMissTurns = false;
}

// 6500h and 6509h follow from others.
void NodeEncoder::mayHaveChanged(const NodeStep &step)
{
    for (const Parameter parameter : step.parameters)
        values.forget(parameter);
    const bool moves = step.task == NodeStep::Task::preset ||
                       std::ranges::any_of(step.parameters, [](Parameter its) { return isOfPosition(its); });
    if (!moves)
        return;
    values.forget(Parameter::offset);
    values.forget(Parameter::operatingParameters);
    forgetPosition();
}

void NodeEncoder::mayHaveChanged(SdoObject object)
{
    NodeStep step;
    step.task = object == object::preset ? NodeStep::Task::preset : NodeStep::Task::write;
    for (const ParameterDescription &its : device.parameters)
        if (const CanopenReach *reach = canopenReach(its); reach != nullptr && reach->object == object)
            step.parameters.push_back(its.parameter);
    mayHaveChanged(step);
    if (isOfCams(object))
        takeCams({});
}

void NodeEncoder::forgetWhatCanBeWritten()
{
    for (const ParameterDescription &its : device.parameters)
        if (its.canBeWritten)
            values.forget(its.parameter);
    takeCams({});
}

void NodeEncoder::takeCams(const std::optional<KnownCams> &known)
{
    if (!known && !cams)
        return;
    cams = known;
    m_haveCamsChanged = true;
}

void NodeEncoder::tell(Instant now, Severity severity, MessageCode id, std::vector<RefusalArgument> arguments)
{
    messages.push_back({.at = now, .severity = severity, .id = id, .arguments = std::move(arguments)});
}

void NodeEncoder::flush()
{
    auto changes = values.takeChanges();
    if (!changes && !m_haveCamsChanged)
        return;
    KnowledgeChanged event = changes.value_or(KnowledgeChanged());
    if (std::exchange(m_haveCamsChanged, false)) {
        if (cams)
            event.cams = {*cams};
        else
            event.camsNoLongerKnown = {onlyCamProgram};
    }
    events.emplace_back(std::move(event));
}

} // namespace codewheel::canopen
