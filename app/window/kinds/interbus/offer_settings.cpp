// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/offer_settings.h"

#include <QSettings>

#include <algorithm>

namespace codewheel {
namespace {

const QString offerAddressKey = QStringLiteral("offer/address");
const QString offerPortKey = QStringLiteral("offer/port");
const QString offerHasSeatsKey = QStringLiteral("offer/hasSeats");
const QString offerSeatsKey = QStringLiteral("offer/seats");
const QString offerReadOnlyKey = QStringLiteral("offer/readOnly");

int number(const QSettings &settings, const QString &key, int usual, int least, int most)
{
    return std::clamp(settings.value(key, usual).toInt(), least, most);
}

} // namespace

OfferWish lastOffer(const QSettings &settings)
{
    const OfferWish usual;
    return {.address = settings.value(offerAddressKey, usual.address).toString(),
            .port = number(settings, offerPortKey, usual.port, 0, OfferWish::lastPort),
            .hasSeats = settings.value(offerHasSeatsKey, usual.hasSeats).toBool(),
            .seats = number(settings, offerSeatsKey, usual.seats, 1, OfferWish::mostSeats),
            .readOnly = settings.value(offerReadOnlyKey, usual.readOnly).toBool()};
}

void keepOffer(QSettings &settings, const OfferWish &wish)
{
    settings.setValue(offerAddressKey, wish.address);
    settings.setValue(offerPortKey, wish.port);
    settings.setValue(offerHasSeatsKey, wish.hasSeats);
    settings.setValue(offerSeatsKey, wish.seats);
    settings.setValue(offerReadOnlyKey, wish.readOnly);
}

} // namespace codewheel
