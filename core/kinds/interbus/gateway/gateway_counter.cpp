// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_counter.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant betweenFigures = 200ms;
constexpr Instant rateOver = 1s;
constexpr Instant firstRateOver = 100ms;

} // namespace

void GatewayCounter::transaction(const RegisterPort::Done &done, Instant begun, Instant now, bool again)
{
    using Kind = RegisterError::Kind;
    if (!done && done.error().kind == Kind::stopped)
        return;
    ++m_figures.transactions;
    m_figures.retries += again ? 1 : 0;
    if (done)
        m_figures.roundTrip = m_roundTrips.note(now - begun);
    else if (done.error().kind == Kind::noAnswer)
        ++m_figures.noAnswers;
    else if (done.error().kind == Kind::exception)
        ++m_figures.exceptions[done.error().exception];
    else if (done.error().kind == Kind::wrongAnswer)
        ++m_figures.wrongAnswers;
    else
        ++m_figures.closed;
    if (!done || now - m_toldAt >= betweenFigures)
        show(now);
}

void GatewayCounter::noticed(const RegisterPort::Noticed &by)
{
    m_renewals = by.renewals;
    m_figures.reconnections = by.reconnections;
    m_figures.closedAfterEach = by.closedAfterEach;
    m_figures.closesAfterEach = by.keepsNone;
    m_figures.strayBytes = by.strayBytes;
    m_figures.echoes = by.echoes;
}

LinkFigures GatewayCounter::counted() const
{
    LinkFigures figures = m_figures;
    figures.connections = m_opened + m_renewals;
    return figures;
}

void GatewayCounter::show(Instant now)
{
    m_told = std::make_shared<const LinkFigures>(counted());
    m_toldAt = now;
}

void GatewayCounter::closed(Instant now)
{
    m_figures.exchangesPerSecond = 0;
    m_figures.status.reset();
    m_countedSince = now;
    m_countedFrom = m_figures.exchanges;
    show(now);
}

void GatewayCounter::exchanged(Instant now)
{
    ++m_figures.exchanges;
    const Instant counted = now - m_countedSince;
    const bool isFirst = m_figures.exchangesPerSecond == 0;
    if (counted < (isFirst ? firstRateOver : rateOver))
        return;
    m_figures.exchangesPerSecond = static_cast<double>(m_figures.exchanges - m_countedFrom) /
                                   std::chrono::duration<double>(counted).count();
    if (isFirst)
        return; // it goes on counting
    m_countedSince = now;
    m_countedFrom = m_figures.exchanges;
}

} // namespace codewheel
