// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_encoder_session.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/words/k3_word.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace codewheel {
namespace {

// Not by its make, which no master can tell.
bool isSameDevice(const RingDevice &before, const RingDevice &found)
{
    return before.number == found.number && before.deviceCode == found.deviceCode &&
           before.inWords == found.inWords && before.outWords == found.outWords &&
           (found.deviceKey.isEmpty() || found.deviceKey == before.deviceKey);
}

} // namespace

// What is unchanged keeps its driver, session and channel; only its index may differ.
command::UseRing RingSession::takeOver(const RingFound &found)
{
    const RingStructure before = std::exchange(m_structure, found.structure);
    auto sessionsBefore = std::exchange(m_sessions, {});
    auto channelsBefore = std::exchange(m_channels, {});
    m_sessions.resize(m_structure.size());
    m_renamings.assign(m_structure.size(), 0);
    command::UseRing use{{}, found.out, {}};
    for (std::size_t i = 0; i < m_structure.size(); ++i) {
        RingDevice &participant = m_structure[i];
        const auto same = std::ranges::find_if(
            before, [&](const RingDevice &other) { return isSameDevice(other, participant); });
        if (same == before.end()) {
            m_channels.push_back(makeChannel(participant));
            use.drivers.push_back(
                {makeSession(i, m_catalog.find(participant.deviceKey, participant.deviceCode)), {}});
            continue;
        }
        const auto j = static_cast<std::size_t>(same - before.begin());
        participant.deviceKey = same->deviceKey;
        use.drivers.push_back({nullptr, j});
        m_channels.push_back(std::move(channelsBefore[j]));
        m_sessions[i] = std::move(sessionsBefore[j]);
        if (m_sessions[i])
            m_sessions[i]->moveIndexTo(i);
    }
    std::ranges::move(sessionsBefore, std::back_inserter(m_retired));
    std::ranges::move(channelsBefore, std::back_inserter(m_retiredChannels));
    use.structure = m_structure;
    return use;
}

void RingSession::takeOfMaster(const MasterEvent &event)
{
    if (const auto *progress = std::get_if<ReadInProgress>(&event)) {
        Q_EMIT readInProgressed(progress->devices);
    } else if (const auto *kept = std::get_if<KeptConfigurationTold>(&event)) {
        Q_EMIT keptConfigurationTold(kept->configuration);
    } else {
        m_readingIn = false;
        if (const auto &result = std::get<ReadInEnded>(event).result; result)
            Q_EMIT readInEnded();
        else
            Q_EMIT readInFailed(result.error());
    }
}

// As it will be once the first cycle has carried this out.
void RingSession::useFirstRing(const RingFound &found)
{
    const bool operates = m_start == Start::operating;
    post(makeDevices(found));
    post(command::AskKeptConfiguration{.onConnecting = true});
    post(command::StartBus{});
    if (operates)
        post(command::SetOperate{true});
    showNewRing(found, {.at = latest().at, .state = MasterState::run, .operate = operates});
    Q_EMIT nodesChanged();
}

void RingSession::useOtherRing(const RingFound &found)
{
    endJobsOfBefore();
    if (!isOpen()) // closed by a handler
        return;
    post(takeOver(found));
    const Snapshot &before = latest();
    showNewRing(
        found,
        {.at = before.at, .state = MasterState::active, .operate = before.operate, .period = before.period});
    m_crcHistory.clear();
    Q_EMIT structureChanged();
    Q_EMIT nodesChanged();
}

// Those that came too late for the previous ring: the bus thread refuses them, but nobody listens to it about
// them any more.
void RingSession::endJobsOfBefore()
{
    for (std::size_t i = 0; i < m_sessions.size(); ++i)
        if (RingEncoderSession *session = m_sessions[i].get(); session && session->runningJob())
            session->take(
                Event(notTaken(*session->runningJob(), {RefusalKind::stopped, RefusalId::busStopped, {}},
                               session->latest().state)),
                latest().at);
}

void RingSession::showNewRing(const RingFound &found, const RingState &state)
{
    auto shown = std::make_shared<Snapshot>();
    static_cast<RingState &>(*shown) = state;
    shown->generation = ++m_generation;
    shown->connected = true;
    shown->master = found.master;
    shown->figures = found.figures;
    for (const Word word : found.out)
        shown->devices.push_back({.out = word, .reading = {}, .outIsKnown = found.outIsKnown});
    m_engine.setLatest(std::move(shown));
    showLatest();
}

void RingSession::bringBack(Place place)
{
    m_toBringBack = place;
    setOperate(true);
    goOnBringingBack();
}

// A read clears OUT first. Where nothing can be read, the word is all there is.
void RingSession::goOnBringingBack()
{
    if (!m_toBringBack || !isOperating())
        return;
    const auto encoder = encoderAt(std::exchange(m_toBringBack, std::nullopt)->node);
    if (encoder == nullptr)
        return;
    const auto *driven = static_cast<RingEncoderSession *>(encoder);
    const std::vector<Parameter> unknown = driven->readableDoubts();
    startReported(*encoder, unknown.empty() ? Job(SendWords{.words = {k3::normalRunning}})
                                            : Job(ReadParameters{unknown}));
}

void RingSession::sendRun(Place place)
{
    if (EncoderSession *encoder = encoderAt(place.node))
        startReported(*encoder, EndParameterization{});
}

void RingSession::startReported(EncoderSession &encoder, const Job &job)
{
    if (const auto started = encoder.start(job, Pace::byItself); !started)
        Q_EMIT refused(started.error());
}

std::optional<DataCheck> RingSession::checkWord(std::size_t device) const
{
    const EncoderSession *encoder = showing(device);
    return encoder != nullptr ? m_link->checkWord(device, latest().devices[device].in, *encoder)
                              : std::nullopt;
}

void RingSession::readIn()
{
    if (!isOpen())
        return;
    m_readingIn = true;
    m_stoppedBy = StoppedBy::other;
    post(command::ReadIn{});
}

} // namespace codewheel
