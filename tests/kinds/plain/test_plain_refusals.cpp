// SPDX-License-Identifier: GPL-3.0-or-later
// A refusal that only this kind has.
#include "journal/stored_message.h"
#include "tests/kinds/plain/plain_calls.h"
#include "tests/kinds/plain/plain_refusals.h"
#include "vocabulary/refusal_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::plainFilter;
using testing::HasSubstr;

const char *const noFilter = "The node does not have the key of Filter. Check which node it is.";

class PlainRefusalCalls : public test::PlainCalls
{
protected:
    PlainRefusalCalls() { bus.node(test::plainHoist).lose("2000:1"); }
};

TEST_F(PlainRefusalCalls, IsToldWithItsOwnSentenceAndKey)
{
    const CliRun told = run(QStringLiteral("read n:1 2000:1"));
    EXPECT_EQ(told.exit, 1);
    EXPECT_THAT(told.out + told.err, HasSubstr(noFilter));
    EXPECT_EQ(errorKey(run(QStringLiteral("read n:1 2000:1 --json"))), "plainNoSuchKey");
}

TEST(PlainRefusal, IsKeptInTheJournalAndReadBack)
{
    const Message message{.severity = Severity::attention,
                          .refusal =
                              Refusal{RefusalKind::device, test::PlainRefusalId::noSuchKey, {plainFilter()}}};
    const StoredMessage stored = storedMessage(message, QDateTime(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC));
    EXPECT_EQ(codeOf(stored), QStringLiteral("plainNoSuchKey"));
    EXPECT_EQ(messageOf(stored), message);
    EXPECT_EQ(messageText(stored), messageText(message));
}

TEST(PlainRefusal, IsNoneOfAnotherFamily)
{
    const RefusalCode code = test::PlainRefusalId::noSuchKey;
    EXPECT_EQ(code, test::PlainRefusalId::noSuchKey);
    EXPECT_EQ(code.as<test::PlainRefusalId>(), test::PlainRefusalId::noSuchKey);
    EXPECT_FALSE(code.as<RefusalId>());
    EXPECT_NE(code, static_cast<RefusalId>(0)); // of the same number
}

} // namespace
} // namespace codewheel
