// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/total_range.h"
#include "jobs/planned_by.h"
#include "jobs/protocol.h"
#include "jobs/value_notes.h"
#include "kinds/esc/driver/esc_fate.h"
#include "kinds/esc/driver/esc_plan.h"
#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/esc_protocols.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "kinds/esc/protocol/esc_forms.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

class EscProtocol final : public Protocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                      const PlanBasis &basis) const override;
    QString stepText(const DeviceDescription &device, const Step &step) const override;
    QString presetCommand() const override { return QStringLiteral("GP"); }
    QString lineText() const override
    {
        return QCoreApplication::translate("codewheel::WriteReview",
                                           "What will be sent, between ESC and CR LF");
    }

    bool wasSent(const Progress &job, std::optional<Parameter> parameter) const override
    {
        return wasSentOnEsc(job, parameter);
    }
    bool isFateUnknown(const EncoderSession &encoder, std::optional<Parameter> parameter,
                       const Outcome &outcome, const Progress &job) const override
    {
        return isFateUnknownOnEsc(encoder, parameter, outcome, job);
    }

    ParameterDescription narrowed(const DeviceDescription &device, Parameter parameter,
                                  const ParameterValues &known, const KindData &options) const override
    {
        return escNarrowed(device, parameter, known, fractionBitsOf(options));
    }
    QString howItIsSent() const override
    {
        return QCoreApplication::translate("Protocol",
                                           "Each command is sent once, and what was written is read back.");
    }
    ParameterValues setAlong(const ParameterValues &written, const ParameterValues &known) const override
    {
        return escSetAlong(written, known);
    }
    bool goesAlong(Parameter parameter, const ParameterValues &written) const override
    {
        return goesAlongOnEsc(parameter, written);
    }
    int writtenBesides(const ParameterValues &written) const override;

    std::optional<PositionScale> scaleOf(const DeviceDescription &device,
                                         const ValueOf &valueOf) const override;
    std::optional<std::int64_t> valueAfter(Parameter parameter, const ParameterValues &written,
                                           const ParameterValues &known) const override;
    std::optional<Parameter> presetOffset() const override { return Parameter::offset; }

private:
    static int fractionBitsOf(const KindData &given)
    {
        const auto *options = given.as<EscValueOptions>();
        return options != nullptr ? options->fractionBits : esc::defaultFractionBits;
    }
};

// The encoder is where it is known to be, otherwise where it is asked for; without a place, at the master
// address.
Result<std::vector<Step>> EscProtocol::planned(const DeviceDescription &device, const Job &job,
                                               const PlanBasis &basis) const
{
    const ParameterValues values = valuesOf(basis.known);
    const EscLineAddress asked = EscLineAddress::of(basis.node);
    const EscLineAddress usual = asked.isDevice() ? asked : EscLineAddress::master();
    const auto address = valueOf(values, Parameter::lineAddress).value_or(usual.value);
    const EscSettings settings{.fractionBits = fractionBitsOf(basis.options)};
    const EscPlan plan(device, {static_cast<std::uint8_t>(address)}, settings, values);
    return plannedBy(plan, job, [&] { return plan.stepsFor(job); });
}

QString EscProtocol::stepText(const DeviceDescription &device, const Step &step) const
{
    const auto request = esc::parseRequest(step.line);
    return request ? esc::requestText(*request) : Protocol::stepText(device, step);
}

// The scaling factor is sent along with what takes effect through it.
int EscProtocol::writtenBesides(const ParameterValues &written) const
{
    const bool isBound = std::ranges::any_of(
        written, [](const ParameterValue &value) { return isBoundToEscFactor(value.parameter); });
    return isBound && !valueOf(written, Parameter::scalingFactor) ? 1 : 0;
}

// While it is scaled, its measuring range is in steps, over all its revolutions (manual, commands M and U).
std::optional<PositionScale> EscProtocol::scaleOf(const DeviceDescription &device,
                                                  const ValueOf &valueOf) const
{
    const ScalingState scaling = scalingState(device, valueOf(Parameter::scaling));
    const bool isScaled = scaling == ScalingState::on;
    const auto total = isScaled ? valueOf(Parameter::measuringRange) : physicalRange(device);
    const auto turns = isScaled ? valueOf(Parameter::revolutions) : device.physicalTurns;
    const bool hasDirection = device.find(Parameter::direction) != nullptr;
    const auto direction = hasDirection ? valueOf(Parameter::direction) : std::nullopt;
    const bool isKnown = scaling != ScalingState::unknown && total && turns && direction;
    if (!isKnown || *total < 1 || *turns < 1)
        return std::nullopt;
    PositionScale scale;
    scale.steps = *total;
    scale.revolutions = *turns;
    scale.turns = *turns;
    scale.physicalStepsPerTurn = device.physicalStepsPerTurn;
    scale.physicalTurns = device.physicalTurns;
    scale.clockwise = countsClockwise(device, {Parameter::direction, *direction});
    return scale;
}

// Steps per turn set the revolutions, and the two of them the measuring range; a measuring range that is
// written itself comes last (manual, GR, GM, GT).
std::optional<std::int64_t> EscProtocol::valueAfter(Parameter parameter, const ParameterValues &written,
                                                    const ParameterValues &known) const
{
    if (const auto value = valueOf(written, parameter))
        return value;
    if (const auto along = valueOf(escSetAlong(written, known), parameter))
        return along;
    const bool rescales = valueOf(written, Parameter::steps) || valueOf(written, Parameter::revolutions);
    if (parameter != Parameter::measuringRange || !rescales)
        return valueOf(known, parameter);
    const auto steps = valueAfter(Parameter::steps, written, known);
    const auto turns = valueAfter(Parameter::revolutions, written, known);
    return steps && turns ? std::optional(*steps * *turns) : std::nullopt;
}

} // namespace

const Protocol &escProtocol()
{
    static const EscProtocol protocol;
    return protocol;
}

} // namespace codewheel
