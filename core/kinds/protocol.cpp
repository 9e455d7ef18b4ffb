// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/protocol.h"

#include "catalog/value_text.h"
#include "jobs/planned_by.h"
#include "kinds/esc/driver/esc_protocol.h"
#include "kinds/interbus/k3/k3_plan.h"
#include "kinds/interbus/la66/la66_plan.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

class K3Protocol final : public Protocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                      const PlanBasis &basis) const override
    {
        K3Knowledge knowledge(device);
        knowledge.set(basis.known);
        knowledge.setCams(basis.cams);
        const K3Plan plan(device, knowledge);
        return plannedBy(plan, job, [&] {
            K3Steps steps = plan.stepsFor(job);
            if (basis.out != k3::normalRunning)
                K3Plan::clearOutFirst(steps, job);
            return steps;
        });
    }
};

class La66Protocol final : public Protocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                      const PlanBasis &basis) const override
    {
        const La66Plan plan(device, {});
        return plannedBy(plan, job, [&] { return plan.stepsFor(job, basis.out); });
    }
    QString presetCommand() const override { return QCoreApplication::translate("Protocol", "service 6"); }
};

} // namespace

ParameterDescription Protocol::narrowed(const DeviceDescription &device, Parameter parameter,
                                        const ParameterValues & /*known*/,
                                        const std::optional<ValueOptions> &options) const
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

const Protocol &protocolOf(const DeviceDescription &device)
{
    static const K3Protocol k3; // also for K1, K2 and K4, which have no jobs
    static const La66Protocol la66;
    if (device.profile == Profile::esc)
        return escProtocol();
    return device.profile == Profile::la66 ? static_cast<const Protocol &>(la66) : k3;
}

Result<std::vector<Step>> plannedSteps(const DeviceDescription &device, const Job &job,
                                       const PlanBasis &basis)
{
    return protocolOf(device).planned(device, job, basis);
}

} // namespace codewheel
