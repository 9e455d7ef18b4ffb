// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "tests/kinds/canopen/driver/driver_bench.h"

#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

using Rows = std::vector<std::string>;

struct NodeJobs : ::testing::Test
{
    NodeJobs() { bench.settle(); }

    static WriteParameters writing(ParameterValues values, bool onlyWhatDiffers = false)
    {
        return {.values = std::move(values), .onlyWhatDiffers = onlyWhatDiffers, .previous = {}};
    }

    DriverBench bench;
};

TEST_F(NodeJobs, ReadsEachObjectOnceAndLeavesOutWhatTheEncoderDoesNotHave)
{
    const Outcome &outcome =
        bench.finish(ReadParameters{{Parameter::scaling, Parameter::direction, Parameter::steps,
                                     Parameter::lowerLimit, Parameter::offset}});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.jobLog(), (Rows{"6000:0", "6001:0", "6401:1", "6509:0"}));
    EXPECT_EQ(outcome.read, (ParameterValues{{Parameter::scaling, 1},
                                             {Parameter::direction, 0},
                                             {Parameter::steps, 4096},
                                             {Parameter::offset, 0}}));
}

TEST_F(NodeJobs, ReadingOnlyWhatTheEncoderDoesNotHaveFails)
{
    EXPECT_FALSE(bench.finish(ReadParameters{{Parameter::lowerLimit}}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoAborted);
    EXPECT_EQ(bench.outcome->result.error().arguments,
              (std::vector<RefusalArgument>{QStringLiteral("6401h:1"), Word{0x06020000}}));
}

TEST_F(NodeJobs, SignsComeFromTheDescriptionAndSizesFromTheAnswer)
{
    bench.has["6509:0"] = {0xFE, 0xFF};
    bench.has["6001:0"] = {0xFE, 0xFF};
    const Outcome &outcome = bench.finish(ReadParameters{{Parameter::steps, Parameter::offset}});
    EXPECT_EQ(outcome.read, (ParameterValues{{Parameter::steps, 65534}, {Parameter::offset, -2}}));
    bench.log.clear();
    bench.finish(writing({{Parameter::steps, 1000}}));
    EXPECT_EQ(bench.jobLog()[0], "6001:0 E8 03") << "as wide as the encoder has it";
}

TEST_F(NodeJobs, WritesReadsBackAndStores)
{
    const Outcome &outcome =
        bench.finish(writing({{Parameter::measuringRange, 16'000'000}, {Parameter::steps, 4000}}));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.jobLog(), (Rows{"6001:0 A0 0F 00 00", "6001:0", "6002:0 00 24 F4 00", "6002:0",
                                    "1010:1 73 61 76 65", "6500:0", "6509:0"}));
    EXPECT_EQ(outcome.written.size(), 2u);
    EXPECT_EQ(outcome.eepromWrites, 1);
    EXPECT_EQ(bench.eepromWrites, 1);
    EXPECT_EQ(outcome.positionBefore, 5000);
    EXPECT_EQ(bench.known.at(Parameter::steps).evidence, Evidence::read);
    EXPECT_EQ(bench.kept(Parameter::steps), Kept::stored);
}

TEST_F(NodeJobs, BitsAreWrittenTogetherAndTheOthersStay)
{
    const Outcome &outcome =
        bench.finish(writing({{Parameter::scaling, 1}, {Parameter::steps, 4000}, {Parameter::direction, 1}}));
    EXPECT_TRUE(outcome.result);
    const Rows rows = bench.jobLog();
    EXPECT_EQ((Rows{rows.begin(), rows.begin() + 5}),
              (Rows{"6001:0 A0 0F 00 00", "6001:0", "6000:0", "6000:0 05 10", "6000:0"}))
        << "scaling goes on when the steps are there; the maker's bit 12 stays";
    EXPECT_EQ(outcome.written.size(), 3u);
    EXPECT_EQ(bench.value(Parameter::operatingParameters), 0x1005) << "what is in force is told by 6500h";
}

TEST_F(NodeJobs, ScalingGoesOffBeforeTheStepsAreWritten)
{
    bench.finish(writing({{Parameter::steps, 4000}, {Parameter::scaling, 0}}));
    const Rows rows = bench.jobLog();
    EXPECT_EQ((Rows{rows.begin(), rows.begin() + 4}),
              (Rows{"6000:0", "6000:0 00 10", "6000:0", "6001:0 A0 0F 00 00"}));
}

