// SPDX-License-Identifier: GPL-3.0-or-later
// What is sent by hand: words, and writes that are typed.
#include "bus/word_channel.h"
#include "jobs/protocol.h"
#include "journal/eeprom_cost.h"
#include "journal/ledger_keeper.h"

#include <algorithm>
#include <utility>

namespace codewheel {
void LedgerKeeper::beginByHand(Place place, Word word)
{
    Watched &watched = m_watched[place];
    const int planned = watched.encoder && ledger() ? mostEepromWrites(*watched.encoder, word) : 0;
    ByHand *noted = byHand(watched, planned);
    if (noted == nullptr)
        return;
    noted->at = m_bus.now();
    const DeviceDescription &device = watched.encoder->device();
    if (const auto value = protocolOf(device).valueIn(device, word))
        replaceValue(noted->sent, *value);
    const int before = watched.encoder->eepromCount().atMost();
    showCount(place);
    warn(place, before);
}

void LedgerKeeper::beginTyped(const TypedWrite &write)
{
    const auto found = m_watched.find(write.place);
    if (found == m_watched.end()) {
        beginToStranger(write);
        return;
    }
    Watched &watched = found->second;
    ByHand *noted = byHand(watched, watched.encoder && ledger() ? 1 : 0);
    if (noted == nullptr)
        return;
    ++noted->awaited;
    for (const ParameterValue &value : write.values)
        replaceValue(noted->sent, value);
}

// The entry for what is being sent by hand, with this many more writes; null: there is none.
LedgerKeeper::ByHand *LedgerKeeper::byHand(Watched &watched, int planned)
{
    if (planned == 0)
        return nullptr;
    if (watched.byHand)
        m_book->plan(watched.byHand->id, planned);
    else if (const auto id = beginEntry(watched, planned))
        watched.byHand = ByHand{.id = *id};
    if (!watched.byHand)
        return nullptr;
    watched.byHand->planned += planned;
    return &*watched.byHand;
}

// The link was lost behind it: what was sent and not counted may have been written.
void LedgerKeeper::loseByHand(Place place, Watched &watched)
{
    const ByHand lost = *std::exchange(watched.byHand, std::nullopt);
    m_book->settle(lost.id, {}, {}, std::max(0, lost.planned - lost.counted));
    showCount(place);
}

bool LedgerKeeper::standsStill(Place place, const EncoderSession &encoder) const
{
    const WordChannel *channel = m_bus.channel(place);
    return channel != nullptr && !encoder.runningJob() && encoder.latest().state == EncoderState::operation &&
           mostEepromWrites(encoder, channel->out()) == 0;
}

void LedgerKeeper::settleByHand()
{
    const Instant now = m_bus.now();
    for (auto &[place, watched] : m_watched) {
        if (!watched.byHand || !watched.encoder)
            continue;
        if (m_bus.state() == BusState::lost)
            loseByHand(place, watched);
        else if (!m_bus.isRunning() || !standsStill(place, *watched.encoder))
            watched.byHand->at = now;
        else if (now - watched.byHand->at >= untilSettled)
            settleByHand(place, watched);
    }
}

void LedgerKeeper::settleTyped(const TypedWrite &write, TypedEnd end)
{
    const auto found = m_watched.find(write.place);
    if (found != m_watched.end() && found->second.byHand) {
        ByHand &noted = *found->second.byHand;
        noted.inDoubt += end == TypedEnd::notKnown ? 1 : 0;
        if (--noted.awaited <= 0)
            settleByHand(write.place, found->second);
    }
    settleToStranger(write, end);
}

void LedgerKeeper::beginToStranger(const TypedWrite &write)
{
    const Ledger::Entry entry{.at = m_bus.dateTime(m_bus.now()).toUTC(),
                              .identity = identity(write.place).key(),
                              .place = write.place,
                              .planned = 1};
    if (const auto id = m_book->begin(entry))
        m_strangers[write.place].push_back({.id = *id, .awaited = write.text});
}

// Without an answer it may have been carried out.
void LedgerKeeper::settleToStranger(const TypedWrite &write, TypedEnd end)
{
    std::vector<ToStranger> &requests = m_strangers[write.place];
    const auto ended = std::ranges::find(requests, std::optional(write.text), &ToStranger::awaited);
    if (ended == requests.end())
        return;
    const qint64 id = ended->id;
    ended->awaited.reset();
    if (m_watched.contains(write.place)) // by now, and it is noted there
        requests.erase(ended);
    if (end == TypedEnd::done)
        m_book->count(id, 1);
    m_book->settle(id, {}, {}, end == TypedEnd::notKnown ? 1 : 0);
}

// It is being added now. What has not been answered yet ends as typed for a stranger, and may be counted by
// the session as well: better twice than never.
void LedgerKeeper::noteWhatWasToStranger(Place place)
{
    std::vector<ToStranger> &requests = m_strangers[place];
    for (const ToStranger &request : requests)
        note(m_watched[place], request.id);
    std::erase_if(requests, [](const ToStranger &request) { return !request.awaited; });
}

void LedgerKeeper::settleByHand(Place place, Watched &watched)
{
    const ByHand done = *std::exchange(watched.byHand, std::nullopt);
    m_book->settle(done.id, done.sent, {}, std::min(done.inDoubt, std::max(0, done.planned - done.counted)));
    showCount(place);
}

} // namespace codewheel
