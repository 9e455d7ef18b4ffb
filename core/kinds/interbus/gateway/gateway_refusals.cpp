// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_refusals.h"

#include "kinds/interbus/gateway/register_texts.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto gatewayRefusalRows = std::to_array<SentenceRow>({
    {GatewayRefusalId::linkSettingWrong, "linkSettingWrong",
     QT_TRANSLATE_NOOP("Refusal", "The setting %1 of the link cannot be \"%2\". Allowed: %3.")},
    {GatewayRefusalId::linkSettingUnknown, "linkSettingUnknown",
     QT_TRANSLATE_NOOP("Refusal", "The link has no setting \"%1\". Its settings are: %2.")},
    {GatewayRefusalId::registerMapWrong, "registerMapWrong",
     QT_TRANSLATE_NOOP("Refusal", "%1 Change the registers of the link.")},
    {GatewayRefusalId::gatewayHasNoDevices, "gatewayHasNoDevices",
     QT_TRANSLATE_NOOP("Refusal", "The project has no devices on this ring, and a gateway cannot say which "
                                  "there are. Enter them in the bus structure first.")},
    {GatewayRefusalId::watchdogNotSet, "watchdogNotSet",
     QT_TRANSLATE_NOOP("Refusal", "No register is set that acknowledges the watchdog of this gateway. Enter "
                                  "it and its value, by the manual of the gateway, in the connection.")},
    {GatewayRefusalId::outNotReadBack, "outNotReadBack",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "The OUT words cannot be read back: what is there now is not known. Operate replaces it.")},
    {GatewayRefusalId::noIdCycle, "noIdCycle",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "A gateway cannot say which devices are in the ring: the project does. Enter them there.")},
    {GatewayRefusalId::outNotOurs, "outNotOurs",
     QT_TRANSLATE_NOOP("Refusal", "Somebody else writes to %1: OUT is %3 there instead of %2. The bus is in "
                                  "Watch now. Stop the other program or PLC first.")},
    {GatewayRefusalId::wordNotSteady, "wordNotSteady",
     QT_TRANSLATE_NOOP("Refusal",
                       "No two reads of IN of %1 agree, so it is not known what it shows. Check the word "
                       "order, and where its registers begin. If they are right, its shaft is too fast for "
                       "this gateway: stop it, or make the poll interval shorter.")},
    {GatewayRefusalId::ringStands, "ringStands",
     QT_TRANSLATE_NOOP("Refusal", "The gateway says that its ring does not run (status register %1): what it "
                                  "shows is old. Start the ring at its master.")},
    {GatewayRefusalId::ringFailed, "ringFailed",
     QT_TRANSLATE_NOOP("Refusal", "The gateway says that its ring has failed (status register %1): what it "
                                  "shows is old. Look at the display of its master.")},
    {GatewayRefusalId::ringFailedAt, "ringFailedAt",
     QT_TRANSLATE_NOOP("Refusal",
                       "The gateway says that its ring has failed (status register %1): what it shows is "
                       "old. The place it names is %2: check plugs, shields and 24 V there.")},
    {GatewayRefusalId::realRingNotOffered, "realRingNotOffered",
     QT_TRANSLATE_NOOP("Refusal", "A real ring is never offered to others, only a training bus.")},
    {GatewayRefusalId::closedRingNotOffered, "closedRingNotOffered",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "The ring of this window is not connected. Connect it, or give each seat a ring of its own.")},
    {GatewayRefusalId::closedUnanswered, "closedUnanswered",
     QT_TRANSLATE_NOOP(
         "Refusal", "%1 closes the connection without an answer. It may serve only a few clients at once.")},
    {GatewayRefusalId::registersUnanswered, "registersUnanswered",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "%1 does not answer (%2, tries: %3). Check unit number, settings of the line, and supply.")},
    {GatewayRefusalId::registersLate, "registersLate",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "%1 answers too late (%2, tries: %3): what comes is for earlier requests. Set a longer time-out.")},
    {GatewayRefusalId::registersRefused, "registersRefused",
     QT_TRANSLATE_NOOP("Refusal", "%1 refuses %2 with exception %3: %4")},
    {GatewayRefusalId::registersGarbled, "registersGarbled",
     QT_TRANSLATE_NOOP("Refusal", "The answer of %1 to %2 is wrong: %3")},
    {GatewayRefusalId::outAreaTooShort, "outAreaTooShort",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "%1 does not have all OUT registers of the ring as planned (%2), though it has the first. Compare "
         "the bus structure with the ring, and the first register of OUT with the manual of the gateway.")},
    {GatewayRefusalId::outputsBlocked, "outputsBlocked",
     QT_TRANSLATE_NOOP("Refusal", "%1 does not carry out %2 (exception 4). The watchdog of its outputs may "
                                  "have tripped: acknowledge it, then go to Operate again.")},
    {GatewayRefusalId::outsOfOther, "outsOfOther",
     QT_TRANSLATE_NOOP("Refusal", "Somebody else writes to the outputs of this bus: it is in Watch now.")},
});

static_assert(areInOrder(gatewayRefusalRows, &SentenceRow::id, GatewayRefusalId::outsOfOther));

QString gatewayRefusalText(const Refusal &refusal)
{
    switch (*refusal.id.as<GatewayRefusalId>()) {
    case GatewayRefusalId::registersUnanswered:
    case GatewayRefusalId::registersLate:
    case GatewayRefusalId::registersRefused:
    case GatewayRefusalId::registersGarbled:
    case GatewayRefusalId::outAreaTooShort:
    case GatewayRefusalId::outputsBlocked:
        return rowText(refusal, registerRefusalTexts(refusal));
    default:
        return rowText(refusal);
    }
}

} // namespace

constinit const RefusalFamily gatewayRefusals{gatewayRefusalRows, gatewayRefusalText};

} // namespace codewheel