TEST_F(NodeJobs, WhatIsThereIsNotWrittenAgainOnlyStored)
{
    const Outcome &outcome = bench.finish(writing({{Parameter::steps, 4096}}, true));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.jobLog(), (Rows{"6001:0", "1010:1 73 61 76 65"}));
    EXPECT_TRUE(outcome.written.empty());
    EXPECT_EQ(outcome.stored.size(), 1u);
    bench.log.clear();
    const Outcome &again = bench.finish(writing({{Parameter::steps, 4096}}, true));
    EXPECT_EQ(bench.jobLog(), (Rows{"6001:0"})) << "it is stored now";
    EXPECT_EQ(again.alreadyThere.size(), 1u);
    EXPECT_EQ(again.eepromWrites, 0);
}

TEST_F(NodeJobs, AnEncoderThatHasNoCommandToStoreKeepsWhatItKeeps)
{
    bench.has.erase("1010:1");
    const Outcome &outcome = bench.finish(writing({{Parameter::steps, 4000}}));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.eepromWrites, 0);
    EXPECT_EQ(bench.kept(Parameter::steps), Kept::notKnown);
}

TEST_F(NodeJobs, OnlyToStoreWhatCannotBeStoredFails)
{
    bench.has.erase("1010:1");
    EXPECT_FALSE(bench.finish(StoreParameters{}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoAborted);
    EXPECT_EQ(bench.outcome->eepromWrites, 0);
}

TEST_F(NodeJobs, APresetThatWasRefusedOrNotSentHasSetNoPosition)
{
    bench.refuses["6003:0"] = 0x06090030;
    EXPECT_FALSE(bench.finish(SetPreset{.value = 7}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoAborted);
    EXPECT_FALSE(bench.progress.setsPosition);
    bench.refuses.clear();
    bench.next("6003:0 07 00 00 00", DriverBench::Fate::notSent);
    EXPECT_FALSE(bench.finish(SetPreset{.value = 7}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoNotSent);
    EXPECT_FALSE(bench.progress.setsPosition);
}

TEST_F(NodeJobs, APresetThatIsCancelledIsStoredIfThatIsWanted)
{
    ASSERT_TRUE(bench.begin(SetPreset{.value = 7}));
    while (std::ranges::count(bench.log, std::string("6003:0 07 00 00 00")) == 0)
        bench.step();
    bench.driver.cancel(OnCancel::runWithWhatItHas, bench.now);
    EXPECT_TRUE(bench.finish().isPositionSet);
    EXPECT_EQ(bench.jobLog().back(), "1010:1 73 61 76 65");
}

TEST_F(NodeJobs, ARefusalEndsTheJobAndNothingIsStored)
{
    bench.refuses["6001:0"] = 0x06090030;
    const Outcome &outcome = bench.finish(writing({{Parameter::steps, 4000}}));
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoAborted);
    EXPECT_EQ(bench.jobLog(), (Rows{"6001:0 A0 0F 00 00"}));
    EXPECT_TRUE(outcome.written.empty());
    EXPECT_EQ(outcome.inDoubt, InDoubt());
}

TEST_F(NodeJobs, AWriteWithoutAnAnswerThatIsFoundWasDone)
{
    bench.next("6001:0 A0 0F 00 00", DriverBench::Fate::unanswered);
    const Outcome &outcome = bench.finish(writing({{Parameter::steps, 4000}}));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::steps, 4000}}));
    EXPECT_EQ(std::ranges::count(bench.log, std::string("6001:0 A0 0F 00 00")), 1);
}

TEST_F(NodeJobs, AWriteWithoutAnAnswerThatIsNotFoundWasNotDone)
{
    bench.next("6001:0 A0 0F 00 00", DriverBench::Fate::lost);
    const Outcome &outcome = bench.finish(writing({{Parameter::steps, 4000}}));
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoWriteNotDone);
    EXPECT_TRUE(outcome.written.empty());
    EXPECT_EQ(outcome.inDoubt, InDoubt());
    EXPECT_EQ(std::ranges::count(bench.log, std::string("6001:0 A0 0F 00 00")), 1);
}

TEST_F(NodeJobs, AWriteWithoutAnAnswerThatCannotBeReadIsInDoubt)
{
    bench.next("6001:0 A0 0F 00 00", DriverBench::Fate::unanswered);
    bench.next("6001:0", DriverBench::Fate::lost);
    const Outcome &outcome = bench.finish(writing({{Parameter::steps, 4000}}));
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoWriteUnknown);
    EXPECT_EQ(outcome.inDoubt.values, (ParameterValues{{Parameter::steps, 4000}}));
    EXPECT_FALSE(bench.value(Parameter::steps));
}

