// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/afresh.h"

#include "bus/encoder_bus.h"
#include "vocabulary/refusal_text.h"

#include <algorithm>

namespace codewheel {

QString Afresh::whyNot(const EncoderBus *bus)
{
    if (bus == nullptr || !bus->isOpen())
        return tr("It is not connected. Connect it first.");
    if (!bus->isSimulated())
        return tr("It is real: only what is simulated can start afresh.");
    const auto places = bus->places();
    const auto busy = std::ranges::find_if(places, [bus](Place place) {
        const EncoderSession *encoder = bus->encoder(place);
        return encoder != nullptr && encoder->runningJob();
    });
    return busy == places.end() ? QString()
                                : refusalText({RefusalKind::busy, RefusalId::jobRunning, {busy->shown()}});
}

QString Afresh::tip(const QString &whyNot)
{
    return whyNot.isEmpty()
               ? tr("Everything simulated is as at the start: no faults, factory values, shafts where they "
                    "were. What was known of the encoders is forgotten")
               : whyNot;
}

} // namespace codewheel
