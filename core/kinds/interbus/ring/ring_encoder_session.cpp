// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_encoder_session.h"

#include "bus/word_channel.h"
#include "jobs/values_to_write.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/ring/send_permission.h"
#include "kinds/interbus/words/k3_word.h"

#include <algorithm>

namespace codewheel {

RingEncoderSession::RingEncoderSession(RingSession &bus, std::size_t device, Place number,
                                       const DeviceDescription &description, bool linkBoundsCycles)
    : EncoderOnBus(bus, device, number, description)
    , m_bus(bus)
    , m_traffic(description)
    , m_linkBoundsCycles(linkBoundsCycles)
{
    Capabilities can = description.capabilities;
    can.manufacturerPreset = can.manufacturerPreset && linkBoundsCycles;
    limitTo(can);
}

Result<std::vector<Step>> RingEncoderSession::planned(const std::vector<Job> &jobs) const
{
    const WordChannel *channel = m_bus.channel(place());
    return stepsForJobs(*this, jobs, channel ? channel->out() : k3::normalRunning);
}

// Renamed or gone meanwhile, it still exists for as long as handlers are being called.
bool RingEncoderSession::isOfThisRing() const
{
    return m_bus.encoder(place()) == this;
}

Result<void> RingEncoderSession::mayStart(const Job &job) const
{
    if (!isOfThisRing())
        return refuse(RefusalKind::link, RingRefusalId::notInRing, {place().shown()});
    if (auto can = checkLink(job); !can) // in Watch, too: Operate would not help
        return can;
    return maySend(m_bus.latest(), index(), place().shown(), RefusalId::jobRunning);
}

// 60000000h acts in every cycle it is in OUT.
Result<void> RingEncoderSession::checkLink(const Job &job) const
{
    const bool mayBePreset = device().capabilities.manufacturerPreset || device().isGeneric();
    if (m_linkBoundsCycles || !mayBePreset)
        return {};
    const auto *preset = std::get_if<SetPreset>(&job);
    const auto *send = std::get_if<SendWords>(&job);
    const bool isPreset = preset != nullptr && preset->command == PresetCommand::manufacturer;
    const bool sends = send != nullptr && latest().mode != Mode::cam &&
                       std::ranges::find(send->words, k3::frabaPreset) != send->words.end();
    if (isPreset || sends)
        return refuse(RefusalKind::notSupported, RefusalId::linkDoesNotBoundCycles, {k3::frabaPreset});
    return {};
}

// By now another device may be at its index.
void RingEncoderSession::post(JobCommand command)
{
    if (!isOfThisRing())
        return;
    std::visit([this](auto &one) { m_bus.post(std::move(one)); }, command);
}

// The number is 0 if the encoder has no valid position (80000000h).
Refusal RingEncoderSession::nameOf(const Message &fault) const
{
    const auto number = static_cast<unsigned>(std::get<std::int64_t>(fault.arguments.front()));
    const DeviceError *error = device().findError(number);
    if (number == 0)
        return {RefusalKind::device, RefusalId::noValidPosition, {}};
    return {RefusalKind::device, error ? error->meaning : RefusalId::otherDeviceError, {}};
}

void RingEncoderSession::meetAgain()
{
    if (!knowsAnything())
        return;
    forgetKnown();
    Q_EMIT knownChanged();
}

void RingEncoderSession::takeFault(const Message &fault)
{
    if (nameOf(fault).id != RefusalId::parametersLost || !knowsValues())
        return;
    forgetValues();
    report({.severity = Severity::attention, .id = MessageId::valuesForgotten}, fault.at);
    Q_EMIT knownChanged();
}

} // namespace codewheel
