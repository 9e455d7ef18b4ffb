// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_refusals.h"

#include "kinds/canopen/protocol/device_profile.h"
#include "kinds/canopen/protocol/sdo_abort.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto canopenRefusalRows = std::to_array<SentenceRow>({
    {CanopenRefusalId::sdoAborted, "sdoAborted",
     QT_TRANSLATE_NOOP("Refusal", "The encoder refused %1 (abort code %2h): %3")},
    {CanopenRefusalId::sdoNoAnswer, "sdoNoAnswer",
     QT_TRANSLATE_NOOP("Refusal",
                       "Node %2 does not answer for %1. Check its supply, its number and the rate of the "
                       "bus; a node that was stopped answers nothing until it is started.")},
    {CanopenRefusalId::sdoNotSent, "sdoNotSent",
     QT_TRANSLATE_NOOP("Refusal", "The request for %1 of node %2 could not be sent, so nothing was changed. "
                                  "Check the CAN bus, then start again.")},
    {CanopenRefusalId::sdoWriteUnknown, "sdoWriteUnknown",
     QT_TRANSLATE_NOOP(
         "Refusal", "%1 was written and not answered, and it could not be found out afterwards whether the "
                    "encoder has the new value. Check the bus, and read the encoder before you go on.")},
    {CanopenRefusalId::sdoWriteNotDone, "sdoWriteNotDone",
     QT_TRANSLATE_NOOP("Refusal", "%1 was written and not answered, and the encoder still has the old value. "
                                  "Check the bus, then write again.")},
    {CanopenRefusalId::storingUnknown, "storingUnknown",
     QT_TRANSLATE_NOOP(
         "Refusal", "Node %1 did not answer the command that stores its values: whether they are stored is "
                    "not known. Store them again, or read them after switching its supply off and on.")},
    {CanopenRefusalId::nodeWouldStop, "nodeWouldStop",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "Node %1 is running, and takes this only while it is stopped: its positions would not come until it "
         "is started again. Agree that it is stopped and started again, or stop it first.")},
    {CanopenRefusalId::notBackAfterReset, "notBackAfterReset",
     QT_TRANSLATE_NOOP("Refusal", "Node %1 did not report within %2 s after its reset. It may have another "
                                  "number or another rate now: search the bus for it.")},
    {CanopenRefusalId::nodeRestarted, "nodeRestarted",
     QT_TRANSLATE_NOOP("Refusal", "Node %1 has started anew during the job: what was written and not stored "
                                  "is lost. Read it, then write it again.")},
    {CanopenRefusalId::presetNotInForce, "presetNotInForce",
     QT_TRANSLATE_NOOP("Refusal", "The encoder has accepted the preset, and still shows %2 instead of %1. "
                                  "Read it again before anything relies on it.")},
    {CanopenRefusalId::nodeDoubled, "canopenNodeNumberDoubled",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "Two devices have the node number %1: of which one an answer is, and which has taken what was sent, "
         "is not known. Give one of them another number, with only one of them on the bus.")},
    {CanopenRefusalId::notStartedAgain, "notStartedAgain",
     QT_TRANSLATE_NOOP("Refusal",
                       "Node %1 was stopped for what it takes only then, and does not run again, though it "
                       "was started. Start it once more before anything relies on its positions.")},
    {CanopenRefusalId::startNotSeen, "startNotSeen",
     QT_TRANSLATE_NOOP(
         "Refusal", "Node %1 was stopped for what it takes only then, and started again: whether it runs is "
                    "not known, as it shows neither its state nor PDOs. Check that its positions come.")},
    {CanopenRefusalId::makeDiffers, "makeDiffers",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "%1 is an object of the maker, and the encoder is of another make (vendor number %3h) than its "
         "description (%2h). Nothing was written: choose the description that belongs to it.")},
    {CanopenRefusalId::otherProfile, "canopenOtherProfile",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "Node %1 tells the device profile %2, not that of encoders (406; object 1000h): what is wanted "
         "means "
         "something else there. Nothing was written. Its objects can still be read and written one by one, "
         "by its own manual.")},
    {CanopenRefusalId::nodeMayRun, "nodeMayRun",
     QT_TRANSLATE_NOOP("Refusal", "Node %1 does not tell whether it is running, and this stops it: if it "
                                  "runs, its positions would not "
                                  "come until it is started again. Agree that it is stopped and started "
                                  "afterwards, or stop it first.")},
});

static_assert(areInOrder(canopenRefusalRows, &SentenceRow::id, CanopenRefusalId::nodeMayRun));

constexpr const char *otherReason = QT_TRANSLATE_NOOP("Refusal", "CiA 301 has no reason with this number.");

// What the abort code means is said in the present language.
QString canopenRefusalText(const Refusal &refusal)
{
    QStringList parts = argumentTexts(refusal.arguments);
    if (refusal.id == CanopenRefusalId::sdoAborted && parts.size() == 2) {
        const auto *code = std::get_if<Word>(&refusal.arguments[1]);
        const QString why = code != nullptr ? canopen::sdoAbortText(*code) : QString();
        parts << (why.isEmpty() ? refusalPattern(otherReason) : why);
    }
    if (refusal.id == CanopenRefusalId::otherProfile && parts.size() == 2)
        if (const auto *profile = std::get_if<std::int64_t>(&refusal.arguments[1]))
            parts[1] = canopen::profileText(*profile);
    return rowText(refusal, parts);
}

} // namespace

constinit const RefusalFamily canopenRefusals{canopenRefusalRows, canopenRefusalText};

} // namespace codewheel
