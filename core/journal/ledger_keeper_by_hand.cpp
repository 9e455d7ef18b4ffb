// SPDX-License-Identifier: GPL-3.0-or-later
// What is sent by hand: words on a ring, requests on a serial line.
#include "catalog/device_description.h"
#include "journal/eeprom_cost.h"
#include "journal/ledger_keeper.h"
#include "ring/bus_session.h"
#include "ring/word_channel.h"

#include <utility>

namespace codewheel {

void LedgerKeeper::beginByHand(DeviceNumber place, Word word)
{
    Watched &watched = m_watched[place];
    const int planned = watched.encoder && m_ledger ? mostEepromWrites(*watched.encoder, word) : 0;
    ByHand *noted = byHand(watched, planned);
    if (noted == nullptr)
        return;
    noted->at = m_bus.now();
    const auto *parameter =
        k3::isParameterWord(word) ? watched.encoder->device().findNumber(k3::number(word)) : nullptr;
    if (parameter != nullptr)
        replaceValue(noted->sent, {parameter->parameter, k3::data(word)});
}

void LedgerKeeper::beginByHand(DeviceNumber place, const esc::Request &request)
{
    Watched &watched = m_watched[place];
    ByHand *noted = byHand(watched, watched.encoder && m_ledger ? 1 : 0);
    if (noted == nullptr)
        return;
    ++noted->awaited;
    for (const ParameterDescription &parameter : watched.encoder->device().parameters)
        if (parameter.writeCommand == request.command)
            replaceValue(noted->sent, {parameter.parameter, request.data});
}

// The entry for what is sent by hand now, with so many writes more; null: there is none.
LedgerKeeper::ByHand *LedgerKeeper::byHand(Watched &watched, int planned)
{
    if (planned == 0)
        return nullptr;
    if (watched.byHand)
        if (auto more = m_ledger->plan(watched.byHand->id, planned); !more)
            failed(more.error()); // and forgets the entry
    if (!watched.byHand && m_ledger)
        if (const auto id = beginEntry(watched, planned))
            watched.byHand = ByHand{.id = *id};
    return watched.byHand ? &*watched.byHand : nullptr;
}

bool LedgerKeeper::standsStill(DeviceNumber place, const EncoderSession &encoder) const
{
    const WordChannel *channel = m_ring ? m_ring->channel(place) : nullptr;
    return channel != nullptr && !encoder.runningJob() && encoder.latest().state == EncoderState::operation &&
           mostEepromWrites(encoder, channel->out()) == 0;
}

void LedgerKeeper::settleByHand()
{
    const Instant now = m_bus.now();
    for (auto &[place, watched] : m_watched) {
        if (!watched.byHand || !watched.encoder)
            continue;
        if (!m_bus.isRunning() || !standsStill(place, *watched.encoder))
            watched.byHand->at = now;
        else if (now - watched.byHand->at >= untilSettled)
            settleByHand(place, watched);
    }
}

void LedgerKeeper::settleRequest(const esc::Request &request)
{
    if (!esc::shapeOf(request.command).writes)
        return;
    for (auto &[place, watched] : m_watched) {
        const bool isAsked = request.to.isMaster() || place.line == request.to;
        if (isAsked && watched.byHand && --watched.byHand->awaited <= 0)
            settleByHand(place, watched);
    }
}

void LedgerKeeper::settleByHand(DeviceNumber place, Watched &watched)
{
    const ByHand done = *std::exchange(watched.byHand, std::nullopt);
    if (!m_ledger)
        return;
    if (auto settled = m_ledger->settle(done.id, done.sent); !settled)
        failed(settled.error());
    showCount(place);
}

} // namespace codewheel
