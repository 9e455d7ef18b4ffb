// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/encoder_bus.h"

#include "bus/data_check.h"
#include "bus/word_channel.h"

#include <utility>

namespace codewheel {

EncoderBus::EncoderBus(BusId id, const QDateTime &begin, std::span<const TrafficColumn> columns,
                       QObject *parent)
    : QObject(parent)
    , m_id(id)
    , m_trafficColumns(columns)
    , m_wallTime(begin)
{}

Result<void> EncoderBus::mayName(Place place, const DeviceDescription *device) const
{
    if (device != nullptr)
        if (auto can = canBe(place, *device); !can)
            return can;
    const EncoderSession *its = encoder(place);
    if (its != nullptr && its->runningJob())
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {place.shown()});
    return {};
}

Result<void> EncoderBus::replace(Place place, const QString &deviceKey, int turns, int stepsPerTurn)
{
    if (const EncoderSession *its = encoder(place); its != nullptr && its->runningJob())
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {place.shown()});
    Q_EMIT replaced(place);
    return name(place, deviceKey, turns, stepsPerTurn);
}

void EncoderBus::tell(Message message)
{
    message.place = placeOf(message.place ? message.place->node : NodeId());
    Q_EMIT messaged(message);
}

// Qt asks the system for its time zone each time, and on a full bus many rows are of one millisecond.
void EncoderBus::tellTraffic(TrafficRow row)
{
    const auto at = std::chrono::floor<std::chrono::milliseconds>(sinceEpoch(row.at));
    if (m_trafficTime.isNull() || std::exchange(m_trafficAt, at) != at)
        m_trafficTime = dateTime(row.at);
    row.time = m_trafficTime;
    Q_EMIT trafficPassed(row);
}

void EncoderBus::linkRefused(const Refusal &why)
{
    m_whyRefused = why;
    tell({.at = now(), .severity = Severity::fault, .refusal = why});
    tellState();
    Q_EMIT openRefused(why);
}

void EncoderBus::tellState(bool isOther)
{
    const State now{state(), isRunning(), isOperating()};
    if (now.bus == BusState::open)
        m_whyRefused.reset();
    if (std::exchange(m_told, now) != now || isOther)
        Q_EMIT stateChanged();
}

void EncoderBus::takeSleep(const Slept &slept, Instant at)
{
    m_wallTime.slept(slept.duration, at);
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(slept.duration).count();
    tell({.at = at,
          .severity = Severity::attention,
          .id = MessageId::computerSlept,
          .arguments = {std::int64_t{seconds}}});
}

Refusal EncoderBus::whyNotThere(Place place) const
{
    return notConnected(place);
}

std::optional<Refusal> EncoderBus::isOther(Place, const QString &, const QString &) const
{
    return std::nullopt;
}

DataChecks EncoderBus::dataChecks(NodeId node, const std::vector<Participant> &planned) const
{
    DataChecks checks{linkCheck(*this, {})};
    if (!isOpen())
        return checks;
    if (node.isEmpty())
        checks.push_back(devicesCheck(*this));
    else
        for (DataCheck &check : DataChecks{kindCheck(*this, node, planned), upToDateCheck(*this, node),
                                           stateCheck(*this, node), positionCheck(*this, node)})
            checks.push_back(std::move(check));
    checks.push_back(writingCheck(*this));
    return asFarAsKnown(std::move(checks));
}

Refusal notConnected(Place place)
{
    return {RefusalKind::link, RefusalId::notConnected, {place.shown()}};
}

std::vector<Place> devicesWithOut(const EncoderBus &bus)
{
    std::vector<Place> found;
    if (bus.isReplay())
        return found;
    for (const Place place : bus.places())
        if (const WordChannel *channel = bus.channel(place); channel != nullptr && channel->out() != 0)
            found.push_back(place);
    return found;
}

} // namespace codewheel
