// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of a device that was given its number only half: each sentence is true.
#include "widgets/kinds/canopen/setup/node_setup_texts.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using canopen::LssOutcome;
using canopen::LssRequest;
using canopen::NodeIdentity;
using canopen::NodeSetup;
using canopen::NodeSetupWish;
using canopen::SdoOutcome;
using Kind = LssRequest::Kind;

constexpr NodeIdentity setUpIdentity{{0x10D, 0x25, 0x10001, 4711}};

// The answers of a device that does everything, but for those to one kind of request.
class HalfSetup
{
public:
    HalfSetup(std::optional<int> before, Kind differs, LssOutcome::Kind outcome)
        : m_setup({.identity = setUpIdentity, .nodeBefore = before, .node = 9})
        , m_differs(differs)
        , m_outcome(outcome)
    {}

    QString end(bool isLinkLost = false)
    {
        while (const auto request = m_setup.next(CanopenSnapshot()))
            if (const auto *lss = std::get_if<LssRequest>(&*request))
                m_setup.answered(answer(*lss, isLinkLost));
            else if (std::holds_alternative<canopen::SdoRequest>(*request))
                m_setup.answered(SdoOutcome{.kind = SdoOutcome::Kind::noAnswer}); // the number is free
            else
                m_setup.sent(CanFate::done);
        EXPECT_TRUE(m_setup.isEnded());
        return node_setup_text::end(m_setup);
    }

private:
    LssOutcome answer(const LssRequest &request, bool isLinkLost)
    {
        LssOutcome outcome{
            .kind = LssOutcome::Kind::done, .identity = setUpIdentity, .node = m_setup.wish().nodeBefore};
        if (m_isLost) {
            outcome.kind = LssOutcome::Kind::notSent;
        } else if (request.kind == m_differs) {
            outcome.kind = m_outcome;
            outcome.code = 1;
            m_isLost = isLinkLost;
        }
        return outcome;
    }

    NodeSetup m_setup;
    Kind m_differs;
    LssOutcome::Kind m_outcome;
    bool m_isLost = false;
};

TEST(NodeSetupTexts, WhereTheLinkWasLostBehindTheStoreBothNumbersAreNamed)
{
    const QString text = HalfSetup(6, Kind::store, LssOutcome::Kind::noAnswer).end(true);
    EXPECT_TRUE(text.contains(QStringLiteral("Whether it has stored is not known."))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("node 9 (09h) or still node 6 (06h)"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("may still be in the configuration"))) << text.toStdString();
    EXPECT_FALSE(text.contains(QStringLiteral("Nothing was changed")));
}

TEST(NodeSetupTexts, OfOneWithoutANumberItMayStillHaveNone)
{
    const QString text = HalfSetup(std::nullopt, Kind::store, LssOutcome::Kind::noAnswer).end(true);
    EXPECT_TRUE(text.contains(QStringLiteral("node 9 (09h) or still without a number")))
        << text.toStdString();
}

TEST(NodeSetupTexts, ANumberThatIsRefusedChangesNothing)
{
    const QString text = HalfSetup(6, Kind::setNode, LssOutcome::Kind::refused).end();
    EXPECT_TRUE(text.contains(QStringLiteral("refused it (code 1"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("Nothing was changed."))) << text.toStdString();
    EXPECT_FALSE(text.contains(QStringLiteral("configuration"))) << text.toStdString();
}

TEST(NodeSetupTexts, ANumberThatIsTakenAndNotStoredIsLostWithoutSupply)
{
    const QString text = HalfSetup(6, Kind::store, LssOutcome::Kind::refused).end();
    EXPECT_TRUE(text.contains(QStringLiteral("What it has taken is not stored."))) << text.toStdString();
    EXPECT_FALSE(text.contains(QStringLiteral("Nothing was changed"))) << text.toStdString();
}

TEST(NodeSetupTexts, ANumberWithoutAnAnswerIsInDoubtAndNotStored)
{
    const QString text = HalfSetup(6, Kind::setNode, LssOutcome::Kind::noAnswer).end();
    EXPECT_TRUE(text.contains(QStringLiteral("Whether it has taken it is not known; it was not stored.")))
        << text.toStdString();
}

TEST(NodeSetupTexts, WhoDoesNotTakePartIsNotCalledChanged)
{
    const QString text = HalfSetup(6, Kind::select, LssOutcome::Kind::noAnswer).end();
    EXPECT_TRUE(text.contains(QStringLiteral("does not take part in LSS"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("Nothing was changed."))) << text.toStdString();
}

// The node is there, has reported behind a reset, and then with the supply on again.
TEST(NodeSetupTexts, OnlyABootUpThatNobodyAskedForIsCalledProof)
{
    const auto told = [](int bootUps, int unasked) {
        canopen::NodeCheck check({.node = 9, .identity = setUpIdentity, .before = {.all = 2, .unasked = 1}});
        CanopenSnapshot bus;
        bus.nodes.push_back({.node = 9, .bootUps = bootUps, .unaskedBootUps = unasked});
        while (!check.isEnded()) {
            if (const auto request = check.next(bus)) {
                SdoOutcome outcome{.kind = SdoOutcome::Kind::read};
                const auto word = setUpIdentity.words.at(std::get<canopen::SdoRequest>(*request).object.sub -
                                                         std::size_t{1});
                for (unsigned shift = 0; shift < 32; shift += 8)
                    outcome.value.push_back(static_cast<std::uint8_t>(word >> shift));
                check.answered(outcome);
            }
            bus.at += std::chrono::milliseconds(100);
        }
        return node_setup_text::end(check, true);
    };
    EXPECT_TRUE(told(3, 2).startsWith(QStringLiteral("Proven"))) << told(3, 2).toStdString();
    EXPECT_TRUE(told(3, 1).contains(QStringLiteral("was reset, not switched off")))
        << told(3, 1).toStdString();
    EXPECT_TRUE(told(2, 1).contains(QStringLiteral("has not reported"))) << told(2, 1).toStdString();
}

TEST(NodeSetupTexts, WhatIsStoredAndNotResetIsInForceAfterItsSupplyWasOff)
{
    const QString text = HalfSetup(6, Kind::operateAll, LssOutcome::Kind::notSent).end();
    EXPECT_TRUE(text.contains(QStringLiteral("It says that it has stored"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("may still be in the configuration"))) << text.toStdString();
}

} // namespace
} // namespace codewheel
