// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/master_watch.h"

#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/words/device_number.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::chrono::minutes betweenCrcMessages{1};

std::vector<RefusalArgument> faultArguments(std::uint16_t errorCode, std::uint16_t parameter)
{
    return {Word{errorCode}, Word{parameter}};
}

} // namespace

std::vector<Message> MasterWatch::look(const MasterStatus &status, const std::vector<NodeId> &ring,
                                       Instant now)
{
    lookAtBus(status);
    lookAtDevices(status, ring);
    lookAtSegments(status, now);
    m_before = status;
    return std::exchange(m_messages, {});
}

void MasterWatch::confirmedByService()
{
    for (std::size_t i = 0; i < m_before.devices.size(); ++i)
        if (m_before.devices[i].peripheralFault)
            m_confirmed.insert(i);
}

void MasterWatch::lookAtBus(const MasterStatus &status)
{
    const bool failed = status.state == MasterState::busFail;
    const bool failedBefore = m_before.state == MasterState::busFail;
    const bool isOther = status.errorCode != m_before.errorCode || status.parameter != m_before.parameter;
    if (failed && (!failedBefore || isOther)) {
        Message message{.severity = Severity::fault,
                        .id = RingMessageId::busFault,
                        .arguments = faultArguments(status.errorCode, status.parameter)};
        if (const auto place = status.faultPlace())
            message.place = Place{.node = place->number};
        m_messages.push_back(std::move(message));
    }
    if (!failedBefore || status.state != MasterState::ready || status.isFaulty())
        return;
    if (isFaultSwitchedOff(status))
        m_messages.push_back(
            {.severity = Severity::attention,
             .id = RingMessageId::segmentOff,
             .arguments = {std::int64_t{m_off.back()}, Word{m_before.errorCode}, Word{m_before.parameter}}});
    else
        m_messages.push_back({.id = RingMessageId::busFaultGone});
}

// While a fault was located, the devices behind it were out of the ring. They are back when it is gone,
// except those in segments that are off, where the master does not look.
bool MasterWatch::isFaultSwitchedOff(const MasterStatus &status) const
{
    if (m_off.empty() || !m_before.faultPlace() || m_before.devices.size() != status.devices.size())
        return false;
    for (std::size_t i = 0; i < status.devices.size(); ++i)
        if (status.devices[i].inRing && !m_before.devices[i].inRing)
            return false;
    return true;
}

void MasterWatch::lookAtDevices(const MasterStatus &status, const std::vector<NodeId> &ring)
{
    const std::size_t devices = std::min(ring.size(), status.devices.size());
    for (std::size_t i = 0; i < devices; ++i) {
        const bool before = i < m_before.devices.size() && m_before.devices[i].peripheralFault;
        if (status.devices[i].peripheralFault == before)
            continue;
        Message message{.place = Place{.node = ring[i]}};
        const bool wasConfirmed = m_confirmed.erase(i) > 0;
        if (before) {
            if (!wasConfirmed)
                continue;
            message.id = RingMessageId::peripheralFaultConfirmed;
        } else {
            message.severity = Severity::fault;
            message.id = RingMessageId::peripheralFault;
            message.arguments =
                faultArguments(bus_error::peripheralFault, diagnosticParameterOf({.number = ring[i]}));
        }
        m_messages.push_back(std::move(message));
    }
}

void MasterWatch::lookAtSegments(const MasterStatus &status, Instant now)
{
    for (const MasterStatus::Segment &segment : status.segments) {
        const auto before =
            std::ranges::find(m_before.segments, segment.segment, &MasterStatus::Segment::segment);
        const bool wasOff = before != m_before.segments.end() && before->switchedOff;
        if (segment.switchedOff != wasOff) {
            m_messages.push_back({.severity = Severity::attention,
                                  .id = wasOff ? RingMessageId::segmentOn : RingMessageId::segmentOff,
                                  .arguments = {std::int64_t{segment.segment}}});
            std::erase(m_off, segment.segment);
            if (!wasOff)
                m_off.push_back(segment.segment);
        }
        lookAtCrcErrors(segment, now);
    }
}

void MasterWatch::lookAtCrcErrors(const MasterStatus::Segment &segment, Instant now)
{
    Told &told = m_told[segment.segment];
    if (segment.crcErrors < told.crcErrors) // counted from the start of the ring
        told.crcErrors = 0;
    if (segment.crcErrors == told.crcErrors)
        return;
    const Instant due = told.at ? *told.at + betweenCrcMessages : now;
    if (now < due)
        m_due = std::min(m_due.value_or(due), due);
    else
        tellCrcErrors(segment, now);
}

void MasterWatch::tellCrcErrors(const MasterStatus::Segment &segment, Instant now)
{
    Told &told = m_told[segment.segment];
    m_messages.push_back({.place = Place{.node = DeviceNumber{segment.segment, 0}.node()},
                          .severity = Severity::attention,
                          .id = MessageId::crcErrors,
                          .arguments = {std::int64_t{segment.segment},
                                        std::int64_t{segment.crcErrors} - std::int64_t{told.crcErrors},
                                        std::int64_t{segment.crcErrors}}});
    told = {segment.crcErrors, now};
}

std::vector<Message> MasterWatch::lookAtTime(Instant now)
{
    if (!m_due || now < *m_due)
        return {};
    m_due.reset();
    for (const MasterStatus::Segment &segment : m_before.segments)
        lookAtCrcErrors(segment, now);
    return std::exchange(m_messages, {});
}

std::vector<Message> MasterWatch::lookAtRest(Instant now)
{
    m_due.reset();
    for (const MasterStatus::Segment &segment : m_before.segments)
        if (segment.crcErrors > m_told[segment.segment].crcErrors)
            tellCrcErrors(segment, now);
    return std::exchange(m_messages, {});
}

} // namespace codewheel