TEST_F(NodeJobs, AWriteThatCouldNotBeReadBackIsInDoubt)
{
    bench.next("6001:0 A0 0F 00 00", DriverBench::Fate::unanswered);
    ASSERT_TRUE(bench.begin(writing({{Parameter::steps, 4000}})));
    while (bench.log.empty() || bench.log.back() != "6001:0 A0 0F 00 00")
        bench.step();
    bench.next("6001:0", DriverBench::Fate::notSent);
    const Outcome &outcome = bench.finish();
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoWriteUnknown);
    EXPECT_EQ(outcome.inDoubt.values, (ParameterValues{{Parameter::steps, 4000}}));
}

TEST_F(NodeJobs, ANodeThatStartsAnewLosesWhatWasWritten)
{
    ASSERT_TRUE(bench.begin(writing({{Parameter::steps, 4000}})));
    while (bench.log.empty() || bench.log.back() != "6001:0 A0 0F 00 00")
        bench.step();
    bench.hear(0x705, {0x00});
    const Outcome &outcome = bench.finish();
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::nodeRestarted);
    EXPECT_TRUE(outcome.written.empty());
    EXPECT_EQ(outcome.inDoubt.values, (ParameterValues{{Parameter::steps, 4000}}));
    EXPECT_EQ(bench.jobLog().back(), "6001:0 A0 0F 00 00") << "nothing is stored";
}

TEST_F(NodeJobs, APresetThatDoesNotShowIsNotDoneAndNotStored)
{
    bench.ignoresPresets = true;
    EXPECT_FALSE(bench.finish(SetPreset{.value = 100}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::presetNotInForce);
    for (const std::string &row : bench.jobLog())
        EXPECT_FALSE(row.starts_with("1010:1")) << row;
}

TEST_F(NodeJobs, WhatCouldNotBeSentChangesNothing)
{
    bench.next("6001:0 A0 0F 00 00", DriverBench::Fate::notSent);
    const Outcome &outcome = bench.finish(writing({{Parameter::steps, 4000}}));
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoNotSent);
    EXPECT_EQ(outcome.inDoubt, InDoubt());
}

TEST_F(NodeJobs, AnotherValueThanTheOneWrittenIsReported)
{
    bench.has["6001:0"] = {0, 0x10, 0, 0};
    ASSERT_TRUE(bench.begin(writing({{Parameter::steps, 4000}})));
    while (bench.log.empty() || bench.log.back() != "6001:0 A0 0F 00 00")
        bench.step();
    bench.has["6001:0"] = {0x80, 0x0F, 0, 0};
    const Outcome &outcome = bench.finish();
    EXPECT_EQ(bench.refusal(), RefusalId::verificationFailed);
    EXPECT_TRUE(outcome.written.empty());
    EXPECT_EQ(bench.value(Parameter::steps), 3968);
}

TEST_F(NodeJobs, WhetherItWasStoredIsNotKnownWithoutAnAnswer)
{
    bench.next("1010:1 73 61 76 65", DriverBench::Fate::unanswered);
    const Outcome &outcome = bench.finish(writing({{Parameter::steps, 4000}}));
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::storingUnknown);
    EXPECT_EQ(outcome.written.size(), 1u) << "it is in force";
    EXPECT_EQ(outcome.inDoubt.eepromWrites, 1);
    EXPECT_EQ(bench.kept(Parameter::steps), Kept::notKnown);
}

TEST_F(NodeJobs, StoringIsAJobOfItsOwn)
{
    bench.finish(ReadParameters{{Parameter::steps}});
    const Outcome &outcome = bench.finish(StoreParameters{});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(std::ranges::count(outcome.stored, ParameterValue{Parameter::steps, 4096}), 1);
    EXPECT_EQ(outcome.eepromWrites, 1);
    EXPECT_EQ(bench.kept(Parameter::steps), Kept::stored);
}

