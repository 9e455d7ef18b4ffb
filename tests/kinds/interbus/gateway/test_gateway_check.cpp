// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/gateway_check.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace test;

// A gateway that cannot be reached, or not always.
class RefusingPort final : public RegisterBankPort
{
public:
    using RegisterBankPort::RegisterBankPort;
    Result<void> open() override { return refusal ? tl::unexpected(*refusal) : RegisterBankPort::open(); }
    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        ++reads;
        if (failures > 0 && failures-- > 0)
            return failed(how);
        if (static_cast<int>(to.size()) > most)
            return exception(3);
        return RegisterBankPort::read(area, first, to);
    }

    std::optional<Refusal> refusal;
    RegisterError::Kind how = RegisterError::Kind::noAnswer;
    int failures = 0;
    int reads = 0;
    int most = 125; // registers in one request
};

class GatewayCheckTest : public testing::Test
{
protected:
    static std::vector<CheckedDevice> frabaRing(int devices)
    {
        static const Catalog catalog = Catalog::builtIn();
        std::vector<CheckedDevice> ring;
        for (int i = 1; i <= devices; ++i)
            ring.push_back({k3At(i).participant, {*catalog.find(u"fraba-ocd-ib"), 0x2000}});
        return ring;
    }
    std::vector<GatewayFinding> run(std::vector<CheckedDevice> devices,
                                    std::optional<NodeId> only = std::nullopt)
    {
        GatewayCheck check(port, settings, std::move(devices), only);
        std::vector<GatewayFinding> findings;
        while (!check.isDone())
            findings.push_back(check.next());
        EXPECT_EQ(findings.size(), check.steps());
        EXPECT_EQ(bank->writes, 0);
        if (findings.back().step == GatewayStep::map) { // each test of the other steps is about one of them
            map = findings.back();
            findings.pop_back();
        }
        return findings;
    }
    void show(int device, Word word)
    {
        bank->input[2 * device] = static_cast<Register>(word >> 16);
        bank->input[2 * device + 1] = static_cast<Register>(word);
    }
    static std::optional<RefusalCode> whyOf(const GatewayFinding &finding)
    {
        return finding.why ? std::optional(finding.why->id) : std::nullopt;
    }
    // Of a word; nothing in it if there is none.
    static DeviceRegisters shownBy(const GatewayFinding &finding)
    {
        return finding.shown.value_or(DeviceRegisters());
    }
    static std::vector<CheckOutcome> outcomesOf(const std::vector<GatewayFinding> &findings)
    {
        std::vector<CheckOutcome> all;
        all.reserve(findings.size());
        for (const GatewayFinding &finding : findings)
            all.push_back(finding.outcome);
        return all;
    }

    std::shared_ptr<RegisterBank> bank = std::make_shared<RegisterBank>();
    RefusingPort port{bank};
    GatewaySettings settings;
    GatewayFinding map;
};

constexpr CheckOutcome passed = CheckOutcome::passed;
constexpr CheckOutcome failed = CheckOutcome::failed;
constexpr CheckOutcome skipped = CheckOutcome::skipped;

TEST_F(GatewayCheckTest, ABusyGatewayIsWaitedFor)
{
    show(0, 0x0000'1234);
    bank->busyUntil = std::chrono::milliseconds(100);
    for (const GatewayFinding &finding : run(frabaRing(1)))
        EXPECT_NE(finding.outcome, failed) << finding.sentence.toStdString();
}

TEST_F(GatewayCheckTest, AGoodGatewayPassesEveryStep)
{
    settings.statusRegister = 100;
    bank->input[100] = 0x00E0;
    show(0, 0x0000'1234);
    show(1, 0xC200'00FF);
    const auto findings = run(frabaRing(2));
    EXPECT_EQ(outcomesOf(findings), std::vector(8, passed));
    EXPECT_TRUE(findings[5].sentence.contains(QStringLiteral("00E0h"))) << findings[5].sentence.toStdString();
    const DeviceRegisters shown = shownBy(findings[7]);
    EXPECT_EQ(shown.place, DeviceNumber({2, 0}).node());
    EXPECT_EQ(shown.in, (RegisterBlock{2, 2}));
    EXPECT_EQ(shown.inNow, (std::vector<Register>{0xC200, 0x00FF}));
    EXPECT_EQ(shown.outNow, (std::vector<Register>{0, 0}));
    EXPECT_TRUE(shown.stoodStill);
    EXPECT_EQ(shown.readings.size(), 4U);
}

TEST_F(GatewayCheckTest, ARingThatHasFailedIsNamedWithThePlaceOfTheFault)
{
    settings.statusRegister = 100;
    settings.faultBits = 4;
    bank->input[100] = 0x0084;
    bank->input[101] = 0x0200;
    EXPECT_EQ(whyOf(run(frabaRing(2))[5]), GatewayRefusalId::ringFailed) << "nothing tells where";
    settings.placeRegister = 101;
    const auto finding = run(frabaRing(2))[5];
    EXPECT_EQ(whyOf(finding), GatewayRefusalId::ringFailedAt);
    EXPECT_TRUE(finding.sentence.contains(QStringLiteral("2.0"))) << finding.sentence.toStdString();
}

TEST_F(GatewayCheckTest, AnUnknownHostIsTheFirstThingMissing)
{
    port.refusal = Refusal{RefusalKind::link, RefusalId::hostNotFound, {QStringLiteral("nowhere")}};
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(outcomesOf(findings), (std::vector{failed, skipped, skipped, skipped, skipped, skipped}));
    EXPECT_EQ(whyOf(findings[0]), RefusalId::hostNotFound);
    EXPECT_EQ(port.reads, 0);
}

TEST_F(GatewayCheckTest, AHostThatRefusesIsKnown)
{
    port.refusal = Refusal{RefusalKind::link, RefusalId::connectionRefused, {QStringLiteral("here:502")}};
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, failed, skipped, skipped, skipped, skipped}));
}

