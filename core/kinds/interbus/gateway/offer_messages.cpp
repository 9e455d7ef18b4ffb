// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/offer_messages.h"

#include "vocabulary/enumeration_rows.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto offerMessageRows = std::to_array<SentenceRow>({
    {OfferMessageId::offerBegun, "offerBegun",
     QT_TRANSLATE_NOOP("Message", "Offered to others at %1 by Modbus.")},
    {OfferMessageId::offerEnded, "offerEnded",
     QT_TRANSLATE_NOOP("Message", "No longer offered to others at %1.")},
    {OfferMessageId::offerEndedWithRing, "offerEndedWithRing",
     QT_TRANSLATE_NOOP("Message", "The ring was disconnected, so it is no longer offered at %1.")},
    {OfferMessageId::offerEndedWithStructure, "offerEndedWithStructure",
     QT_TRANSLATE_NOOP("Message", "The ring has other devices now, in other registers, so it is no longer "
                                  "offered at %1. Offer it again.")},
    {OfferMessageId::offerEndedWithProject, "offerEndedWithProject",
     QT_TRANSLATE_NOOP("Message",
                       "Another project was opened, so nothing is offered at %1 any more. Offer it again.")},
    {OfferMessageId::offerEndedWithRealRing, "offerEndedWithRealRing",
     QT_TRANSLATE_NOOP("Message", "This ring is a real one now, so nothing is offered at %1 any more.")},
    {OfferMessageId::clientCame, "clientCame",
     QT_TRANSLATE_NOOP("Message", "%1 is connected to the offered ring.")},
    {OfferMessageId::clientLeft, "clientLeft",
     QT_TRANSLATE_NOOP("Message", "%1 has left the offered ring (requests: %2, of them writes: %3).")},
    {OfferMessageId::clientRefused, "clientRefused",
     QT_TRANSLATE_NOOP("Message",
                       "%1 was disconnected: the offered ring has as many clients as it can have.")},
    {OfferMessageId::clientsPassed, "clientsPassed",
     QT_TRANSLATE_NOOP(
         "Message", "More clients of the offered ring in a short time: %1 came, %2 left, %3 were refused.")},
    {OfferMessageId::seatRestarted, "seatRestarted",
     QT_TRANSLATE_NOOP("Message", "The ring of seat %1 starts afresh, with factory settings.")},
});

static_assert(areInOrder(offerMessageRows, &SentenceRow::id, OfferMessageId::seatRestarted));

} // namespace

constinit const MessageFamily offerMessages{offerMessageRows};

} // namespace codewheel
