// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_protocol.h"

#include "jobs/planned_by.h"
#include "kinds/interbus/k3/k3_plan.h"

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

} // namespace

const Protocol &k3Protocol()
{
    static const K3Protocol protocol;
    return protocol;
}

} // namespace codewheel
