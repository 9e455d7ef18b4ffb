// SPDX-License-Identifier: GPL-3.0-or-later
// A job is disturbed in each of its cycles in turn. However it goes: the job ends, OUT is 0 again, and what
// the driver reports is what the simulated encoder has.
#include "tests/kinds/interbus/ring/driven_encoder.h"

#include <algorithm>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct Make
{
    const char *name;
    QStringView key;
    std::unique_ptr<SimulatedK3> (*encoder)();
    ParameterValues values; // to write
    ParameterValues before; // what it has
};

const Make makes[] = {
    {"Fraba",
     u"fraba-ocd-ib",
     frabaK3,
     {{Parameter::steps, 255},
      {Parameter::revolutions, 2},
      {Parameter::direction, 4},
      {Parameter::preset, 7}},
     {{Parameter::steps, 8192},
      {Parameter::revolutions, 1},
      {Parameter::direction, 3},
      {Parameter::preset, 0}}},
    {"Baumer",
     u"baumer-gxp6w",
     baumerK3,
     {{Parameter::steps, 255}, {Parameter::revolutions, 2}, {Parameter::coding, 4}, {Parameter::offset, 9}},
     {{Parameter::steps, 8192}, {Parameter::revolutions, 1}, {Parameter::coding, 3}, {Parameter::offset, 0}}},
};

constexpr int longEnoughToRestart = 200; // cycles: off, on again, and all checks at start-up

class DisturbedJob : public testing::TestWithParam<Make>
{
protected:
    using Act = std::function<void(DrivenEncoder &)>;

    static std::unique_ptr<DrivenEncoder> make()
    {
        auto driven = std::make_unique<DrivenEncoder>(GetParam().key, GetParam().encoder());
        driven->tellAll();
        return driven;
    }
    static WriteParameters write() { return {GetParam().values, false, GetParam().before, false}; }
    static WriteParameters writeAndPreset() { return {GetParam().values, false, GetParam().before, true}; }

    static int lengthOf(const Job &job)
    {
        const auto driven = make();
        driven->begin(job);
        return driven->finish().value_or(0);
    }

    struct Ends
    {
        int ok = 0;
        int failed = 0;
        int cancelled = 0; // among those that failed
        int restored = 0;
        int longest = 0; // cycles of the longest job

        void add(const Outcome &outcome, int cycles)
        {
            ++(outcome.result ? ok : failed);
            cancelled += !outcome.result && outcome.result.error().id == RefusalId::cancelled ? 1 : 0;
            restored += outcome.restored ? 1 : 0;
            longest = std::max(longest, cycles);
        }
    };
    // Disturbs a new job in cycle 0, 1, 2, ..., and checks how each ends.
    static Ends atEachCycle(const Job &job, const Act &disturb, const Act &check)
    {
        const int length = lengthOf(job);
        EXPECT_GT(length, 0);
        Ends ends;
        for (int k = 0; k <= length && !HasFailure(); ++k) {
            SCOPED_TRACE("cycle " + std::to_string(k));
            const auto driven = make();
            driven->begin(job);
            driven->cycles(k);
            disturb(*driven);
            const auto rest = driven->finish();
            EXPECT_TRUE(rest) << "the job does not end";
            if (!driven->outcome())
                break;
            ends.add(*driven->outcome(), k + rest.value_or(0));
            EXPECT_EQ(driven->outcome()->leftIn, driven->state());
            driven->cycles(longEnoughToRestart);
            check(*driven);
        }
        return ends;
    }

    static void expectWrittenIfOk(DrivenEncoder &driven)
    {
        driven.expectTruth();
        if (!driven.outcome()->result)
            return;
        for (const ParameterValue &value : GetParam().values)
            EXPECT_EQ(driven.actual(value.parameter), value.value)
                << parameterKey(value.parameter).toStdString() << " although the job says it succeeded";
    }
};

const auto powerCycle = [](DrivenEncoder &driven) { driven.encoder().powerCycle(); };
const auto loseParameters = [](DrivenEncoder &driven) { driven.encoder().loseParameters(); };

TEST_P(DisturbedJob, AWriteSaysWhatTheEncoderHasAfterAPowerCycle)
{
    EXPECT_GT(atEachCycle(write(), powerCycle, expectWrittenIfOk).failed, 0);
}

TEST_P(DisturbedJob, AWriteWithPresetSaysWhatTheEncoderHasAfterAPowerCycle)
{
    EXPECT_GT(atEachCycle(writeAndPreset(), powerCycle, expectWrittenIfOk).failed, 0);
}

TEST_P(DisturbedJob, AWriteToASlowEncoderSaysWhatItHasAfterAPowerCycle)
{
    const Ends ends = atEachCycle(
        write(),
        [](DrivenEncoder &d) {
            d.encoder().setSlow(true);
            d.cycles(37);
            d.encoder().powerCycle();
        },
        expectWrittenIfOk);
    EXPECT_GT(ends.failed, 0);
}

