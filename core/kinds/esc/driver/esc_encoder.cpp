// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_encoder.h"

#include "catalog/total_range.h"
#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/protocol/esc_bits.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/protocol/esc_reach.h"

#include <array>
#include <span>
#include <utility>

namespace codewheel {
namespace {

// What a new scaling changes apart from itself. The manual does not say, so all of it counts as unknown.
constexpr std::array followsScaling{Parameter::steps,          Parameter::revolutions,
                                    Parameter::measuringRange, Parameter::scalingFactor,
                                    Parameter::offset,         Parameter::operatingParameters};
constexpr std::array followsDirection{Parameter::direction, Parameter::offset,
                                      Parameter::operatingParameters};
constexpr std::array followsScalingSwitch{Parameter::scaling, Parameter::offset,
                                          Parameter::operatingParameters};
constexpr std::array followsPreset{Parameter::preset, Parameter::offset};
constexpr std::array followsLowerLimit{Parameter::lowerLimit, Parameter::operatingParameters};
constexpr std::array followsUpperLimit{Parameter::upperLimit, Parameter::operatingParameters};
constexpr std::array followsAddress{Parameter::lineAddress};
constexpr std::array followsBaudRate{Parameter::baudRate};

std::span<const Parameter> dependsOn(esc::Command command)
{
    switch (command) {
    case esc::Command::writeStepsPerTurn:
    case esc::Command::writeRevolutions:
    case esc::Command::writeMeasuringRange:
    case esc::Command::writeScalingFactor:
        return followsScaling;
    case esc::Command::writeScaling:
        return followsScalingSwitch;
    case esc::Command::writeDirection:
        return followsDirection;
    case esc::Command::writePreset:
        return followsPreset;
    case esc::Command::writeLowerLimit:
        return followsLowerLimit;
    case esc::Command::writeUpperLimit:
        return followsUpperLimit;
    case esc::Command::writeAddress:
        return followsAddress;
    case esc::Command::writeBaudRate:
        return followsBaudRate;
    default:
        return {};
    }
}

bool movesThePosition(esc::Command command)
{
    return command != esc::Command::writeLowerLimit && command != esc::Command::writeUpperLimit;
}

} // namespace

bool hasValue(const std::optional<esc::Answer> &answer)
{
    return answer && (answer->kind == esc::Answer::Kind::value || answer->kind == esc::Answer::Kind::text);
}

EscEncoder::EscEncoder(const DeviceDescription &description, EscLineAddress place, EscSettings how)
    : device(description)
    , settings(how)
    , address(place)
{
    reading.coding = PositionCoding::binary;
}

// D applies while scaling is on; otherwise the position is in physical steps, which are at least as many.
void EscEncoder::updateScale()
{
    EscPositionGuard::Scale scale{.topSpeed = settings.topSpeed, .stepsPerTurn = device.physicalStepsPerTurn};
    if (values.value(Parameter::scaling) == 1)
        scale.stepsPerTurn = values.value(Parameter::steps).value_or(scale.stepsPerTurn);
    scale.total = totalRange(device, values.values());
    guard.setScale(scale);
    m_speed.setScale(PositionSpeed::Scale{static_cast<double>(scale.stepsPerTurn), scale.total});
}

void EscEncoder::forgetPosition()
{
    guard.forget();
    m_speed.restart();
    reading.stepsPerSecond.reset();
    reading.mayMissTurns = false;
}

bool EscEncoder::takePosition(std::uint32_t position, Instant now)
{
    updateScale();
    if (guard.judge(position, now) == EscPositionGuard::Verdict::suspect) {
        reading.suspect = true;
        tellSuspect(position, now);
        return false;
    }
    reading.suspect = false;
    reading.at = now;
    reading.position = position;
    reading.stepsPerSecond = m_speed.after(reading.position, now);
    reading.mayMissTurns = m_speed.mayMissTurns();
    return true;
}

void EscEncoder::tellSuspect(std::int64_t position, Instant now)
{
    if (m_suspectTold && now - *m_suspectTold < settings.suspectMessages)
        return;
    m_suspectTold = now;
    RefusalArgument before = QString();
    if (reading.position)
        before = *reading.position;
    tell(now, Severity::attention, EscMessageId::suspectPosition, {std::int64_t{position}, before});
}

// What was read in the other byte order meant something else: it is asked for again.
void EscEncoder::setSwapsWarningBytes(bool on)
{
    if (settings.swapWarningBytes == on)
        return;
    settings.swapWarningBytes = on;
    reading.warnings.reset();
    for (const ParameterDescription &parameter : device.parameters)
        if (escReadCommand(parameter) == esc::Command::warnings)
            values.forget(parameter.parameter);
    flushKnowledge();
}

std::uint16_t EscEncoder::bitsOf(esc::Command command, const esc::Answer &answer) const
{
    const auto bits = static_cast<std::uint16_t>(answer.value);
    const bool isSwapped = settings.swapWarningBytes && command == esc::Command::warnings;
    return isSwapped ? esc::swappedBytes(bits) : bits;
}

bool EscEncoder::saysTheSame(esc::Command command, const esc::Answer &answer) const
{
    if (command == esc::Command::warnings)
        return reading.warnings == bitsOf(command, answer);
    return command == esc::Command::alarms && reading.alarms == bitsOf(command, answer);
}

void EscEncoder::take(esc::Command command, const esc::Answer &answer, Instant now)
{
    if (command == esc::Command::version) {
        version = QString::fromLatin1(answer.text);
        m_versionChanged = true;
        return;
    }
    if (command == esc::Command::warnings)
        reading.warnings = bitsOf(command, answer);
    if (command == esc::Command::alarms)
        reading.alarms = bitsOf(command, answer);
    const std::string_view letters = esc::shapeOf(command).letters;
    const QByteArrayView asked(letters.data(), static_cast<qsizetype>(letters.size()));
    for (const ParameterDescription &parameter : device.parameters)
        if (escReach(parameter).read == asked)
            values.learn({parameter.parameter, escValue(parameter, answer.value, settings.swapWarningBytes),
                          Evidence::read, now});
}

void EscEncoder::mayHaveChanged(esc::Command command)
{
    for (const Parameter parameter : dependsOn(command))
        values.forget(parameter);
    if (movesThePosition(command))
        forgetPosition();
}

void EscEncoder::tell(Instant now, Severity severity, MessageCode id, std::vector<RefusalArgument> arguments)
{
    messages.push_back({.at = now, .severity = severity, .id = id, .arguments = std::move(arguments)});
}

void EscEncoder::flushKnowledge()
{
    auto changes = values.takeChanges();
    if (!changes && !m_versionChanged)
        return;
    KnowledgeChanged event = changes.value_or(KnowledgeChanged{});
    if (std::exchange(m_versionChanged, false))
        event.version = version;
    events.emplace_back(std::move(event));
}

} // namespace codewheel
