// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/finder/gateway_rtu_protocol.h"

#include "finder/finder_texts.h"
#include "kinds/interbus/finder/gateway_rtu_asking.h"
#include "kinds/interbus/finder/gateway_rtu_traffic.h"

namespace codewheel {
namespace {

class RtuProtocol final : public SpokenProtocol
{
public:
    QString name() const override { return QStringLiteral("Modbus RTU"); }
    std::vector<SerialSettings> usualSettings() const override { return usualRtuSettings(); }
    std::optional<Found> heard(const QString &place, const SerialSettings &settings,
                               const QByteArray &bytes) const override
    {
        const int frames = rtuFramesIn(bytes);
        if (frames == 0)
            return std::nullopt;
        Found found =
            gatewayAt(place, settings, {}, FinderTexts::tr("A Modbus RTU master works on this line."));
        found.isMasterAtWork = true;
        found.certainty = frames > 1 ? Certainty::certain : Certainty::likely;
        return found;
    }
    QString announcement() const override
    {
        return FinderTexts::tr(
            "Modbus RTU: at 9600 to 115200 Bd with even or no parity, the units 1 to 8 are each asked "
            "for one input register, or else for one holding register; whoever answers is asked once more.");
    }
    std::unique_ptr<Asking> ask(const QString &place) const override { return askForUnits(place); }
};

} // namespace

std::unique_ptr<const SpokenProtocol> makeRtuProtocol()
{
    return std::make_unique<RtuProtocol>();
}

} // namespace codewheel
