// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_refusals.h"

#include "kinds/interbus/words/k3_cam_effect.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto wordRefusalRows = std::to_array<SentenceRow>({
    {WordRefusalId::readOutUnknown, "readOutUnknown",
     QT_TRANSLATE_NOOP("Refusal", "The encoder does not know the read-out code %1 (IN %2). Check which "
                                  "encoder it is, and whether it has what you want to read.")},
    {WordRefusalId::unknownState, "unknownState",
     QT_TRANSLATE_NOOP("Refusal", "The encoder shows a state that no manual describes (IN %1). Send run, or "
                                  "switch the encoder off and on.")},
    {WordRefusalId::restarted, "restarted",
     QT_TRANSLATE_NOOP(
         "Refusal", "The encoder left parameterization before run was sent or answered, as after a loss of "
                    "power (IN %1). It may have kept its old values: check its supply and write again.")},
    {WordRefusalId::camWordRefused, "camWordRefused",
     QT_TRANSLATE_NOOP("Refusal",
                       "The encoder refused the word %1, which %2 in cam mode (IN %3). It kept the old "
                       "value: compare the cam program with the encoder, and check which encoder it is.")},
    {WordRefusalId::camsInParameterization, "camsInParameterization",
     QT_TRANSLATE_NOOP("Refusal",
                       "The encoder took no cam word (OUT %1, IN %2): it was in a parameterization that was "
                       "begun before. Run was not sent, since it makes valid what was confirmed there. End "
                       "that parameterization first, then try again.")},
    {WordRefusalId::camPositionAboveRange, "camPositionAboveRange",
     QT_TRANSLATE_NOOP("Refusal", "Error 98000004: a start or stop of cam %1 is above the largest position "
                                  "(IN %2). Give a position within the total range.")},
    {WordRefusalId::lostInCamMode, "lostInCamMode",
     QT_TRANSLATE_NOOP("Refusal", "Error 3: the encoder has lost its parameters (IN %1). In cam mode it "
                                  "takes none: switch it to position mode, write parameters 1 to 4 there or "
                                  "reset it to factory settings, and compare the cam programs.")},
    {WordRefusalId::camVerificationFailed, "camVerificationFailed",
     QT_TRANSLATE_NOOP("Refusal", "Cam program %1 was written but read back differently. Compare it before "
                                  "you rely on it, and write again.")},
    {WordRefusalId::serviceRefused, "serviceRefused",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "The encoder refused service %1 (IN %2). Nothing was changed: check the value and write it again.")},
    {WordRefusalId::wordsTorn, "wordsTorn",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "The encoder seems to answer differently each time (IN %1): the gateway puts halves of different "
         "words together. Set a longer copy time in the settings of the gateway, then read again.")},
});

static_assert(areInOrder(wordRefusalRows, &SentenceRow::id, WordRefusalId::wordsTorn));

QString camPositionText(const Refusal &refusal)
{
    const bool isKnown = refusal.arguments.size() > 1;
    return sentence(
        refusalPattern(isKnown
                           ? refusal.id.row().text
                           : QT_TRANSLATE_NOOP("Refusal", "Error 98000004: a start or stop of a cam is above "
                                                          "the largest position (IN %1). Compare the cam "
                                                          "programs with the total range.")),
        argumentTexts(refusal.arguments));
}

QString wordRefusalText(const Refusal &refusal)
{
    switch (*refusal.id.as<WordRefusalId>()) {
    case WordRefusalId::camWordRefused:
        return rowText(refusal, k3::camWordTexts(refusal.arguments));
    case WordRefusalId::camPositionAboveRange:
        return camPositionText(refusal);
    default:
        return rowText(refusal);
    }
}

} // namespace

constinit const RefusalFamily wordRefusals{wordRefusalRows, wordRefusalText};

} // namespace codewheel