TEST_F(GatewayCheckTest, ASilentUnitEndsTheCheck)
{
    port.failures = 1'000;
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, failed, skipped, skipped, skipped}));
    EXPECT_EQ(port.reads, settings.retries + 1);
    EXPECT_EQ(whyOf(findings[2]), GatewayRefusalId::registersUnanswered);
}

TEST_F(GatewayCheckTest, ALostAnswerIsAskedForAgain)
{
    port.failures = settings.retries;
    EXPECT_EQ(outcomesOf(run(frabaRing(1))), std::vector(6, passed));
}

TEST_F(GatewayCheckTest, StoppingLeavesTheRestOut)
{
    port.failures = 1;
    port.how = RegisterError::Kind::stopped;
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(whyOf(findings[2]), RefusalId::cancelled);
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, failed, skipped, skipped, skipped}));
}

TEST_F(GatewayCheckTest, AShortImageIsSaidWithTheFirstDeviceThatIsMissing)
{
    bank->inputEnd = 7; // the last device has one of its two registers
    const auto findings = run(frabaRing(4));
    EXPECT_EQ(outcomesOf(findings),
              (std::vector{passed, passed, passed, failed, passed, passed, passed, passed, failed}));
    EXPECT_EQ(whyOf(findings[3]), GatewayRefusalId::registersRefused);
    EXPECT_TRUE(findings[3].sentence.contains(QStringLiteral("4.0"))) << findings[3].sentence.toStdString();
    EXPECT_TRUE(findings[8].shown.has_value());
}

TEST_F(GatewayCheckTest, AUnitWithoutAnyOfTheRegistersAnswersAllTheSame)
{
    bank->inputEnd = 0;
    EXPECT_EQ(outcomesOf(run(frabaRing(1))), (std::vector{passed, passed, passed, failed, passed, failed}));
}

TEST_F(GatewayCheckTest, OutIsNotReadWhereTheSettingsSaySo)
{
    settings.readsBack = false;
    bank->holdingEnd = 0;
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, passed, passed, skipped, passed}));
    EXPECT_TRUE(shownBy(findings[5]).outNow.empty());
}

TEST_F(GatewayCheckTest, AnImageThatCannotBeIsSaid)
{
    settings.inArea = RegisterArea::holding; // where OUT is
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(whyOf(findings[3]), GatewayRefusalId::registerMapWrong);
    EXPECT_EQ(outcomesOf(findings), (std::vector{passed, passed, passed, failed, skipped, skipped}));
    EXPECT_EQ(whyOf(run({})[3]), GatewayRefusalId::gatewayHasNoDevices);
}

