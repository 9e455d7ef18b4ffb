// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/finder/esc_spoken_protocol.h"

#include "finder/finder_texts.h"
#include "kinds/esc/protocol/esc_frame.h"
#include "kinds/esc/protocol/esc_request.h"

namespace codewheel {
namespace {

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
    std::vector<SerialSettings> usualSettings() const override { return usualEscSettings(); }
    std::optional<Found> heard(const QString &place, const SerialSettings &settings,
                               const QByteArray &bytes) const override
    {
        const int signs = requestsIn(bytes) + answersIn(bytes);
        if (signs == 0)
            return std::nullopt;
        Found found = escLineAt(place, settings,
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
    std::unique_ptr<Asking> ask(const QString &place) const override { return askForEncoders(place); }
};

} // namespace

std::unique_ptr<const SpokenProtocol> makeEscProtocol()
{
    return std::make_unique<EscProtocol>();
}

} // namespace codewheel
