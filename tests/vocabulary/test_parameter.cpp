// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/parameter.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

LocalText named(const QString &name)
{
    return {{{QStringLiteral("en"), name}}};
}

TEST(ParameterNames, WhatEverybodyKnowsIsTheSameByItsKey)
{
    EXPECT_EQ(Parameter::of(u"zero-offset"), Parameter::zeroOffset);
    EXPECT_EQ(Parameter::of(u"zero-offset", named(QStringLiteral("Nonsense"))), Parameter::zeroOffset);
    EXPECT_EQ(parameterName(Parameter::zeroOffset), QStringLiteral("Zero offset"));
}

TEST(ParameterNames, ADescriptionNamesItsOwn)
{
    EXPECT_FALSE(parameterFromKey(u"3001:1"));
    const Parameter own = Parameter::of(u"3001:1", named(QStringLiteral("Filter")));
    EXPECT_EQ(parameterFromKey(u"3001:1"), own);
    EXPECT_EQ(Parameter::of(u"3001:1"), own);
    EXPECT_NE(Parameter::of(u"3001:2"), own);
    EXPECT_EQ(parameterKey(own), QStringLiteral("3001:1"));
    EXPECT_EQ(parameterName(own), QStringLiteral("Filter"));
    EXPECT_EQ(parameterNameInText(own), QStringLiteral("Filter"));
}

// One maker's object is another maker's, with the same index: no name would be true of both.
TEST(ParameterNames, SeveralNamesForOneKeyAreNoName)
{
    const Parameter own = Parameter::of(u"3002", named(QStringLiteral("Filter")));
    Parameter::of(u"3002");
    EXPECT_EQ(parameterName(own), QStringLiteral("Filter"));
    Parameter::of(u"3002", named(QStringLiteral("Gain")));
    EXPECT_EQ(parameterName(own), QStringLiteral("3002"));
}

TEST(ParameterNames, AreInTheOrderOfTheListAndThenOfTheirNumbers)
{
    const Parameter tenth = Parameter::of(u"register-10");
    const Parameter ninth = Parameter::of(u"register-9");
    EXPECT_LT(Parameter::steps, Parameter::deviceCode);
    EXPECT_LT(Parameter::deviceCode, ninth);
    EXPECT_LT(ninth, tenth);
    EXPECT_LT(Parameter::of(u"register-01"), Parameter::of(u"register-1"));
    const std::vector<Parameter> all = allParameters();
    EXPECT_TRUE(std::ranges::is_sorted(all));
    EXPECT_EQ(all.front(), Parameter::steps);
    EXPECT_NE(std::ranges::find(all, tenth), all.end());
}

} // namespace
} // namespace codewheel
