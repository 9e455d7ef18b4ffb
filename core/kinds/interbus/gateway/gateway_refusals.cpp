// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_refusals.h"

#include "kinds/interbus/gateway/register_texts.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

struct GatewayRefusalRows
{
    Q_DECLARE_TR_FUNCTIONS(Refusal)
    using enum GatewayRefusalId;

public:
    static constexpr auto all = std::to_array<SentenceRow>({
        {linkSettingWrong, "linkSettingWrong",
         QT_TR_NOOP("The setting %1 of the link cannot be \"%2\". Allowed: %3.")},
        {linkSettingUnknown, "linkSettingUnknown",
         QT_TR_NOOP("The link has no setting \"%1\". Its settings are: %2.")},
        {registerMapWrong, "registerMapWrong", QT_TR_NOOP("%1 Change the registers of the link.")},
        {gatewayHasNoDevices, "gatewayHasNoDevices",
         QT_TR_NOOP("The project has no devices on this ring, and a gateway cannot say which "
                    "there are. Enter them in the bus structure first.")},
        {watchdogNotSet, "watchdogNotSet",
         QT_TR_NOOP("No register is set that acknowledges the watchdog of this gateway. Enter "
                    "it and its value, by the manual of the gateway, in the connection.")},
        {outNotReadBack, "outNotReadBack",
         QT_TR_NOOP(
             "The OUT words cannot be read back: what is there now is not known. Operate replaces it.")},
        {noIdCycle, "noIdCycle",
         QT_TR_NOOP(
             "A gateway cannot say which devices are in the ring: the project does. Enter them there.")},
        {outNotOurs, "outNotOurs",
         QT_TR_NOOP("Somebody else writes to %1: OUT is %3 there instead of %2. The bus is in "
                    "Watch now. Stop the other program or PLC first.")},
        {wordNotSteady, "wordNotSteady",
         QT_TR_NOOP("No two reads of IN of %1 agree, so it is not known what it shows. Check the word "
                    "order, and where its registers begin. If they are right, its shaft is too fast for "
                    "this gateway: stop it, or make the poll interval shorter.")},
        {ringStands, "ringStands",
         QT_TR_NOOP("The gateway says that its ring does not run (status register %1): what it "
                    "shows is old. Start the ring at its master.")},
        {ringFailed, "ringFailed",
         QT_TR_NOOP("The gateway says that its ring has failed (status register %1): what it "
                    "shows is old. Look at the display of its master.")},
        {ringFailedAt, "ringFailedAt",
         QT_TR_NOOP("The gateway says that its ring has failed (status register %1): what it shows is "
                    "old. The place it names is %2: check plugs, shields and 24 V there.")},
        {realRingNotOffered, "realRingNotOffered",
         QT_TR_NOOP("A real ring is never offered to others, only a training bus.")},
        {closedRingNotOffered, "closedRingNotOffered",
         QT_TR_NOOP(
             "The ring of this window is not connected. Connect it, or give each seat a ring of its own.")},
        {closedUnanswered, "closedUnanswered",
         QT_TR_NOOP("%1 closes the connection without an answer. It may serve only a few clients at once.")},
        {registersUnanswered, "registersUnanswered",
         QT_TR_NOOP(
             "%1 does not answer (%2, tries: %3). Check unit number, settings of the line, and supply.")},
        {registersLate, "registersLate",
         QT_TR_NOOP("%1 answers too late (%2, tries: %3): what comes is for earlier requests. Set a longer "
                    "time-out.")},
        {registersRefused, "registersRefused", QT_TR_NOOP("%1 refuses %2 with exception %3: %4")},
        {registersGarbled, "registersGarbled", QT_TR_NOOP("The answer of %1 to %2 is wrong: %3")},
        {outAreaTooShort, "outAreaTooShort",
         QT_TR_NOOP("%1 does not have all OUT registers of the ring as planned (%2), though it has the "
                    "first. Compare "
                    "the bus structure with the ring, and the first register of OUT with the manual of the "
                    "gateway.")},
        {outputsBlocked, "outputsBlocked",
         QT_TR_NOOP("%1 does not carry out %2 (exception 4). The watchdog of its outputs may "
                    "have tripped: acknowledge it, then go to Operate again.")},
        {outsOfOther, "outsOfOther",
         QT_TR_NOOP("Somebody else writes to the outputs of this bus: it is in Watch now.")},
    });
};

static_assert(areInOrder(GatewayRefusalRows::all, &SentenceRow::id, GatewayRefusalId::outsOfOther));

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

constinit const RefusalFamily gatewayRefusals{GatewayRefusalRows::all, gatewayRefusalText};

} // namespace codewheel