TEST_F(GatewayCheckTest, TheOtherWordOrderIsRecognized)
{
    settings.highWordFirst = false;
    show(0, 0x0000'1234);
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(findings[5].outcome, failed);
    EXPECT_TRUE(findings[5].sentence.contains(QStringLiteral("high word first (00001234)")))
        << findings[5].sentence.toStdString();
}

TEST_F(GatewayCheckTest, ExchangedBytesAreRecognized)
{
    show(0, 0x0000'3412);
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(findings[5].outcome, failed);
    EXPECT_TRUE(findings[5].sentence.contains(QStringLiteral("bytes"))) << findings[5].sentence.toStdString();
}

TEST_F(GatewayCheckTest, AWordThatFitsInNoOrderIsElsewhere)
{
    settings.inFirst = 10;
    bank->input = {{10, 0x7777}, {11, 0x7777}};
    const auto findings = run(frabaRing(1));
    EXPECT_EQ(findings[5].outcome, failed);
    EXPECT_TRUE(findings[5].sentence.contains(QStringLiteral("register 10")))
        << findings[5].sentence.toStdString();
}

TEST_F(GatewayCheckTest, AWordThatProvesNoOrderIsSaid)
{
    const auto findings = run(frabaRing(1)); // 00000000
    EXPECT_EQ(findings[5].outcome, passed);
    EXPECT_TRUE(findings[5].sentence.contains(QStringLiteral("same in both word orders")))
        << findings[5].sentence.toStdString();
}

TEST_F(GatewayCheckTest, HowManyRegistersItMovesInARequestIsFoundAndProposed)
{
    constexpr int devices = 40;
    for (const int most : {61, 3, 2, 79}) {
        port.most = most;
        settings.mostRead = 125;
        const auto findings = run(frabaRing(devices));
        const auto &area = findings[3];
        EXPECT_EQ(area.outcome, failed);
        EXPECT_EQ(area.proposed,
                  (std::map<QString, QString>{{QStringLiteral("most-read"), QString::number(most)}}));
        EXPECT_TRUE(area.sentence.startsWith(QStringLiteral("All registers can be read")) &&
                    area.sentence.contains(QStringLiteral("no more than %1 in one").arg(most)))
            << area.sentence.toStdString();
        EXPECT_EQ(findings[4].outcome, passed) << "what was found holds for the steps that follow";
        EXPECT_FALSE(map.sentence.contains(QStringLiteral("refuses"))) << map.sentence.toStdString();
        settings.mostRead = most;
        EXPECT_EQ(run(frabaRing(devices))[4].outcome, passed);
    }
}

TEST_F(GatewayCheckTest, OneDeviceCanBeReadAlone)
{
    show(1, 0x0000'0042);
    const auto findings = run(frabaRing(3), DeviceNumber{2, 0}.node());
    ASSERT_EQ(findings.size(), 6U);
    EXPECT_EQ(shownBy(findings[5]).place, DeviceNumber({2, 0}).node());
    EXPECT_EQ(shownBy(findings[5]).inNow, (std::vector<Register>{0, 0x42}));
}

TEST_F(GatewayCheckTest, AMapThatNoOtherNearItFitsIsRight)
{
    bank->inputEnd = 4;
    show(0, 0x0000'1234);
    show(1, 0x0000'0777);
    run(frabaRing(2));
    EXPECT_EQ(map.outcome, passed) << map.sentence.toStdString();
}

TEST_F(GatewayCheckTest, AMapThatIsOffByOneIsRecognizedAndTheRightOneProposed)
{
    settings.inFirst = 10;
    bank->input = {{10, 0xFFFF}, {11, 0}, {12, 0x1234}, {13, 0}, {14, 0x0777}, {15, 0xFFFF}};
    run(frabaRing(2));
    EXPECT_EQ(map.outcome, failed);
    EXPECT_EQ(map.proposed, (std::map<QString, QString>{{QStringLiteral("in"), QStringLiteral("11")},
                                                        {QStringLiteral("order"), QStringLiteral("high")}}))
        << map.sentence.toStdString();
}

// As with a gateway whose image is just as long as the ring.
TEST_F(GatewayCheckTest, AMapThatIsOffByOneAtTheEndOfTheAreaIsRecognizedToo)
{
    bank->inputEnd = 4;
    show(0, 0x0000'1234);
    show(1, 0x0000'0777);
    settings.inFirst = 1;
    run(frabaRing(2));
    EXPECT_EQ(map.proposed, (std::map<QString, QString>{{QStringLiteral("in"), QStringLiteral("0")},
                                                        {QStringLiteral("order"), QStringLiteral("high")}}))
        << map.sentence.toStdString();
}

// A word order that is exchanged makes up for a map that is off by one: OUT would go out beside its devices.
TEST_F(GatewayCheckTest, AMapThatSeveralFitIsNotGreen)
{
    bank->input = {{10, 0x0A0B}, {11, 0}, {12, 0x1234}, {13, 0}, {14, 0x0777}};
    settings.inFirst = 10;
    settings.highWordFirst = false;
    const auto findings = run(frabaRing(2));
    EXPECT_EQ(findings[5].outcome, passed) << "each word fits by itself";
    EXPECT_EQ(map.outcome, failed);
    EXPECT_TRUE(map.sentence.contains(QStringLiteral("IN from register 11, high word first")))
        << map.sentence.toStdString();
    settings.highWordFirst = true;
    EXPECT_FALSE(run(frabaRing(2))[5].sentence.contains(QStringLiteral("change the word order")));
    EXPECT_EQ(map.outcome, failed);
    EXPECT_TRUE(map.proposed.empty()) << "which is right is not known";
}

TEST_F(GatewayCheckTest, WhatIsNotDescribedIsShownAndNotJudged)
{
    const auto findings = run({{deviceAt(1, 1, 1).participant, {}}, {deviceAt(2, 0, 2).participant, {}}});
    EXPECT_EQ(findings[5].outcome, skipped);
    EXPECT_EQ(shownBy(findings[5]).readings.size(), 2U);
    EXPECT_EQ(findings[6].outcome, skipped);
    EXPECT_TRUE(shownBy(findings[6]).readings.empty());
    EXPECT_EQ(shownBy(findings[6]).out, (RegisterBlock{1, 2}));
}

} // namespace
} // namespace codewheel
