// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/line_esc_protocol.h"

#include "encoder/hex.h"
#include "encoder/sentence.h"
#include "esc/esc_frame.h"
#include "esc_line/exchange_over_link.h"
#include "esc_line/line_scan.h"
#include "finder/finder_texts.h"
#include "project/line_plan.h"

#include <deque>

namespace codewheel {
namespace {

constexpr int knockings = 2; // at the master address, for one that was lost

SerialSettings escSettings(int baudRate)
{
    SerialSettings settings;
    settings.baudRate = baudRate;
    return settings;
}

const std::vector<int> escRates{19'200, 9'600, 4'800}; // that of the factory first

Found onLine(const QString &port, const SerialSettings &settings, const QString &sentence)
{
    LinePlan plan;
    plan.settings.port = port;
    plan.settings.serial = settings;
    return {.kind = QString::fromLatin1(escKind),
            .place = port,
            .settings = formatText(settings),
            .sentence = sentence,
            .plan = KindData(plan),
            .link = QStringLiteral("esc:%1,baud=%2").arg(port).arg(settings.baudRate)};
}

QString encoderText(const FoundEncoder &encoder)
{
    const QString who = encoder.version.isEmpty() ? FinderTexts::tr("An encoder with the Kübler ESC protocol")
                                                  : encoder.version;
    const QString where = encoder.address.isMaster()
                              ? FinderTexts::tr("at the master address")
                              : sentence(FinderTexts::tr("at address %1"), {encoder.address.shown()});
    const QString number =
        encoder.serialNumber ? sentence(FinderTexts::tr("serial number %1"), {hexWord(*encoder.serialNumber)})
                             : FinderTexts::tr("no serial number");
    return QStringLiteral("%1, %2, %3").arg(who, where, number);
}

// First at the master address at each rate, then at every address where anything came.
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
        const LineAddress address = m_scan ? m_scan->next()->request.to : LineAddress::master();
        return sentence(FinderTexts::tr("Asks for an encoder with the Kübler ESC protocol at address %1."),
                        {address.shown()});
    }
    Result<std::optional<Found>> step(ByteLink &link, const std::atomic<bool> &isStopped) override
    {
        const esc::Request request = m_scan ? m_scan->next()->request
                                            : esc::Request{LineAddress::master(), esc::Command::serialNumber};
        esc::Timing timing;
        timing.character = settings().timeOf(1);
        timing.retries = 0;
        const auto result = exchangeOver(link, request, timing, isStopped);
        if (!result)
            return tl::unexpected(result.error());
        return m_scan ? scanned(*result) : knocked(*result);
    }

private:
    std::optional<Found> knocked(const esc::ExchangeResult &result)
    {
        const int rate = m_knocks.front();
        m_knocks.pop_front();
        if (!result.answer && result.garbageBytes + result.lateBytes == 0)
            return std::nullopt;
        m_knocks.clear(); // others of the line have the same rate, as nothing else could work
        m_scan.emplace(ScanWish{.baudRates = {rate}});
        return std::nullopt;
    }
    std::optional<Found> scanned(const esc::ExchangeResult &result)
    {
        const std::size_t before = m_scan->found().size();
        m_scan->answered(result);
        std::optional<Found> news;
        if (m_scan->found().size() > before)
            news = onLine(m_port, escSettings(m_scan->found().back().baudRate),
                          encoderText(m_scan->found().back()));
        if (!m_scan->next())
            m_scan.reset();
        return news;
    }

    const QString m_port;
    std::deque<int> m_knocks; // the baud rate of each
    std::optional<LineScan> m_scan;
};

// Whole requests between ESC and the end of a line.
int requestsIn(const QByteArray &bytes)
{
    int requests = 0;
    for (qsizetype begin = bytes.indexOf(esc::escape); begin >= 0;
         begin = bytes.indexOf(esc::escape, begin + 1)) {
        const qsizetype end = bytes.indexOf(esc::lineEnd, begin);
        if (end > begin && esc::parseRequest(QByteArrayView(bytes).sliced(begin + 1, end - begin - 1)))
            ++requests;
    }
    return requests;
}

int answersIn(const QByteArray &bytes)
{
    return static_cast<int>(esc::valuesIn(bytes, esc::shapeOf(esc::Command::position)).size());
}

class EscProtocol final : public SpokenProtocol
{
public:
    QString name() const override { return QStringLiteral("Kübler ESC"); }
    std::vector<SerialSettings> usualSettings() const override
    {
        std::vector<SerialSettings> all;
        all.reserve(std::size(escRates));
        for (const int rate : escRates)
            all.push_back(escSettings(rate));
        return all;
    }
    std::optional<Found> heard(const QString &place, const SerialSettings &settings,
                               const QByteArray &bytes) const override
    {
        const int signs = requestsIn(bytes) + answersIn(bytes);
        if (signs == 0)
            return std::nullopt;
        Found found = onLine(place, settings,
                             FinderTexts::tr("A master works on this line with the Kübler ESC protocol."));
        found.isMasterAtWork = true;
        found.certainty = signs > 1 ? Certainty::certain : Certainty::likely;
        return found;
    }
    QString announcement() const override
    {
        return FinderTexts::tr(
            "Kübler ESC: at 19200, 9600 and 4800 Bd, 8N2, the master address 00 is asked for a "
            "serial number, twice; where anything comes, each address from 01 to 1F is asked "
            "for serial number, device code and version.");
    }
    std::unique_ptr<Asking> ask(const QString &place) const override
    {
        return std::make_unique<EscAsking>(place);
    }
};

} // namespace

std::unique_ptr<const SpokenProtocol> makeEscProtocol()
{
    return std::make_unique<EscProtocol>();
}

} // namespace codewheel
