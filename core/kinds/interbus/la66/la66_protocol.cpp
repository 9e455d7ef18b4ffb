// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/planned_by.h"
#include "jobs/protocol.h"
#include "kinds/interbus/interbus_protocols.h"
#include "kinds/interbus/la66/la66_plan.h"
#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/word_protocol.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

class La66Protocol final : public WordProtocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                      const PlanBasis &basis) const override
    {
        const La66Plan plan(device, {});
        return plannedBy(plan, job, [&] { return plan.stepsFor(job, basis.out); });
    }
    QString presetCommand() const override { return QCoreApplication::translate("Protocol", "service 6"); }
    QString howItIsSent() const override
    {
        return QCoreApplication::translate(
            "Protocol", "Each word goes out for two bus cycles with its first bit, the service "
                        "bit, 0; what was written is read back.");
    }
    Refusal shownError(const DeviceDescription & /*device*/, const Reading &reading) const override
    {
        return {RefusalKind::device, RefusalId::magnetOutOfRange, {reading.in}};
    }
    bool mayChangeScale(Word out) const override { return la66::isWrite(out); }
    int eepromWrites(const DeviceDescription & /*device*/, std::span<const Word> words,
                     bool /*mayBeInCamMode*/) const override
    {
        return static_cast<int>(std::ranges::count_if(
            words, [](Word out) { return la66::isServiceMode(out) && la66::isWrite(out); }));
    }
    std::optional<Parameter> presetOffset() const override { return std::nullopt; }
};

} // namespace

const Protocol &la66Protocol()
{
    static const La66Protocol protocol;
    return protocol;
}

} // namespace codewheel
