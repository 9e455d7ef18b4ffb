// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/la66/la66_protocol.h"

#include "jobs/planned_by.h"
#include "kinds/interbus/la66/la66_plan.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

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

const Protocol &la66Protocol()
{
    static const La66Protocol protocol;
    return protocol;
}

} // namespace codewheel
