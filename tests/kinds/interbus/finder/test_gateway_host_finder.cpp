// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/finder/gateway_host_finder.h"
#include "tests/support/register_bank.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Kind = FinderNews::Kind;

// One unit of a host; another does not answer.
class UnitPort final : public test::RegisterBankPort
{
public:
    UnitPort(std::shared_ptr<test::RegisterBank> bank, std::optional<RegisterError> error)
        : RegisterBankPort(std::move(bank))
        , m_error(std::move(error))
    {}
    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        if (m_error)
            return tl::unexpected(*m_error);
        return RegisterBankPort::read(area, first, to);
    }

private:
    const std::optional<RegisterError> m_error;
};

class GatewayHostFinderTest : public testing::Test
{
protected:
    std::vector<FinderNews> run()
    {
        GatewaySettings where;
        where.host = QStringLiteral("gateway");
        where.tcpPort = 1502;
        GatewayHostFinder finder(where, [this](const GatewaySettings &settings) {
            if (isInterrupted)
                interrupt();
            const bool isThere = settings.unit == unit || answersForAny;
            return std::make_unique<UnitPort>(
                bank, isThere ? std::nullopt : std::optional(RegisterError{otherwise, 11, {}}));
        });
        interrupt = [&finder] { finder.interrupt(); };
        std::vector<FinderNews> all;
        while (!finder.isDone() && all.size() < 100)
            all.push_back(finder.next());
        return all;
    }

    std::shared_ptr<test::RegisterBank> bank = std::make_shared<test::RegisterBank>();
    int unit = 2;
    bool answersForAny = false;
    RegisterError::Kind otherwise = RegisterError::Kind::noAnswer;
    std::function<void()> interrupt;
    bool isInterrupted = false; // while it connects
};

TEST_F(GatewayHostFinderTest, FindsTheUnitThatAnswers)
{
    const auto news = run();
    std::vector<Found> found;
    for (const FinderNews &one : news)
        if (one.found)
            found.push_back(*one.found);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].place, QStringLiteral("gateway:1502"));
    EXPECT_EQ(found[0].link, QStringLiteral("modbus-tcp:gateway:1502,unit=2"));
    EXPECT_TRUE(found[0].sentence.startsWith(u"The Modbus unit 2 answers."));
    EXPECT_EQ(bank->writes, 0);
}

TEST_F(GatewayHostFinderTest, AHostThatDoesNotLookAtTheUnitIsFoundOnce)
{
    answersForAny = true;
    const auto news = run();
    EXPECT_EQ(std::ranges::count_if(news, [](const FinderNews &one) { return one.found.has_value(); }), 1);
    EXPECT_TRUE(news[1].found->sentence.startsWith(u"The Modbus unit 1 answers."));
    EXPECT_TRUE(news[2].sentence.contains(u"does not look at the unit"));
}

TEST_F(GatewayHostFinderTest, AnExceptionOfAGatewayForAMissingUnitIsNobody)
{
    unit = 77; // that is not asked
    otherwise = RegisterError::Kind::exception;
    const auto news = run();
    EXPECT_EQ(news.back().kind, Kind::nobody);
    EXPECT_TRUE(news.back().sentence.contains(u"no unit answers"));
}

TEST_F(GatewayHostFinderTest, TakesHoldingRegistersWhereThereAreNoOthers)
{
    unit = 1;
    bank->inputEnd = 0;
    const auto news = run();
    ASSERT_TRUE(news[1].found);
    EXPECT_TRUE(news[1].found->link.contains(u"in-area=holding")) << news[1].found->link.toStdString();
}

TEST_F(GatewayHostFinderTest, ACancelledSearchSaysNothingAboutTheHost)
{
    isInterrupted = true;
    const auto news = run();
    ASSERT_EQ(news.size(), 1U);
    EXPECT_EQ(news[0].sentence, u"The search was cancelled.");
}

} // namespace
} // namespace codewheel