TEST_F(NodeJobs, FactoryValuesAreReadAfterAReset)
{
    bench.finish(writing({{Parameter::steps, 4000}}));
    bench.log.clear();
    bench.has["6001:0"] = {0, 0x20, 0, 0};
    const Outcome &outcome = bench.finish(ResetToDefault{});
    EXPECT_TRUE(outcome.result);
    const Rows rows = bench.jobLog();
    EXPECT_EQ((Rows{rows.begin(), rows.begin() + 3}), (Rows{"1011:1 6C 6F 61 64", "NMT 81", "6001:0"}));
    EXPECT_EQ(outcome.eepromWrites, 1);
    EXPECT_EQ(bench.value(Parameter::steps), 8192);
    EXPECT_EQ(bench.messages.size(), 0u) << "its boot-up was expected";
}

TEST_F(NodeJobs, ANodeThatDoesNotComeBackIsToBeSearchedFor)
{
    bench.bootsAfterReset = false;
    const Instant begun = bench.now;
    EXPECT_FALSE(bench.finish(ResetToDefault{}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::notBackAfterReset);
    EXPECT_GE(bench.now - begun, std::chrono::seconds(5));
    EXPECT_LT(bench.now - begun, std::chrono::seconds(6));
}

TEST_F(NodeJobs, ARunningNodeIsNotStoppedUnasked)
{
    bench.refusesWhileRunning = bench.isRunning = true;
    bench.hear(0x705, {0x05});
    const WriteParameters job = writing({{Parameter::steps, 4000}});
    EXPECT_FALSE(bench.finish(job).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::nodeWouldStop);
    EXPECT_EQ(bench.jobLog(), (Rows{"6001:0 A0 0F 00 00"}));
    EXPECT_FALSE(bench.finish(ResetToDefault{}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::nodeWouldStop);
    EXPECT_EQ(bench.jobLog(), (Rows{"6001:0 A0 0F 00 00"})) << "nothing is sent";

    bench.log.clear();
    bench.driver.mayStopNode(true);
    EXPECT_TRUE(bench.finish(job).result);
    const Rows rows = bench.jobLog();
    EXPECT_EQ((Rows{rows.begin(), rows.begin() + 3}),
              (Rows{"6001:0 A0 0F 00 00", "NMT 80", "6001:0 A0 0F 00 00"}));
    EXPECT_EQ(rows.back(), "NMT 01") << "and started again";
    EXPECT_TRUE(bench.isRunning);
}

// Some start by themselves behind the boot-up, and a shaft at rest sends nothing.
TEST_F(NodeJobs, ANodeThatMayRunIsNotStoppedUnaskedEither)
{
    bench.hear(0x705, {0x00});
    bench.run(std::chrono::seconds(1));
    bench.log.clear();
    EXPECT_FALSE(bench.finish(ResetToDefault{}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::nodeMayRun);
    bench.refusesWhileRunning = bench.isRunning = true;
    EXPECT_FALSE(bench.finish(writing({{Parameter::steps, 4000}})).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::nodeMayRun);
    EXPECT_EQ(bench.jobLog(), (Rows{"6001:0 A0 0F 00 00"})) << "nothing is sent but what was refused";

    bench.driver.mayStopNode(true);
    EXPECT_TRUE(bench.finish(writing({{Parameter::steps, 4000}})).result);
    EXPECT_EQ(bench.jobLog().back(), "NMT 01") << "and started again";
    bench.hear(0x705, {0x00});
    bench.driver.mayStopNode(true);
    EXPECT_TRUE(bench.finish(ResetToDefault{}).result);
    EXPECT_EQ(bench.jobLog().back(), "NMT 01") << "it may have run before";

    bench.hear(0x705, {0x00});
    bench.hear(0x000, {0x80, 0x05});
    bench.isRunning = false;
    EXPECT_TRUE(bench.finish(ResetToDefault{}).result) << "it was stopped first";
}

TEST_F(NodeJobs, WhetherANodeRunsAgainIsSeenOrSaid)
{
    bench.refusesWhileRunning = bench.isRunning = true;
    for (const auto &[shows, why] :
         {std::pair<std::optional<std::uint8_t>, CanopenRefusalId>{0x7F, CanopenRefusalId::notStartedAgain},
          {std::nullopt, CanopenRefusalId::startNotSeen}}) {
        bench.hear(0x705, {0x05});
        bench.isRunning = true;
        bench.showsAfterStart = shows;
        bench.driver.mayStopNode(true);
        const Instant begun = bench.now;
        const Outcome &outcome = bench.finish(writing({{Parameter::steps, shows ? 4000 : 4001}}));
        EXPECT_EQ(bench.refusal(), why);
        EXPECT_EQ(outcome.written.size(), 1U) << "the value is there";
        EXPECT_LT(bench.now - begun, std::chrono::seconds(4));
    }
}

TEST_F(NodeJobs, OfTwoNodesWithOneNumberNothingIsKnown)
{
    bench.finish(ReadParameters{{Parameter::direction}});
    ASSERT_TRUE(bench.begin(writing({{Parameter::steps, 4000}, {Parameter::measuringRange, 8'000'000}})));
    while (!findValue(bench.progress.confirmed, Parameter::steps))
        bench.step();
    bench.driver.stop(nodeIsDoubled(5), bench.now);
    bench.run(std::chrono::milliseconds(1));
    ASSERT_TRUE(bench.outcome);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::nodeDoubled);
    EXPECT_TRUE(bench.outcome->written.empty());
    EXPECT_TRUE(findValue(bench.outcome->inDoubt.values, Parameter::steps));
    EXPECT_FALSE(bench.value(Parameter::direction)) << "it may be of either";
}

TEST_F(NodeJobs, ANodeThatWasStoppedForAJobIsStartedAgainEvenIfItFails)
{
    bench.refusesWhileRunning = bench.isRunning = true;
    bench.hear(0x705, {0x05});
    bench.next("6001:0", DriverBench::Fate::lost); // the read back
    bench.driver.mayStopNode(true);
    EXPECT_FALSE(bench.finish(writing({{Parameter::steps, 4000}})).result);
    EXPECT_EQ(bench.jobLog().back(), "NMT 01");
}

struct Disturbed
{
    std::size_t request;
    DriverBench::Fate fate;
};

// What the job says of its values and of the position must be so, wherever an answer is missing.
void checkDisturbed(const Job &job, const ParameterValues &wanted, const Disturbed &by)
{
    DriverBench bench;
    bench.settle();
    bench.fateOfJobRequest = {by.request, by.fate};
    const Outcome outcome = bench.finish(job);
    const auto why = ::testing::Message()
                     << "request " << by.request << ", fate " << static_cast<int>(by.fate);
    for (const std::string &row : bench.log)
        if (row.find(' ') != std::string::npos) {
            EXPECT_EQ(std::ranges::count(bench.log, row), 1) << why << ": " << row;
        }
    bench.fateOfJobRequest.reset();
    const auto before = DriverBench().has;
    bench.run(std::chrono::seconds(5));
    for (const ParameterValue &value : wanted) {
        ASSERT_TRUE(bench.finish(ReadParameters{{value.parameter}}).result) << why;
        const bool has = bench.value(value.parameter) == value.value.number();
        const bool saysSo = findValue(outcome.written, value.parameter) == value.value;
        const bool isInDoubt = findValue(outcome.inDoubt.values, value.parameter).has_value();
        EXPECT_TRUE(isInDoubt || has == saysSo) << why << ": " << parameterKey(value.parameter).toStdString();
    }
    if (std::holds_alternative<SetPreset>(job) && !outcome.inDoubt.position) {
        const bool wasSet = bench.has.at("6004:0") != before.at("6004:0");
        const bool isStored = bench.refusal() == CanopenRefusalId::storingUnknown;
        EXPECT_TRUE(!outcome.result || wasSet || isStored) << why;
        EXPECT_FALSE(bench.refusal() == CanopenRefusalId::sdoWriteNotDone && wasSet) << why;
    }
}

TEST(DisturbedNode, SaysOfEachValueWhatIsSo)
{
    const ParameterValues wanted{{Parameter::steps, 4000},
                                 {Parameter::measuringRange, 8'000'000},
                                 {Parameter::scaling, 0},
                                 {Parameter::direction, 1}};
    constexpr std::size_t mostRequests = 20;
    for (std::size_t request = 0; request < mostRequests; ++request)
        for (const auto fate :
             {DriverBench::Fate::lost, DriverBench::Fate::unanswered, DriverBench::Fate::notSent}) {
            for (const bool onlyWhatDiffers : {false, true})
                checkDisturbed(
                    WriteParameters{.values = wanted, .onlyWhatDiffers = onlyWhatDiffers, .previous = {}},
                    wanted, {request, fate});
            checkDisturbed(SetPreset{.value = 100}, {}, {request, fate});
            checkDisturbed(ResetToDefault{}, {}, {request, fate});
        }
}

// TWK: its number is 2000h, which is the position of another make.
TEST(NodeMake, ObjectsOfTheMakerAreWrittenToThatMakeOnly)
{
    Catalog catalog;
    ASSERT_TRUE(
        catalog.add(R"({"key": "node", "vendor": "TWK", "name": "N", "manual": "M", "profile": "CiA-406",
        "vendorNumber": "10Dh", "physicalStepsPerTurn": 0, "physicalTurns": 0, "parameters": [
        {"parameter": "address", "object": "2000", "type": "u8", "access": "rw", "minimum": 1, "maximum": 127}],
        "errors": [], "capabilities": {"presets": false, "cams": false, "readingHidesPosition": false,
        "presetIsStored": false, "hasBattery": false}, "quirks": {"confirmsWhileProcessing": false,
        "presetNeedsRearming": false, "mayCountStepsMinusOne": false, "hasModes": false}})",
                    QStringLiteral("node.json")));
    DriverBench bench(catalog.devices().front());
    bench.has["2000:0"] = {5};
    bench.settle();
    const WriteParameters job{.values = {{Parameter::lineAddress, 6}}, .previous = {}};
    EXPECT_TRUE(bench.finish(job).result);
    EXPECT_EQ(bench.jobLog(), (Rows{"1018:1", "2000:0 06", "2000:0", "1010:1 73 61 76 65"}));
    bench.log.clear();
    bench.has["1018:1"] = {0x82, 0, 0, 0};
    EXPECT_FALSE(bench.finish(job).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::makeDiffers);
    EXPECT_EQ(bench.jobLog(), (Rows{"1018:1"}));
}

