// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/finder/gateway_rtu_asking.h"

#include "finder/finder_texts.h"
#include "kinds/interbus/finder/gateway_host_finder.h"
#include "kinds/interbus/finder/gateway_rtu_traffic.h"
#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

using Parity = SerialSettings::Parity;

constexpr int lastAskedUnit = 8;
constexpr int inputFunction = 4;
constexpr int holdingFunction = 3;
constexpr Instant rtuTimeOut{200'000};  // of a unit behind a gateway; a device on the line is quicker
constexpr std::size_t mostRequests = 3; // of one unit for one register, until two answers agree

// What came with one request.
struct RtuReception
{
    std::optional<RtuAnswer> answer{};
    OtherBytes others{};
};

QByteArray requestTo(int unit, int function)
{
    // Register 0, one of them.
    return rtuByteArray(rtuFrame(unit, {static_cast<std::uint8_t>(function), 0, 0, 0, 1}));
}

// Strangers: a frame of somebody else, or more than an answer.
RtuReception sorted(QByteArray came, const QByteArray &echo, const std::optional<RtuAnswer> &answer)
{
    if (answer)
        came.remove(answer->begin, answer->size);
    if (const qsizetype at = came.indexOf(echo); at >= 0)
        came.remove(at, echo.size());
    const qsizetype damaged = answer ? 0 : longestRtuAnswer;
    const bool areStrangers = came.size() > damaged + glitches || rtuFramesIn(came) > 0;
    return {answer, {came, areStrangers}};
}

class RtuAsking final : public Asking
{
public:
    explicit RtuAsking(QString port)
        : m_port(std::move(port))
        , m_all(usualRtuSettings())
    {}

    bool isDone() const override { return m_settings == m_all.size(); }
    SerialSettings settings() const override { return m_all[m_settings]; }
    QString doing() const override
    {
        return sentence(FinderTexts::tr("Asks the Modbus unit %1 for a register."),
                        {QString::number(m_unit)});
    }
    Result<Asked> step(ByteLink &link, const std::atomic<bool> &isStopped) override
    {
        return ask(link, isStopped).map([this](const RtuReception &came) {
            return Asked{.found = answered(came.answer), .others = came.others};
        });
    }

private:
    Result<RtuReception> ask(ByteLink &link, const std::atomic<bool> &isStopped) const
    {
        const QByteArray request = requestTo(m_unit, m_function);
        if (auto written = link.write(request); !written)
            return tl::unexpected(written.error());
        QByteArray came;
        const Instant until = link.now() + settings().timeOf(static_cast<int>(request.size())) + rtuTimeOut;
        while (link.now() < until && !isStopped) {
            const auto bytes = link.read(until);
            if (!bytes)
                return tl::unexpected(bytes.error());
            came += *bytes;
            if (const auto answer = rtuAnswerIn(came, m_unit, m_function))
                return sorted(came, request, answer);
        }
        return sorted(came, request, {});
    }
    std::optional<Found> answered(const std::optional<RtuAnswer> &answer)
    {
        if (answer && std::ranges::find(m_exceptions, answer->exception) == m_exceptions.end())
            m_exceptions.push_back(answer->exception);
        else if (answer)
            return agreed(answer->exception);
        if (m_exceptions.empty() || ++m_requests == mostRequests)
            return nobody();
        return std::nullopt;
    }
    std::optional<Found> agreed(int exception)
    {
        if (exception != 0 && m_function == inputFunction) {
            ask(holdingFunction);
            return std::nullopt;
        }
        const bool hasInput = m_function == inputFunction || exception != 0;
        const Found found = here(hasInput);
        goOn();
        return found;
    }
    // That it refuses to read input registers is an answer as well.
    std::optional<Found> nobody()
    {
        std::optional<Found> found;
        if (m_function == holdingFunction)
            found = here(true);
        goOn();
        return found;
    }
    Found here(bool hasInput)
    {
        m_isAnswered = true;
        return gatewayAt(m_port, settings(), {m_unit, hasInput},
                         sentence(FinderTexts::tr("The Modbus unit %1 answers. Whether it shows a ring, its "
                                                  "register map says: test it."),
                                  {QString::number(m_unit)}));
    }
    void ask(int function)
    {
        m_function = function;
        m_exceptions.clear();
        m_requests = 0;
    }
    // Once one has answered, all others of the line have the same settings.
    void goOn()
    {
        ask(inputFunction);
        if (++m_unit <= lastAskedUnit)
            return;
        m_unit = 1;
        m_settings = m_isAnswered ? m_all.size() : m_settings + 1;
    }

    const QString m_port;
    const std::vector<SerialSettings> m_all;
    std::size_t m_settings = 0;
    int m_unit = 1;
    int m_function = inputFunction;
    std::vector<int> m_exceptions; // of the answers so far; 0: it was read
    std::size_t m_requests = 0;    // that did not agree
    bool m_isAnswered = false;     // by any
};

} // namespace

std::vector<SerialSettings> usualRtuSettings()
{
    return {{19'200, 8, Parity::even, 1}, {9'600, 8, Parity::even, 1},  {19'200, 8, Parity::none, 1},
            {9'600, 8, Parity::none, 1},  {38'400, 8, Parity::even, 1}, {115'200, 8, Parity::even, 1},
            {115'200, 8, Parity::none, 1}};
}

Found gatewayAt(const QString &port, const SerialSettings &serial, RtuUnit unit, const QString &sentence)
{
    GatewaySettings settings{
        .transport = GatewaySettings::Transport::rtu, .serialPort = port, .serial = serial};
    settings.unit = unit.unit;
    if (!unit.hasInput)
        settings.inArea = RegisterArea::holding;
    return {.kind = QString::fromLatin1(interbusKind),
            .place = port,
            .settings = formatText(serial),
            .sentence = sentence,
            .plan = KindData(ProjectLink{linkKindOf(settings), linkTexts(settings)}),
            .link = QStringLiteral("modbus-rtu:") + port + settingsText(settings)};
}

std::unique_ptr<Asking> askForUnits(const QString &port)
{
    return std::make_unique<RtuAsking>(port);
}

} // namespace codewheel
