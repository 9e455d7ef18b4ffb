// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that the command line does not know, explained by the kind they belong to.
#include "cli/call/command_line.h"
#include "tests/cli/cli_run.h"
#include "tests/kinds/plain/plain_link_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

CliRun explainPlain(const QString &line, const QStringList &options = {})
{
    const auto kind = addLinkKind(std::make_unique<test::PlainLinkKind>());
    return runWith({}, [&](const Terminal &terminal) {
        return runCommandLine(QStringList{QStringLiteral("explain"), line, QStringLiteral("--device"),
                                          QStringLiteral("plain-node")} +
                                  options,
                              terminal);
    });
}

TEST(PlainExplain, TellsALineAsItsKindDoes)
{
    EXPECT_EQ(explainPlain(QStringLiteral("set 2000:1=-5 1008=Gate%201")).out,
              "set 2000:1=-5 1008=Gate%201, Plain P1\n  Filter := -5, Device name := Gate 1\n");
    EXPECT_THAT(explainPlain(QStringLiteral("2000:1=-5")).out, HasSubstr("Filter = -5\n"));
    EXPECT_THAT(explainPlain(QStringLiteral("keep")).out, HasSubstr("what is in force is stored\n"));
}

TEST(PlainExplain, TellsProgramsTheSame)
{
    const CliRun run = explainPlain(QStringLiteral("set 2000:1=-5"), {QStringLiteral("--json")});
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonObject json = run.json();
    EXPECT_EQ(json[u"command"], QStringLiteral("explain"));
    EXPECT_EQ(json[u"line"], QStringLiteral("set 2000:1=-5"));
    EXPECT_EQ(json[u"device"], QStringLiteral("plain-node"));
    EXPECT_EQ(json[u"meaning"], QStringLiteral("Filter := -5"));
}

TEST(PlainExplain, WhatIsNoLineIsRefused)
{
    EXPECT_EQ(errorKey(explainPlain(QStringLiteral("set 3000=1"), {QStringLiteral("--json")})), "notALine");
    EXPECT_EQ(explainPlain(QStringLiteral("020000FF")).exit, 2) << "it has no words";
}

} // namespace
} // namespace codewheel