TEST_F(NodeJobs, SetsThePositionAndStoresIt)
{
    const Outcome &outcome = bench.finish(SetPreset{.value = 100});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.jobLog(), (Rows{"6000:0", "6002:0", "6003:0", "6003:0 64 00 00 00", "6003:0", "6509:0",
                                    "1010:1 73 61 76 65"}));
    EXPECT_EQ(outcome.positionBefore, 5000);
    EXPECT_EQ(outcome.positionAfter, 100);
    EXPECT_EQ(outcome.eepromWrites, 1);
}

TEST_F(NodeJobs, APresetWithoutAnAnswerIsJudgedByWhatTheEncoderHas)
{
    bench.next("6003:0 64 00 00 00", DriverBench::Fate::unanswered);
    EXPECT_TRUE(bench.finish(SetPreset{.value = 100}).result);
    EXPECT_FALSE(bench.outcome->inDoubt.position);

    bench.next("6003:0 65 00 00 00", DriverBench::Fate::lost);
    EXPECT_FALSE(bench.finish(SetPreset{.value = 101}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoWriteNotDone);

    bench.has["6004:0"] = {0x88, 0x13, 0, 0}; // the same preset again: only the position tells
    bench.next("6003:0 64 00 00 00", DriverBench::Fate::unanswered);
    EXPECT_TRUE(bench.finish(SetPreset{.value = 100}).result);

    bench.next("6003:0 64 00 00 00", DriverBench::Fate::unanswered); // which is there already
    EXPECT_FALSE(bench.finish(SetPreset{.value = 100}).result);
    EXPECT_EQ(bench.refusal(), CanopenRefusalId::sdoWriteUnknown);
    EXPECT_TRUE(bench.outcome->inDoubt.position);
}

TEST_F(NodeJobs, APresetWhoseEffectNobodySawIsInDoubt)
{
    ASSERT_TRUE(bench.begin(SetPreset{.value = 100}));
    while (bench.log.empty() || bench.log.back() != "6003:0 64 00 00 00")
        bench.step();
    bench.driver.stop({RefusalKind::link, RefusalId::linkFailed, {}}, bench.now);
    bench.step();
    ASSERT_TRUE(bench.outcome);
    EXPECT_EQ(bench.outcome->positionAfter, std::nullopt);
    EXPECT_TRUE(bench.outcome->inDoubt.position) << "it was accepted";
}

TEST_F(NodeJobs, APresetLiesWithinTheRange)
{
    bench.finish(ReadParameters{{Parameter::scaling, Parameter::measuringRange}});
    EXPECT_FALSE(bench.finish(SetPreset{.value = 16'777'217}).result);
    EXPECT_EQ(bench.refusal(), RefusalId::valueOutOfRange);
}

TEST_F(NodeJobs, ByHandEachChangeWaits)
{
    ASSERT_TRUE(bench.begin(writing({{Parameter::steps, 4000}}), Pace::byHand));
    for (int i = 0; i < 50; ++i)
        bench.step();
    EXPECT_TRUE(bench.progress.waitsForUser);
    EXPECT_TRUE(bench.jobLog().empty());
    bench.driver.proceed();
    for (int i = 0; i < 50; ++i)
        bench.step();
    EXPECT_EQ(bench.jobLog(), (Rows{"6001:0 A0 0F 00 00", "6001:0"})) << "storing waits again";
    bench.driver.proceed();
    EXPECT_TRUE(bench.finish().result);
}

TEST_F(NodeJobs, ACancelledJobGivesBackWhatItKnows)
{
    bench.finish(ReadParameters{{Parameter::steps}});
    bench.log.clear();
    ASSERT_TRUE(bench.begin(writing({{Parameter::steps, 4000}, {Parameter::measuringRange, 8'000'000}})));
    while (!bench.outcome && (bench.log.empty() || bench.log.back() != "6001:0 A0 0F 00 00"))
        bench.step();
    bench.driver.cancel(OnCancel::restorePrevious, bench.now);
    const Outcome &outcome = bench.finish();
    EXPECT_EQ(bench.refusal(), RefusalId::cancelled);
    EXPECT_EQ(outcome.restored, Evidence::read);
    EXPECT_EQ(bench.has["6001:0"], (std::vector<std::uint8_t>{0, 0x10, 0, 0}));
    EXPECT_EQ(bench.value(Parameter::steps), 4096);
}

TEST_F(NodeJobs, AJobThatIsStoppedInAWriteLeavesItInDoubt)
{
    ASSERT_TRUE(bench.begin(writing({{Parameter::steps, 4000}})));
    std::optional<NodeRequest> request;
    while (!request || !std::get<SdoRequest>(*request).value) {
        if (request)
            bench.driver.answered(*request, {.kind = SdoOutcome::Kind::read, .value = {0, 0, 0, 0}},
                                  bench.now);
        request = bench.driver.next(bench.now);
    }
    bench.driver.stop({RefusalKind::link, RefusalId::linkFailed, {}}, bench.now);
    bench.step();
    ASSERT_TRUE(bench.outcome);
    EXPECT_EQ(bench.outcome->inDoubt.values, (ParameterValues{{Parameter::steps, 4000}}));
    EXPECT_EQ(bench.outcome->leftIn, EncoderState::unknown);
}

TEST_F(NodeJobs, AStoppedNodeIsAskedNothing)
{
    bench.settle();
    bench.hear(0x000, {0x02, 0x05});
    EXPECT_EQ(bench.driver.reading().state, EncoderState::waiting);
    EXPECT_FALSE(bench.driver.reading().position) << "it answers nothing";
    bench.run(std::chrono::seconds(2));
    EXPECT_TRUE(bench.log.empty());
}

// BEI has limits of 16 bits.
TEST_F(NodeJobs, CamsAreWrittenAsWideAsTheEncoderHasThem)
{
    for (const char *base : {"631", "632", "633"})
        for (int cam = 0; cam < 8; ++cam)
            bench.has[base + std::to_string(cam) + ":1"] = {0, 0};
    bench.has["6301:1"] = bench.has["6302:1"] = {0x00};
    CamProgram program;
    program.cam[0] = {.start = 100, .stop = 200, .active = true};
    EXPECT_TRUE(bench.finish(WriteCams{{program}, false, {}}).result);
    for (const char *row : {"6310:1 64 00", "6320:1 C8 00", "6301:1 01"})
        EXPECT_EQ(std::ranges::count(bench.log, std::string(row)), 1) << row;
    bench.log.clear();
    program.cam[0].stop = 300;
    EXPECT_TRUE(bench.finish(WriteCams{{program}, false, {}}).result);
    EXPECT_EQ(bench.jobLog().front(), "6310:1 64 00") << "how wide they are is known by now";
}

TEST_F(NodeJobs, CamsAreReadAndOnlyWhatDiffersIsWritten)
{
    for (const char *base : {"631", "632"})
        for (int cam = 0; cam < 8; ++cam)
            bench.has[base + std::to_string(cam) + ":1"] = {0, 0, 0, 0};
    for (int cam = 0; cam < 8; ++cam)
        bench.has["633" + std::to_string(cam) + ":1"] = {0, 0};
    bench.has["6301:1"] = {0x01};
    bench.has["6302:1"] = {0x00};
    bench.has["6310:1"] = {0x0A, 0, 0, 0};
    ASSERT_TRUE(bench.finish(ReadCams{{1}, {}}).result);
    ASSERT_EQ(bench.outcome->camsRead.size(), 1u);
    CamProgram program = bench.outcome->camsRead.front();
    EXPECT_EQ(program.cam[0].start, 10);
    EXPECT_TRUE(program.cam[0].active);

    program.cam[0].stop = 20;
    program.cam[1] = {.start = 30, .stop = 40, .active = true, .hysteresis = 2, .isInverted = true};
    bench.log.clear();
    const Outcome &outcome = bench.finish(WriteCams{{program}, true, {}});
    EXPECT_TRUE(outcome.result);
    Rows written;
    for (const std::string &row : bench.jobLog())
        if (row.find(' ') != std::string::npos)
            written.push_back(row);
    EXPECT_EQ(written, (Rows{"6320:1 14 00 00 00", "6311:1 1E 00 00 00", "6321:1 28 00 00 00", "6331:1 02 00",
                             "6302:1 02", "6301:1 03", "1010:1 73 61 76 65"}));
    ASSERT_EQ(bench.cams.size(), 1u);
    EXPECT_EQ(bench.cams.front().program, program);
    EXPECT_EQ(outcome.eepromWrites, 1);
}

// 019Ah, an inclinometer: what it has at 6001h and 6003h is something else.
struct OtherProfiles : ::testing::Test
{
    OtherProfiles() { bench.has["1000:0"] = {0x9A, 0x01, 0x01, 0x00}; }

    static bool isWrite(const std::string &row) { return row.find(' ') != std::string::npos; }
    bool hasWritten() const { return std::ranges::any_of(bench.log, isWrite); }

    const std::vector<Job> writing{WriteParameters{.values = {{Parameter::steps, 4000}}, .previous = {}},
                                   SetPreset{.value = 1000}, ResetToDefault{}, StoreParameters{}};
    DriverBench bench;
};

TEST_F(OtherProfiles, NothingIsWrittenToThem)
{
    bench.settle();
    for (const Job &job : writing) {
        EXPECT_FALSE(bench.finish(job).result);
        EXPECT_EQ(bench.refusal(), CanopenRefusalId::otherProfile);
        EXPECT_EQ(bench.outcome->result.error().arguments,
                  (std::vector<RefusalArgument>{std::int64_t{5}, std::int64_t{410}}));
    }
    EXPECT_FALSE(hasWritten());
    EXPECT_TRUE(bench.finish(ReadParameters{{Parameter::steps}}).result);
}

TEST_F(OtherProfiles, AreAskedForBeforeTheFirstWrite)
{
    for (const Job &job : writing) {
        bench.driver.lost(bench.now);
        bench.hear(0x705, {0x7F});
        bench.log.clear();
        EXPECT_FALSE(bench.finish(job).result);
        EXPECT_EQ(bench.refusal(), CanopenRefusalId::otherProfile);
        EXPECT_FALSE(hasWritten());
    }
    bench.hear(0x705, {0}); // another device may have booted
    bench.has["1000:0"] = {0x96, 0x01, 0x02, 0x00};
    bench.settle();
    EXPECT_TRUE(bench.finish(SetPreset{.value = 1000}).result);
}

TEST_F(OtherProfiles, ABootUpWhileTheProfileIsAskedForHoldsNothingUp)
{
    DriverBench its;
    const auto request = its.driver.next(its.now);
    ASSERT_TRUE(request);
    EXPECT_EQ(std::get<SdoRequest>(*request).object, (SdoObject{0x1000, 0}));
    its.hear(0x705, {0});
    its.driver.answered(*request, {.kind = SdoOutcome::Kind::read, .value = its.has["1000:0"]}, its.now);
    EXPECT_TRUE(its.finish(SetPreset{.value = 1000}).result);
}

TEST_F(OtherProfiles, WhoTellsNoneMayBeAnEncoder)
{
    for (const std::vector<std::uint8_t> &told : {std::vector<std::uint8_t>(), {0, 0, 0, 0}}) {
        DriverBench mute;
        mute.has["1000:0"] = told;
        if (told.empty())
            mute.has.erase("1000:0");
        EXPECT_TRUE(mute.finish(SetPreset{.value = 1000}).result);
    }
}

} // namespace
} // namespace codewheel::canopen
