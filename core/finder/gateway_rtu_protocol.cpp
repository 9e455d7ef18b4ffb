// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/gateway_rtu_protocol.h"

#include "encoder/sentence.h"
#include "finder/finder_texts.h"
#include "finder/gateway_host_finder.h"
#include "finder/gateway_rtu_traffic.h"
#include "modbus/gateway_settings.h"
#include "project/ring_plan.h"

namespace codewheel {
namespace {

using Parity = SerialSettings::Parity;

constexpr int lastAskedUnit = 8;
constexpr Instant rtuTimeOut{200'000}; // of a unit behind a gateway; a device on the line is quicker
constexpr int silentOctets = 4;        // between frames: 3.5 characters

const std::vector<SerialSettings> rtuSettings{{19'200, 8, Parity::even, 1}, {9'600, 8, Parity::even, 1},
                                              {19'200, 8, Parity::none, 1}, {9'600, 8, Parity::none, 1},
                                              {38'400, 8, Parity::even, 1}, {115'200, 8, Parity::even, 1},
                                              {115'200, 8, Parity::none, 1}};

Found gatewayOn(const QString &port, const SerialSettings &serial, int unit, bool isInput,
                const QString &sentence)
{
    GatewaySettings settings{
        .transport = GatewaySettings::Transport::rtu, .serialPort = port, .serial = serial};
    settings.unit = unit;
    if (!isInput)
        settings.inArea = RegisterArea::holding;
    return {.kind = QString::fromLatin1(interbusKind),
            .place = port,
            .settings = formatText(serial),
            .sentence = sentence,
            .plan = KindData(ProjectLink{linkKindOf(settings), linkTexts(settings)}),
            .link = QStringLiteral("modbus-rtu:") + port + settingsText(settings)};
}

// Each unit is asked for its first input register, and if it has none, for its first holding register.
class RtuAsking final : public Asking
{
public:
    explicit RtuAsking(QString port)
        : m_port(std::move(port))
    {}

    bool isDone() const override { return m_settings == rtuSettings.size(); }
    SerialSettings settings() const override { return rtuSettings[m_settings]; }
    QString doing() const override
    {
        return sentence(FinderTexts::tr("Asks the Modbus unit %1 for a register."),
                        {QString::number(m_unit)});
    }
    Result<std::optional<Found>> step(ByteLink &link, const std::atomic<bool> &isStopped) override
    {
        const auto answer = ask(link, isStopped);
        if (!answer)
            return tl::unexpected(answer.error());
        std::optional<Found> found;
        if (answer->has_value() && (*answer)->exception != 0 && m_function == inputFunction) {
            m_refusedInput = true;
            m_function = holdingFunction;
            return found;
        }
        if (answer->has_value() || m_refusedInput)
            found = here(answer->has_value() && (*answer)->exception == 0);
        goOn();
        return found;
    }

private:
    static constexpr int inputFunction = 4;
    static constexpr int holdingFunction = 3;

    Result<std::optional<RtuAnswer>> ask(ByteLink &link, const std::atomic<bool> &isStopped)
    {
        const ModbusBytes frame =
            rtuFrame(m_unit, {static_cast<std::uint8_t>(m_function), 0, 0, 0, 1}); // register 0, one of them
        const QByteArray request(reinterpret_cast<const char *>(frame.data()), // NOLINT(*-reinterpret-cast)
                                 static_cast<qsizetype>(frame.size()));
        link.wait(link.now() + settings().timeOf(silentOctets));
        if (auto written = link.write(request); !written)
            return tl::unexpected(written.error());
        QByteArray came;
        const Instant until = link.now() + settings().timeOf(static_cast<int>(request.size())) + rtuTimeOut;
        while (link.now() < until && !isStopped) {
            const auto bytes = link.read(until);
            if (!bytes)
                return tl::unexpected(bytes.error());
            came += *bytes;
            if (auto answer = rtuAnswerIn(came, m_unit, m_function))
                return answer;
        }
        return std::optional<RtuAnswer>();
    }
    Found here(bool isRead)
    {
        m_isAnswered = true;
        const bool isInput = m_function == inputFunction || !isRead;
        return gatewayOn(
            m_port, settings(), m_unit, isInput,
            sentence(FinderTexts::tr("The Modbus unit %1 answers. Whether it shows a ring, its register "
                                     "map says: test it."),
                     {QString::number(m_unit)}));
    }
    // Once one has answered, all others of the line have the same settings.
    void goOn()
    {
        m_function = inputFunction;
        m_refusedInput = false;
        if (++m_unit <= lastAskedUnit)
            return;
        m_unit = 1;
        m_settings = m_isAnswered ? rtuSettings.size() : m_settings + 1;
    }

    const QString m_port;
    std::size_t m_settings = 0;
    int m_unit = 1;
    int m_function = inputFunction;
    bool m_refusedInput = false; // by an exception
    bool m_isAnswered = false;   // by any
};

class RtuProtocol final : public SpokenProtocol
{
public:
    QString name() const override { return QStringLiteral("Modbus RTU"); }
    std::vector<SerialSettings> usualSettings() const override { return rtuSettings; }
    std::optional<Found> heard(const QString &place, const SerialSettings &settings,
                               const QByteArray &bytes) const override
    {
        const int frames = rtuFramesIn(bytes);
        if (frames == 0)
            return std::nullopt;
        Found found =
            gatewayOn(place, settings, 1, true, FinderTexts::tr("A Modbus RTU master works on this line."));
        found.isMasterAtWork = true;
        found.certainty = frames > 1 ? Certainty::certain : Certainty::likely;
        return found;
    }
    QString announcement() const override
    {
        return FinderTexts::tr(
            "Modbus RTU: at 9600 to 115200 Bd with even or no parity, the units 1 to 8 are each asked "
            "for one input register, or else for one holding register.");
    }
    std::unique_ptr<Asking> ask(const QString &place) const override
    {
        return std::make_unique<RtuAsking>(place);
    }
};

} // namespace

std::unique_ptr<const SpokenProtocol> makeRtuProtocol()
{
    return std::make_unique<RtuProtocol>();
}

} // namespace codewheel
