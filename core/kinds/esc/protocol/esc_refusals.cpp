// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_refusals.h"

#include "vocabulary/enumeration_rows.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto escRefusalRows = std::to_array<SentenceRow>({
    {EscRefusalId::lineAddressWrong, "lineAddressWrong",
     QT_TRANSLATE_NOOP("Refusal",
                       "\"%1\" is not an address of an encoder on a serial line. Addresses go from 01 to 1F "
                       "(1 to 31); 00 is for an encoder that is alone on its line.")},
    {EscRefusalId::lineAddressNotAlone, "lineAddressNotAlone",
     QT_TRANSLATE_NOOP("Refusal",
                       "Every encoder answers to address %1: it is for an encoder that is alone on its line, "
                       "and there is %2 too. Use the address of the encoder itself.")},
    {EscRefusalId::commandUnknown, "escCommandUnknown",
     QT_TRANSLATE_NOOP("Refusal", "The encoder does not know the command %1 (answer 03). Nothing was "
                                  "changed; its version may be older than the manual.")},
    {EscRefusalId::outOfRange, "escOutOfRange",
     QT_TRANSLATE_NOOP("Refusal", "The encoder refused %1 as incomplete or out of range (answer 05). It kept "
                                  "the old value: give another one.")},
    {EscRefusalId::notSentInTime, "escNotSentInTime",
     QT_TRANSLATE_NOOP("Refusal", "No answer came from the encoder for %1 s after this was confirmed, so "
                                  "nothing was written. Check the line, then start again.")},
    {EscRefusalId::readsDisagree, "escReadsDisagree",
     QT_TRANSLATE_NOOP("Refusal", "%1 was read as %2 and then as %3, so neither is taken. Check the line for "
                                  "disturbances, then read again.")},
    {EscRefusalId::writeUnknown, "escWriteUnknown",
     QT_TRANSLATE_NOOP("Refusal", "%1 was sent and not answered, and it could not be found out afterwards "
                                  "whether it was carried out: it is not known whether the encoder has the "
                                  "new value. Check the line, and read the encoder before you go on.")},
    {EscRefusalId::writeNotDone, "escWriteNotDone",
     QT_TRANSLATE_NOOP("Refusal", "%1 was sent and not answered, and the encoder still has the old value. "
                                  "Check the line, then write again.")},
    {EscRefusalId::presetUnproven, "escPresetUnproven",
     QT_TRANSLATE_NOOP("Refusal", "%1 was accepted, but neither the preset value nor the position shows that "
                                  "the position was set to %2: it is not known whether it was. Check the "
                                  "line, and read position and preset before you go on.")},
    {EscRefusalId::notFoundAgain, "escNotFoundAgain",
     QT_TRANSLATE_NOOP(
         "Refusal", "The encoder does not answer any more at %1. Search the line for it at all baud rates.")},
    {EscRefusalId::factorFitsNothing, "escFactorFitsNothing",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "The scaling factor %1 fits %2 steps per turn and a measuring range of %3 in no format, or in more "
         "than one. Leave the number of fraction bits unchanged, or write the scaling again.")},
});

static_assert(areInOrder(escRefusalRows, &SentenceRow::id, EscRefusalId::factorFitsNothing));

} // namespace

constinit const RefusalFamily escRefusals{escRefusalRows};

} // namespace codewheel
