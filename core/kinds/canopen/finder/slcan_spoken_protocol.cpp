// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/finder/slcan_spoken_protocol.h"

#include "can/slcan_codec.h"
#include "finder/finder_texts.h"
#include "kinds/canopen/finder/heard_on_can.h"

namespace codewheel {
namespace {

constexpr int leastFrames = 3; // what else there is has not so many lines of this form

class SlcanProtocol final : public SpokenProtocol
{
public:
    QString name() const override { return QStringLiteral("SLCAN"); }
    // Behind another port there may be a line of encoders, which would get what is sent.
    Fit fitsAt(const QString &port) const override
    {
        const QString name = port.section(u'/', -1);
        const bool isAdapter = name.startsWith(QStringLiteral("ttyACM")) ||
                               name.contains(QStringLiteral("CANUSB"), Qt::CaseInsensitive) ||
                               name.contains(QStringLiteral("LAWICEL"), Qt::CaseInsensitive);
        return isAdapter ? Fit::first : Fit::none;
    }
    std::vector<SerialSettings> usualSettings() const override { return {usualSlcanSettings()}; }
    // An adapter that somebody has left open.
    std::optional<Found> heard(const QString &place, const SerialSettings & /*settings*/,
                               const QByteArray &bytes) const override
    {
        HeardOnCan heard;
        int frames = 0;
        for (const SlcanItem &item : SlcanReader().read(bytes))
            if (item.kind == SlcanItem::Kind::frame) {
                heard.take(item.frame);
                ++frames;
            }
        if (frames < leastFrames)
            return std::nullopt;
        Found found = canBusAt(place, QStringLiteral("slcan:") + place, std::nullopt,
                               FinderTexts::tr("A serial CAN adapter that is open; its rate is not known.") +
                                   u' ' + heard.sentence());
        found.isMasterAtWork = heard.isMasterAtWork();
        return found;
    }
    QString announcement() const override
    {
        return FinderTexts::tr(
            "SLCAN: at ports as ttyACM0 a serial CAN adapter is asked for its version, then it "
            "listens at each rate. On the CAN bus nothing is sent. At others, as ttyUSB0, none is asked, as "
            "a line of encoders may be behind them: one with CANUSB or LAWICEL in its name below "
            "/dev/serial/by-id is, where that is given.");
    }
    std::unique_ptr<Asking> ask(const QString &place) const override { return askSlcanAdapter(place); }
};

} // namespace

std::unique_ptr<const SpokenProtocol> makeSlcanProtocol()
{
    return std::make_unique<SlcanProtocol>();
}

} // namespace codewheel
