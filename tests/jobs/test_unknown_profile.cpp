// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/explain_word.h"
#include "catalog/protocol_rules.h"
#include "catalog/word_form.h"
#include "jobs/protocol.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// A profile that no kind has is not taken for that of another.
class UnknownProfile : public testing::Test
{
protected:
    UnknownProfile() { device.profile = Profile("X9"); }

    DeviceDescription device;
};

TEST_F(UnknownProfile, EveryJobIsRefused)
{
    const auto steps = plannedSteps(device, SendWords{.words = {0x4000'0000}});
    ASSERT_FALSE(steps);
    EXPECT_EQ(steps.error().id, RefusalId::jobNotSupported);
}

TEST_F(UnknownProfile, NoWordHasAMeaning)
{
    EXPECT_EQ(explainWord(device, 0x4000'0000, {.direction = WordDirection::out}).first().id,
              MeaningId::undefinedOut);
    EXPECT_EQ(explainWord(device, 0xC200'00FF, {}).first().id, MeaningId::undefinedIn);
    EXPECT_EQ(bitText(device, WordDirection::out, 31), QString());
    EXPECT_EQ(wordForm(32, &device), WordForm());
}

TEST_F(UnknownProfile, NothingIsAssumedOfIt)
{
    EXPECT_FALSE(activatesByRun(device));
    EXPECT_FALSE(isRod(device));
    EXPECT_FALSE(device.mayHaveModes());
    EXPECT_FALSE(protocolRules(device.profile).hasWords());
}

} // namespace
} // namespace codewheel
