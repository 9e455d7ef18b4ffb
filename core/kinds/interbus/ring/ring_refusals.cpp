// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_refusals.h"

#include "kinds/interbus/words/bus_fault.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto ringRefusalRows = std::to_array<SentenceRow>({
    {RingRefusalId::deviceCodeDiffers, "deviceCodeDiffers",
     QT_TRANSLATE_NOOP("Refusal", "%1 has the device code %2: it cannot be the %3, which has %4. Choose an "
                                  "encoder of the same device code.")},
    {RingRefusalId::faultPlanBroken, "faultPlanBroken",
     QT_TRANSLATE_NOOP("Refusal", "%1, line %2, %3: %4 The fault plan was not loaded."),
     QT_TRANSLATE_NOOP("Refusal", "%1, line %2: %4 The fault plan was not loaded.")},
    {RingRefusalId::masterServiceNotSupported, "masterServiceNotSupported",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "This link does not reach the master: %1 is not possible. It shows the process data only.")},
    {RingRefusalId::masterStateWrong, "masterStateWrong",
     QT_TRANSLATE_NOOP("Refusal", "%1 is not possible while the master is in the state %2.")},
    {RingRefusalId::noConfiguration, "noConfiguration",
     QT_TRANSLATE_NOOP("Refusal",
                       "The master has no stored configuration. Read in the ring, or download one.")},
    {RingRefusalId::busFault, "busFault", QT_TRANSLATE_NOOP("Refusal", "The bus does not run: %1.")},
    {RingRefusalId::notInRing, "notInRing",
     QT_TRANSLATE_NOOP("Refusal",
                       "%1 is not in the ring: its segment is switched off, or a fault lies before it.")},
});

static_assert(areInOrder(ringRefusalRows, &SentenceRow::id, RingRefusalId::notInRing));

QString ringRefusalText(const Refusal &refusal)
{
    switch (*refusal.id.as<RingRefusalId>()) {
    case RingRefusalId::busFault:
        return rowText(refusal, {busFaultText(refusal.arguments)});
    case RingRefusalId::faultPlanBroken:
        return brokenFileText(refusal);
    default:
        return rowText(refusal);
    }
}

} // namespace

constinit const RefusalFamily ringRefusals{ringRefusalRows, ringRefusalText};

} // namespace codewheel
