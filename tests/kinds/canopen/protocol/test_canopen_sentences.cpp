// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_messages.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/kept_identifier.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

std::string refusedWith(Word code)
{
    return refusalText({RefusalKind::device, CanopenRefusalId::sdoAborted, {QStringLiteral("6001h:0"), code}})
        .toStdString();
}

TEST(CanopenSentences, AnAbortCodeHasItsReason)
{
    EXPECT_EQ(refusedWith(0x06090030),
              "The encoder refused 6001h:0 (abort code 06090030h): The value is out of range.");
    EXPECT_EQ(refusedWith(0x12345678), "The encoder refused 6001h:0 (abort code 12345678h): CiA 301 has no "
                                       "reason with this number.");
}

TEST(CanopenSentences, AnEmergencySaysWhatItIsAbout)
{
    const Message message{.id = CanopenMessageId::emergency, .arguments = {Word{0x8130}, Word{0x11}}};
    EXPECT_EQ(messageText(message).toStdString(),
              "The encoder reports an error: 8130h, guarding or heartbeat, error, communication.");
}

TEST(CanopenSentences, AnIdentifierIsToldWithThatWhichIsPredefined)
{
    const auto kept = canopen::keptIdentifier({0x1014, 0}, 0x88, 9);
    ASSERT_TRUE(kept);
    EXPECT_EQ(
        messageText(kept->message()).toStdString(),
        "1014h:0 (EMCY) has the identifier 088h, and 089h is predefined for the number of this node: it "
        "may be that of the number it had before. Write 089h to it, store, and reset the node; if it "
        "cannot be written, restore the factory values.");
}

} // namespace
} // namespace codewheel
