// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/bus_recorder.h"

#include "history/histories.h"
#include "recording/recorded_device.h"

namespace codewheel {
namespace {

// After the time is over: by then every encoder has told what it showed until then.
constexpr Instant settling = std::chrono::milliseconds(200);

} // namespace

Result<std::unique_ptr<BusRecorder>> BusRecorder::begin(Buses &buses, const Histories &histories,
                                                        const RecordingPlan &plan,
                                                        const BusFeed::WallClockNow &now)
{
    RecordingPlan dated = plan;
    if (dated.settings.begun == Instant(0))
        dated.settings.begun = std::chrono::milliseconds(now().toMSecsSinceEpoch());
    auto target = RecordingTarget::begin(dated.settings);
    if (!target)
        return tl::unexpected(target.error());
    return std::unique_ptr<BusRecorder>(new BusRecorder(buses, histories, dated, now, std::move(*target)));
}

BusRecorder::BusRecorder(Buses &buses, const Histories &histories, const RecordingPlan &plan,
                         const BusFeed::WallClockNow &now, std::unique_ptr<RecordingTarget> target)
    : m_histories(histories)
    , m_plan(plan)
    , m_target(std::move(target))
    , m_state(plan.trigger ? State::waiting : State::recording)
    , m_feed(buses, now)
{
    if (m_plan.trigger)
        m_trigger.emplace(*m_plan.trigger);
    connect(&m_feed, &BusFeed::came, this, &BusRecorder::receive);
}

void BusRecorder::setState(State state)
{
    if (std::exchange(m_state, state) != state)
        Q_EMIT stateChanged();
}

// It begins with what comes next.
void BusRecorder::fire()
{
    if (m_state != State::waiting)
        return;
    m_trigger.reset();
    setState(State::recording);
}

void BusRecorder::end()
{
    if (m_state == State::ended)
        return;
    for (const Place place : m_histories.places()) // those that have been silent since
        if (m_span && isWanted(place))
            addPast(place, m_span->to);
    (void)m_target->end();
    setState(State::ended);
}

bool BusRecorder::isWanted(const std::optional<Place> &place) const
{
    return !place || place->isEmpty() || m_plan.places.empty() || m_plan.places.contains(*place);
}

void BusRecorder::receive(const RecordingEntry &entry)
{
    if (m_state == State::ended)
        return;
    std::visit([this](const auto &what) { take(what); }, entry);
    if (m_target->status().hasEnded)
        setState(State::ended);
}

void BusRecorder::take(const RecordedValues &values)
{
    if (m_state == State::waiting && m_trigger)
        if (const auto at = m_trigger->take(values.place, values.values))
            beginAt(*at);
    if (m_state != State::recording || !isWanted(values.place))
        return;
    if (!m_span)
        beginAt(values.values.front().at);
    addPast(values.place, values.values.front().at);
    RecordedValues wanted{values.place, {}};
    std::ranges::copy_if(values.values, std::back_inserter(wanted.values),
                         [this](const ShownValues &shown) { return isIn(shown.at); });
    if (!wanted.values.empty())
        m_target->add(std::move(wanted));
    endIfOver(values.values.front().at);
}

void BusRecorder::take(const RecordedMessage &message)
{
    if (m_state == State::waiting && m_trigger)
        if (const auto at = m_trigger->take(message))
            beginAt(*at);
    if (isIn(message.at) && isWanted(message.message.place))
        m_target->add(message);
}

void BusRecorder::take(const RecordedTraffic &traffic)
{
    if (m_plan.withTraffic && isIn(traffic.at) && isWanted(traffic.row.place))
        m_target->add(traffic);
}

void BusRecorder::take(const RecordedInterruption &interruption)
{
    if (m_state == State::recording)
        m_target->add(interruption);
}

// Also tells that the time is over, if nothing else comes.
void BusRecorder::take(const RecordedClock &clock)
{
    m_target->add(clock);
    endIfOver(clock.at);
}

void BusRecorder::take(const RecordedDescription &description)
{
    if (!isWanted(description.place))
        return;
    m_described.try_emplace(description.place, description);
    m_target->add(description);
}

void BusRecorder::endIfOver(Instant now)
{
    if (m_span && now - settling >= m_span->to)
        end();
}

template <class Other>
void BusRecorder::take(const Other &other)
{
    m_target->add(other);
}

void BusRecorder::beginAt(Instant at)
{
    m_trigger.reset();
    m_span = m_plan.extent.around(at);
    addMarks(at);
    setState(State::recording);
}

// What happened shortly before; the message that fired it comes by itself.
void BusRecorder::addMarks(Instant until)
{
    for (const Mark &mark : m_histories.marks()) {
        if (mark.at < m_span->from || mark.at >= until || !isWanted(mark.place))
            continue;
        if (const auto *message = std::get_if<Message>(&mark.what))
            m_target->add(RecordedMessage{mark.at, *message});
        else
            m_target->add(RecordedNote{mark.at, std::get<QString>(mark.what)});
    }
}

void BusRecorder::addPast(Place place, Instant until)
{
    const EncoderHistory *history = m_histories.of(place);
    if (history == nullptr || !m_withPast.insert(place).second)
        return;
    addEarlierDescriptions(place);
    if (until <= m_span->from)
        return;
    for (RecordedPast &past : pastOf(place, *history, {m_span->from, until}))
        m_target->add(std::move(past));
}

// What was in force from the beginning to the first description.
void BusRecorder::addEarlierDescriptions(Place place)
{
    const auto first = m_described.find(place);
    if (first == m_described.end())
        return;
    const Instant until = first->second.since;
    RecordedDevice device = recordedDeviceFromJson(first->second.json);
    const std::vector<ValuesSince> known = m_histories.known(place);
    for (std::size_t i = 0; i < known.size(); ++i) {
        const Instant from = std::max(known[i].from, m_span->from);
        const Instant to = i + 1 < known.size() ? std::min(known[i + 1].from, until) : until;
        if (from >= to)
            continue;
        device.known = known[i].values;
        m_target->add(RecordedDescription{place, from, toJson(device)});
    }
}

} // namespace codewheel