TEST_P(DisturbedJob, AWriteDuringWhichTheParametersAreLostSaysSo)
{
    const Ends ends = atEachCycle(write(), loseParameters, [](DrivenEncoder &driven) {
        if (driven.state() != EncoderState::error) {
            expectWrittenIfOk(driven);
            return;
        }
        // The session forgets what was known when the error comes.
        if (const auto &result = driven.outcome()->result; !result) {
            EXPECT_THAT(result.error().id,
                        testing::AnyOf(RefusalId::parametersLost, RefusalId::verificationFailed));
        }
    });
    EXPECT_LE(ends.ok, 5) << "lost before the first value, or once all was read back";
}

TEST_P(DisturbedJob, AWriteToAnEncoderSwitchedOffEnds)
{
    const Ends ends = atEachCycle(
        write(), [](DrivenEncoder &driven) { driven.encoder().setPower(false); },
        [](DrivenEncoder &driven) {
            if (driven.outcome()->onlyZeroSinceRun) { // nothing more is certain, and the outcome says so
                EXPECT_TRUE(driven.outcome()->result);
                EXPECT_EQ(GetParam().key, u"baumer-gxp6w") << "without read-out";
                return;
            }
            driven.encoder().setPower(true);
            driven.cycles(longEnoughToRestart);
            expectWrittenIfOk(driven);
        });
    EXPECT_GT(ends.failed, 0);
}

TEST_P(DisturbedJob, AnEncoderThatIsSlowAtLastIsWrittenAllTheSame)
{
    const Ends ends = atEachCycle(
        write(), [](DrivenEncoder &driven) { driven.encoder().setSlow(true); },
        [](DrivenEncoder &driven) {
            EXPECT_TRUE(driven.outcome()->result);
            expectWrittenIfOk(driven);
        });
    EXPECT_GT(ends.longest, 2 * lengthOf(write())) << "it was slow";
}

class CancelledJob : public DisturbedJob
{
protected:
    static void cancelAtEachCycle(const Job &job, OnCancel how, bool slow, const Act &check)
    {
        const Ends ends = atEachCycle(
            job,
            [how, slow](DrivenEncoder &driven) {
                driven.encoder().setSlow(slow);
                driven.cycles(slow ? 30 : 0);
                driven.driver().cancel(how, Instant{});
            },
            check);
        EXPECT_GT(ends.cancelled, 0);
        EXPECT_EQ(ends.restored > 0, how == OnCancel::restorePrevious);
    }
    static void expectBefore(DrivenEncoder &driven)
    {
        driven.expectTruth();
        EXPECT_EQ(driven.state(), EncoderState::operation);
        const bool succeeded = driven.outcome()->result.has_value();
        for (const ParameterValue &value : succeeded ? GetParam().values : GetParam().before)
            EXPECT_EQ(driven.actual(value.parameter), value.value)
                << parameterKey(value.parameter).toStdString();
        EXPECT_EQ(driven.countedWrites(), driven.encoder().eepromWrites());
    }
    static void expectOperation(DrivenEncoder &driven)
    {
        driven.expectTruth();
        EXPECT_EQ(driven.state(), EncoderState::operation);
        EXPECT_EQ(driven.countedWrites(), driven.encoder().eepromWrites());
    }
    static void expectTruthOnly(DrivenEncoder &driven)
    {
        driven.expectTruth();
        EXPECT_EQ(driven.countedWrites(), driven.encoder().eepromWrites());
    }
};

TEST_P(CancelledJob, RestoresTheValuesFromBeforeAtEachCycle)
{
    cancelAtEachCycle(write(), OnCancel::restorePrevious, false, expectBefore);
}

TEST_P(CancelledJob, RestoresTheValuesFromBeforeAtEachCycleOfASlowEncoder)
{
    cancelAtEachCycle(write(), OnCancel::restorePrevious, true, expectBefore);
}

TEST_P(CancelledJob, RunsWithWhatItHasAtEachCycle)
{
    cancelAtEachCycle(write(), OnCancel::runWithWhatItHas, false, expectOperation);
}

TEST_P(CancelledJob, RunsWithWhatItHasAtEachCycleOfASlowEncoder)
{
    cancelAtEachCycle(write(), OnCancel::runWithWhatItHas, true, expectOperation);
}

TEST_P(CancelledJob, LeavesTheEncoderAsItIsAtEachCycle)
{
    cancelAtEachCycle(write(), OnCancel::leaveAsIs, false, expectTruthOnly);
}

TEST_P(CancelledJob, LeavesASlowEncoderAsItIsAtEachCycle)
{
    cancelAtEachCycle(write(), OnCancel::leaveAsIs, true, expectTruthOnly);
}

const auto nameOfMake = [](const testing::TestParamInfo<Make> &make) { return make.param.name; };
INSTANTIATE_TEST_SUITE_P(Makes, DisturbedJob, testing::ValuesIn(makes), nameOfMake);
INSTANTIATE_TEST_SUITE_P(Makes, CancelledJob, testing::ValuesIn(makes), nameOfMake);

} // namespace
} // namespace codewheel
