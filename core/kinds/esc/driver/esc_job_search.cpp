// SPDX-License-Identifier: GPL-3.0-or-later
// Where an encoder is after its address or its baud rate was changed.
#include "kinds/esc/driver/esc_job.h"
#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/protocol/esc_refusals.h"

#include <algorithm>

namespace codewheel {
namespace {

using Places = std::vector<EscSearch::Place>;

// Both readings of the two digits, then the address it had; at the master address every encoder answers.
Places placesOfAddress(EscLineAddress wanted, EscLineAddress before, std::optional<int> baudRate)
{
    Places places;
    for (const EscLineAddress reading : escReadingsOf(wanted))
        places.push_back({reading, baudRate});
    const EscSearch::Place old{before, baudRate};
    if (before.isDevice() && std::ranges::find(places, old) == places.end())
        places.push_back(old);
    return places;
}

// The answer was expected at the old rate, so the search starts at the new one.
Places placesOfBaudRate(int wanted, std::optional<int> before, EscLineAddress address)
{
    Places places{{address, wanted}};
    if (before != wanted)
        places.push_back({address, before});
    return places;
}

} // namespace

void EscJob::beginSearch()
{
    const auto wanted = m_steps.current().value;
    m_rateBefore = m_encoder.wantedBaudRate ? m_encoder.wantedBaudRate : m_encoder.baudRate;
    Places places = m_steps.current().parameter() == Parameter::lineAddress
                        ? placesOfAddress({static_cast<std::uint8_t>(wanted)}, m_encoder.address,
                                          m_encoder.wantedBaudRate)
                        : placesOfBaudRate(static_cast<int>(wanted), m_rateBefore, m_encoder.address);
    m_search.emplace(std::move(places), std::max(m_encoder.settings.searchRounds, 1),
                     m_encoder.values.value(Parameter::serialNumber));
    m_encoder.wantedBaudRate = m_search->place().baudRate;
}

void EscJob::searchAnswered(const esc::ExchangeResult &result, Instant now)
{
    const auto state = m_search->answered(result);
    if (state == EscSearch::State::searching) {
        m_encoder.wantedBaudRate = m_search->place().baudRate;
        return;
    }
    const EscSearch search = *std::exchange(m_search, std::nullopt);
    if (state == EscSearch::State::nowhere) {
        m_encoder.wantedBaudRate = m_rateBefore;
        if (m_unanswered)
            m_encoder.values.countEepromWrite();
        m_encoder.values.forget(*m_steps.current().parameter());
        fail({RefusalKind::device, EscRefusalId::notFoundAgain, {search.placesText()}});
    } else if (m_steps.current().parameter() == Parameter::lineAddress) {
        foundAtAddress(search.place().address, now);
    } else {
        foundAtBaudRate(search.place().baudRate, now);
    }
}

void EscJob::foundAtAddress(EscLineAddress found, Instant now)
{
    const EscLineAddress before = m_encoder.address;
    m_encoder.address = found;
    m_encoder.values.learn({Parameter::lineAddress, found.value, Evidence::read, now});
    const bool isWanted = found.value == m_steps.current().value;
    if (found == before && !isWanted) {
        isNotThere(found.value);
        return;
    }
    if (found != before)
        m_encoder.tell(now, isWanted ? Severity::information : Severity::attention,
                       EscMessageId::lineAddressChanged, {before.shown(), found.shown()});
    isThere({Parameter::lineAddress, found.value});
    if (isWanted)
        m_steps.goOn();
    else
        fail({RefusalKind::device,
              RefusalId::verificationFailed,
              {Parameter::lineAddress, m_steps.current().value, std::int64_t{found.value}}});
}

void EscJob::foundAtBaudRate(std::optional<int> found, Instant now)
{
    const int wanted = static_cast<int>(m_steps.current().value);
    if (found != wanted) {
        if (found)
            m_encoder.values.learn({Parameter::baudRate, *found, Evidence::read, now});
        isNotThere(found.value_or(0));
        return;
    }
    RefusalArgument before = QString();
    if (m_rateBefore)
        before = std::int64_t{*m_rateBefore};
    m_encoder.values.learn({Parameter::baudRate, wanted, Evidence::read, now});
    if (m_rateBefore != wanted)
        m_encoder.tell(now, Severity::information, EscMessageId::baudRateChanged,
                       {before, m_steps.current().value});
    isThere({Parameter::baudRate, wanted});
    m_steps.goOn();
}

} // namespace codewheel
