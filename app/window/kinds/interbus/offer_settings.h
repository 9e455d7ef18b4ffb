// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/kinds/interbus/offer/offer_wish.h"

class QSettings;

namespace codewheel {

// How a ring was offered last.
OfferWish lastOffer(const QSettings &settings);
void keepOffer(QSettings &settings, const OfferWish &wish);

} // namespace codewheel
