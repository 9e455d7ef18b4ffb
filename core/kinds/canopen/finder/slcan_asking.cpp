// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_link_argument.h"
#include "can/can_refusals.h"
#include "can/slcan_conversation.h"
#include "finder/finder_texts.h"
#include "finder/listening.h"
#include "kinds/canopen/finder/heard_on_can.h"
#include "kinds/canopen/finder/slcan_spoken_protocol.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shown_text.h"

#include <deque>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant listeningAtRate = 1'200ms; // heartbeats come once a second
constexpr Instant untilClosed = 100ms;
constexpr std::array ratesInTurn{125'000, 250'000, 500'000, 1'000'000, 50'000,
                                 20'000,  10'000,  100'000, 800'000};

// Each step is a rate.
class SlcanAsking final : public Asking
{
public:
    explicit SlcanAsking(QString port)
        : m_port(std::move(port))
        , m_rates(ratesInTurn.begin(), ratesInTurn.end())
    {}

    bool isDone() const override { return m_rates.empty(); }
    SerialSettings settings() const override { return usualSlcanSettings(); }
    QString doing() const override
    {
        return sentence(FinderTexts::tr("Listens through a serial CAN adapter at %1 Bd."),
                        {QString::number(m_rates.front())});
    }
    Result<Asked> step(ByteLink &link, const std::atomic<bool> &isStopped) override
    {
        SlcanConversation talk(m_port, m_rates.front());
        HeardOnCan heard;
        auto led = lead(talk, heard, link, isStopped);
        if (!led)
            return tl::unexpected(led.error());
        return Asked{.found = result(talk, heard)};
    }

private:
    // From its opening to its end; then the adapter is silent again.
    Result<void> lead(SlcanConversation &talk, HeardOnCan &heard, ByteLink &link,
                      const std::atomic<bool> &isStopped)
    {
        using State = SlcanConversation::State;
        talk.open(CanUse::watch, false, std::exchange(m_isNew, false), link.now());
        std::optional<Instant> end;
        m_whyNot.reset();
        while (!isStopped && talk.state() != State::failed && link.now() < end.value_or(Instant::max())) {
            if (auto written = link.write(talk.next(link.now())); !written)
                return written;
            const Instant until =
                std::min(end.value_or(Instant::max()), talk.wakesAt().value_or(link.now() + listeningAtRate));
            const auto bytes = link.read(until);
            if (!bytes)
                return tl::unexpected(bytes.error());
            talk.received(*bytes, link.now());
            if (!end && talk.state() == State::open)
                end = link.now() + listeningAtRate;
            for (const CanFrame &frame : talk.takeNews().frames)
                heard.take(frame);
        }
        if (talk.state() == State::failed)
            m_whyNot = talk.failure();
        if (auto written = link.write(talk.next(link.now()) + talk.close()); !written)
            return written;
        const auto rest = hearUntil(link, link.now() + untilClosed, isStopped);
        return rest ? Result<void>() : tl::unexpected(rest.error());
    }

    // Where somebody was heard, it is not listened at another rate.
    std::optional<Found> result(const SlcanConversation &talk, const HeardOnCan &heard)
    {
        const int rate = m_rates.front();
        m_rates.pop_front();
        const SlcanFirmware &firmware = talk.firmware();
        const bool isThere = !firmware.version.isEmpty();
        if (!isThere || (m_whyNot && m_whyNot->id == CanRefusalId::adapterSilent)) {
            m_rates.clear(); // something else
            return std::nullopt;
        }
        const QString adapter = sentence(FinderTexts::tr("A serial CAN adapter (%1)."),
                                         {shownInLine(QString::fromLatin1(firmware.version))});
        if (heard.isAnything() && !heard.hasErrors()) {
            m_rates.clear();
            Found found = at(rate, adapter + u' ' + heard.sentence());
            found.isMasterAtWork = heard.isMasterAtWork();
            return found;
        }
        if (m_whyNot && m_whyNot->id == CanRefusalId::watchNotSure) {
            m_rates.clear();
            return at(ratesInTurn.front(), adapter + u' ' + refusalText(*m_whyNot));
        }
        if (!m_rates.empty())
            return std::nullopt;
        return at(ratesInTurn.front(),
                  adapter + u' ' +
                      FinderTexts::tr("Nobody is heard at any rate: nodes that were not started may tell "
                                      "nothing by themselves, and the rate is not known."));
    }

    Found at(int rate, const QString &text) const
    {
        return canBusAt(m_port, QStringLiteral("slcan:") + m_port, rate, text);
    }

    const QString m_port;
    std::deque<int> m_rates;
    bool m_isNew = true; // the port was opened just now
    std::optional<Refusal> m_whyNot;
};

} // namespace

SerialSettings usualSlcanSettings()
{
    return {
        .baudRate = CanLinkArgument::usualBaudRate, .parity = SerialSettings::Parity::none, .stopBits = 1};
}

std::unique_ptr<Asking> askSlcanAdapter(const QString &port)
{
    return std::make_unique<SlcanAsking>(port);
}

} // namespace codewheel
