// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/process_data_link.h"

#include "vocabulary/hex.h"

#include <QStringList>

#include <algorithm>

namespace codewheel {

QString wordsNotZero(const ProcessDataLink &link, const RingStructure &ring, std::span<const Word> out)
{
    QStringList texts;
    const std::vector<QString> places = link.outPlaces();
    for (std::size_t i = 0; i < std::min(ring.size(), out.size()); ++i) {
        if (out[i] == 0)
            continue;
        const QString text = ring[i].number.toString() + u' ' + hexWord(out[i]);
        const bool hasPlace = i < places.size() && !places[i].isEmpty();
        texts << (hasPlace ? text + QStringLiteral(" (%1)").arg(places[i]) : text);
    }
    return texts.join(QStringLiteral(", "));
}

} // namespace codewheel
