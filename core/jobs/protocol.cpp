// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/protocol.h"

#include "catalog/value_text.h"
#include "jobs/step_text.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

class NoProtocol final : public Protocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job & /*job*/,
                                      const PlanBasis & /*basis*/) const override
    {
        return refuse(RefusalKind::notSupported, RefusalId::jobNotSupported, {device.fullName()});
    }
};

} // namespace

const Protocol &noProtocol()
{
    static const NoProtocol protocol;
    return protocol;
}

Refusal Protocol::shownError(const DeviceDescription &device, const Reading &reading) const
{
    const DeviceError *error = device.findError(reading.errorNumber.value_or(0));
    return {
        RefusalKind::device, error != nullptr ? error->meaning : RefusalId::otherDeviceError, {reading.in}};
}

QString Protocol::stepText(const DeviceDescription & /*device*/, const Step &step) const
{
    return sentText(step);
}

ParameterValues Protocol::valuesIn(const DeviceDescription & /*device*/, const Step &step) const
{
    return step.parameter() && step.data ? ParameterValues{{*step.parameter(), *step.data}}
                                         : ParameterValues();
}

QString Protocol::lineText() const
{
    return QCoreApplication::translate("Protocol", "What will be sent");
}

ParameterDescription Protocol::narrowed(const DeviceDescription &device, Parameter parameter,
                                        const ParameterValues & /*known*/, const KindData &options) const
{
    if (const ParameterDescription *found = device.find(parameter))
        return withOptions(*found, options);
    ParameterDescription unknown;
    unknown.parameter = parameter;
    return unknown;
}

std::optional<std::int64_t> Protocol::valueAfter(Parameter parameter, const ParameterValues &written,
                                                 const ParameterValues &known) const
{
    const auto value = valueOf(written, parameter);
    return value ? value : valueOf(known, parameter);
}

Result<std::vector<Step>> plannedSteps(const DeviceDescription &device, const Job &job,
                                       const PlanBasis &basis)
{
    return protocolOf(device).planned(device, job, basis);
}

} // namespace codewheel
