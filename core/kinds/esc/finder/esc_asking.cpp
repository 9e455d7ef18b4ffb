// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/finder_texts.h"
#include "finder/listening.h"
#include "kinds/esc/finder/esc_others.h"
#include "kinds/esc/finder/esc_spoken_protocol.h"
#include "kinds/esc/line/esc_line_scan.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/protocol/esc_frame.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace codewheel {
namespace {

constexpr int knockings = 2;                   // at the master address, for one that was lost
constexpr Instant whereLatencyIsUsual{18'000}; // so late an adapter hands over bytes that it collects
const std::vector<int> escRates{19'200, 9'600, 4'800};

SerialSettings escSettings(int baudRate)
{
    SerialSettings settings;
    settings.baudRate = baudRate;
    return settings;
}

QString encoderText(const FoundEncoder &encoder)
{
    const QString who = encoder.version.isEmpty() ? FinderTexts::tr("An encoder with the Kübler ESC protocol")
                                                  : encoder.version;
    const QString where = encoder.address.isMaster()
                              ? FinderTexts::tr("at the master address")
                              : sentence(FinderTexts::tr("at address %1"), {encoder.address.shown()});
    const QString number = encoder.serialNumber ? sentence(FinderTexts::tr("serial number %1"),
                                                           {serialNumberText(*encoder.serialNumber)})
                                                : FinderTexts::tr("no serial number");
    return QStringLiteral("%1, %2, %3").arg(who, where, number);
}

esc::Timing timingOn(const ByteLink &link, const SerialSettings &settings)
{
    esc::Timing timing;
    timing.character = settings.timeOf(1);
    timing.retries = 0;
    if (link.lowLatency() == LowLatency::refused)
        timing.adapterDelay = whereLatencyIsUsual;
    return timing;
}

// Until when an answer may come to a request that is sent now.
Instant lastAnswer(const ByteLink &link, const esc::Request &request, const esc::Timing &timing)
{
    const qsizetype characters = request.bytes().size() + esc::answerSize(esc::shapeOf(request.command));
    return link.now() + timing.character * characters + timing.answerTimeOut + timing.adapterDelay;
}

class EscAsking final : public Asking
{
public:
    explicit EscAsking(QString port)
        : m_port(std::move(port))
    {
        for (const int rate : escRates)
            for (int i = 0; i < knockings; ++i)
                m_knocks.push_back(rate);
    }

    bool isDone() const override { return m_knocks.empty() && !m_scan; }
    SerialSettings settings() const override
    {
        return escSettings(m_scan ? m_scan->next()->baudRate : m_knocks.front());
    }
    QString doing() const override
    {
        const EscLineAddress address = m_scan ? m_scan->next()->request.to : EscLineAddress::master();
        return sentence(FinderTexts::tr("Asks for an encoder with the Kübler ESC protocol at address %1."),
                        {address.shown()});
    }
    Result<Asked> step(ByteLink &link, const std::atomic<bool> &isStopped) override
    {
        return m_scan ? scan(link, isStopped) : knock(link, isStopped);
    }

private:
    // Others of the line have the same rate, as nothing else could work.
    Result<Asked> knock(ByteLink &link, const std::atomic<bool> &isStopped)
    {
        const esc::Request request{EscLineAddress::master(), esc::Command::serialNumber};
        const esc::Timing timing = timingOn(link, settings());
        const Instant end = lastAnswer(link, request, timing);
        const auto exchange = exchangeOver(link, request, timing, isStopped);
        if (!exchange)
            return tl::unexpected(exchange.error());
        const auto after = hearUntil(link, end, isStopped);
        if (!after)
            return tl::unexpected(after.error());
        Asked asked{.others = othersAtMaster(*exchange, *after)};
        const int rate = m_knocks.front();
        m_knocks.pop_front();
        const auto &answer = exchange->result.answer;
        if (answer || asked.others.all.size() > glitches) {
            m_atMaster = answer ? answer->text : QByteArray();
            std::erase(m_knocks, rate);
            m_scan.emplace(ScanWish{.baudRates = {rate}});
        }
        return asked;
    }
    Result<Asked> scan(ByteLink &link, const std::atomic<bool> &isStopped)
    {
        const esc::Request request = m_scan->next()->request;
        const auto exchange = exchangeOver(link, request, timingOn(link, settings()), isStopped);
        if (!exchange)
            return tl::unexpected(exchange.error());
        Asked asked{.found = answered(exchange->result), .others = othersAround(request, *exchange)};
        if (hasVanished(request.to, exchange->result, asked.found.has_value()))
            asked.others.areStrangers = true;
        if (!m_scan->next())
            endScan(asked.others);
        return asked;
    }
    std::optional<Found> answered(const esc::ExchangeResult &result)
    {
        const std::vector<FoundEncoder> before = m_scan->found();
        m_scan->answered(result);
        const std::vector<FoundEncoder> &after = m_scan->found();
        if (after.size() == before.size())
            return std::nullopt;
        const FoundEncoder &encoder = *std::ranges::mismatch(before, after).in2; // they are in their order
        Found found = escLineAt(m_port, escSettings(encoder.baudRate), encoderText(encoder));
        found.device = KindData(encoder);
        return found;
    }
    // Who answered once and never again was not asked: that was an answer to somebody else.
    bool hasVanished(EscLineAddress address, const esc::ExchangeResult &result, bool isFound)
    {
        m_hasAnswered = m_hasAnswered || result.answer;
        const auto next = m_scan->next();
        if (next && next->request.to == address)
            return false;
        return std::exchange(m_hasAnswered, false) && !result.answer && !isFound;
    }
    // That somebody answered at the master address, but nobody at any other, is to be told.
    void endScan(OtherBytes &others)
    {
        if (!m_scan->found().empty())
            m_knocks.clear(); // nobody speaks at another rate
        else if (others.all.isEmpty())
            others.all = m_atMaster;
        m_scan.reset();
    }

    const QString m_port;
    std::deque<int> m_knocks; // the baud rate of each
    QByteArray m_atMaster;    // what answered there
    std::optional<EscLineScan> m_scan;
    bool m_hasAnswered = false; // the present address of the scan
};

} // namespace

std::vector<SerialSettings> usualEscSettings()
{
    std::vector<SerialSettings> all;
    all.reserve(escRates.size());
    for (const int rate : escRates)
        all.push_back(escSettings(rate));
    return all;
}

Found escLineAt(const QString &port, const SerialSettings &settings, const QString &sentence)
{
    EscLinePlan plan;
    plan.settings.port = port;
    plan.settings.serial = settings;
    return {.kind = QString::fromLatin1(escKind),
            .place = port,
            .settings = formatText(settings),
            .sentence = sentence,
            .plan = KindData(plan),
            .link = QStringLiteral("esc:%1,baud=%2").arg(port).arg(settings.baudRate)};
}

std::unique_ptr<Asking> askForEncoders(const QString &port)
{
    return std::make_unique<EscAsking>(port);
}

} // namespace codewheel
