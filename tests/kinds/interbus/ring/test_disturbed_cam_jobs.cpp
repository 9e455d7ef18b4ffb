// SPDX-License-Identifier: GPL-3.0-or-later
// A cam job is disturbed in each of its cycles in turn. However it goes: the job ends, OUT is 0 again, what
// is known is what the encoder has, and no EEPROM write goes uncounted.
#include "cams/cam_fields.h"
#include "tests/kinds/interbus/ring/driven_encoder.h"

#include <functional>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr int camRestart = 200; // cycles

// The words are literally the manual's; the driver is not involved.
class ByHand
{
public:
    explicit ByHand(SimulatedK3 &encoder)
        : m_encoder(encoder)
    {}

    Word send(Word out, int cycles = 6)
    {
        Word in = 0;
        for (int i = 0; i < cycles; ++i)
            in = m_encoder.cycle(out);
        return in;
    }
    std::int64_t read(Word what)
    {
        const Word in = send(0x2020'0000 | what);
        EXPECT_EQ(in & 0xFE00'0000, 0xA000'0000u);
        send(0x0000'0000);
        return in & 0x01FF'FFFF;
    }
    // The encoder's present program; 0: none.
    unsigned current()
    {
        const Word startUp = send(0x2021'0009) & 0xF;
        send(0x0000'0000);
        return startUp >= 3 ? startUp - 2 : 0;
    }
    CamProgram program(unsigned number)
    {
        if (current() != number)
            send(0x2080'0000 | number);
        CamProgram program{.number = number, .cam = {}, .shift = static_cast<unsigned>(read(0x40))};
        const auto active = read(0x00);
        for (Word n = 0; n < 8; ++n)
            program.cam[n] = {read(0x10 + n), read(0x20 + n), (active >> n & 1) != 0};
        return program;
    }

private:
    SimulatedK3 &m_encoder;
};

CamProgram before(unsigned number)
{
    CamProgram program{.number = number, .cam = {}, .shift = 3};
    program.cam[0] = {100, 200, true};
    program.cam[3] = {0x100, 0x200, false};
    return program;
}

CamProgram wanted(unsigned number)
{
    CamProgram program = before(number);
    program.cam[0] = {0, 0, true}; // 40000000 and 60000000
    program.cam[3] = {0x15, 0x213, true};
    program.shift = 8;
    return program;
}

class DisturbedCams : public testing::Test
{
protected:
    using Act = std::function<void(DrivenEncoder &)>;

    static std::unique_ptr<DrivenEncoder> make()
    {
        auto driven = std::make_unique<DrivenEncoder>(u"fraba-ocd-ib", frabaK3());
        driven->begin(WriteCams{
            .programs = {before(1), before(2)}, .onlyWhatDiffers = false, .afterwards = SwitchMode{}});
        driven->finish();
        EXPECT_TRUE(driven->outcome()->result);
        return driven;
    }
    static WriteCams write(std::optional<SwitchMode> afterwards = {})
    {
        return {.programs = {wanted(1), wanted(2)}, .afterwards = afterwards};
    }

    struct Ends
    {
        int failed = 0;
        int cancelled = 0; // among those that failed
        int restored = 0;
        bool areSlow = false; // one took twice as long as undisturbed
    };
    static Ends atEachCycle(const Job &job, const Act &disturb, const Act &check)
    {
        Ends ends;
        const auto undisturbed = make();
        undisturbed->begin(job);
        const auto length = undisturbed->finish();
        EXPECT_TRUE(length);
        for (int k = 0; k <= length.value_or(-1) && !HasFailure(); ++k) {
            SCOPED_TRACE("cycle " + std::to_string(k));
            const auto driven = make();
            driven->begin(job);
            driven->cycles(k);
            disturb(*driven);
            const auto rest = driven->finish();
            EXPECT_TRUE(rest) << "the job does not end";
            if (!driven->outcome())
                break;
            const Outcome &outcome = *driven->outcome();
            ends.failed += outcome.result ? 0 : 1;
            ends.cancelled += !outcome.result && outcome.result.error().id == RefusalId::cancelled ? 1 : 0;
            ends.restored += outcome.restored ? 1 : 0;
            ends.areSlow = ends.areSlow || k + rest.value_or(0) > 2 * length.value_or(0);
            EXPECT_EQ(driven->outcome()->leftIn, driven->state());
            driven->cycles(camRestart);
            EXPECT_EQ(driven->out(), 0u);
            check(*driven);
        }
        return ends;
    }

    // Asks the encoder itself, beginning with its present program: leaving a program saves its changes.
    static void expectTruth(DrivenEncoder &driven)
    {
        EXPECT_GE(driven.countedWrites() + driven.outcome()->inDoubt.eepromWrites,
                  driven.encoder().eepromWrites());
        const auto known1 = driven.knownCams(1);
        const auto known2 = driven.knownCams(2);
        ByHand encoder(driven.encoder());
        const unsigned current = encoder.current();
        for (const unsigned number : {current == 2 ? 2u : 1u, current == 2 ? 1u : 2u}) {
            const auto &known = number == 1 ? known1 : known2;
            EXPECT_EQ(known.value_or(encoder.program(number)), encoder.program(number))
                << "program " << number;
        }
    }
    static void expectWrittenIfOk(DrivenEncoder &driven)
    {
        expectTruth(driven);
        if (!driven.outcome()->result)
            return;
        EXPECT_EQ(driven.outcome()->camsWritten, (std::vector{wanted(1), wanted(2)}));
        ByHand encoder(driven.encoder());
        for (const unsigned number : {1u, 2u})
            EXPECT_EQ(encoder.program(number), wanted(number)) << "although the job says it succeeded";
    }
    static void cancelAtEachCycle(OnCancel how, bool slow, const Act &check)
    {
        const Ends ends = atEachCycle(
            write(),
            [how, slow](DrivenEncoder &driven) {
                driven.encoder().setSlow(slow);
                driven.cycles(slow ? 30 : 0);
                driven.driver().cancel(how, Instant{});
            },
            [&check](DrivenEncoder &driven) {
                driven.encoder().setSlow(false);
                check(driven);
            });
        EXPECT_GT(ends.cancelled, 0);
        EXPECT_EQ(ends.restored > 0, how == OnCancel::restorePrevious);
    }
};

TEST_F(DisturbedCams, AWriteIsWhatTheEncoderHas)
{
    const auto driven = make();
    const int writesBefore = driven->encoder().eepromWrites();
    EXPECT_EQ(writesBefore, 2);
    driven->begin(write(SwitchMode{Mode::cam, 2}));
    ASSERT_TRUE(driven->finish());
    ASSERT_TRUE(driven->outcome()->result);
    EXPECT_EQ(driven->outcome()->camsWritten, (std::vector{wanted(1), wanted(2)}));
    EXPECT_EQ(driven->outcome()->eepromWrites, 2);
    EXPECT_EQ(driven->encoder().eepromWrites(), writesBefore + 2);
    EXPECT_EQ(driven->driver().reading().camProgram, 2u);
    driven->encoder().powerCycle();
    driven->cycles(camRestart);
    ByHand encoder(driven->encoder());
    EXPECT_EQ(encoder.program(2), wanted(2)) << "it was left, and so it is saved";
    EXPECT_EQ(encoder.program(1), wanted(1));
}

TEST_F(DisturbedCams, AReadIsWhatTheEncoderHas)
{
    const auto driven = make();
    driven->begin(ReadCams{.programs = {1, 2, 8}, .afterwards = SwitchMode{}});
    ASSERT_TRUE(driven->finish());
    EXPECT_EQ(driven->outcome()->camsRead,
              (std::vector{before(1), before(2), CamProgram{.number = 8, .cam = {}, .shift = 0}}));
    EXPECT_EQ(driven->outcome()->eepromWrites, 0);
    EXPECT_EQ(driven->driver().reading().mode, Mode::position);
}

TEST_F(DisturbedCams, ByAPowerCycle)
{
    const Ends ends = atEachCycle(
        write(SwitchMode{}), [](DrivenEncoder &driven) { driven.encoder().powerCycle(); }, expectWrittenIfOk);
    EXPECT_GT(ends.failed, 0);
}

TEST_F(DisturbedCams, ByAPowerCycleOfASlowEncoder)
{
    const Ends ends = atEachCycle(
        write(SwitchMode{}),
        [](DrivenEncoder &driven) {
            driven.encoder().setSlow(true);
            driven.cycles(37);
            driven.encoder().powerCycle();
        },
        [](DrivenEncoder &driven) {
            driven.encoder().setSlow(false);
            expectWrittenIfOk(driven);
        });
    EXPECT_GT(ends.failed, 0);
}

TEST_F(DisturbedCams, ByTheLossOfTheParameters)
{
    atEachCycle(
        write(), [](DrivenEncoder &driven) { driven.encoder().loseParameters(); },
        [](DrivenEncoder &driven) {
            EXPECT_EQ(driven.state(), EncoderState::error);
            EXPECT_FALSE(driven.knownCams(1) || driven.knownCams(2));
        });
}

TEST_F(DisturbedCams, ByAnEncoderThatIsSlowAtLast)
{
    const Ends ends = atEachCycle(
        write(), [](DrivenEncoder &driven) { driven.encoder().setSlow(true); },
        [](DrivenEncoder &driven) {
            EXPECT_TRUE(driven.outcome()->result);
            driven.encoder().setSlow(false);
            expectWrittenIfOk(driven);
        });
    EXPECT_TRUE(ends.areSlow);
}

TEST_F(DisturbedCams, NoPositionIsSetByAnyOfTheWords)
{
    atEachCycle(
        write(), [](DrivenEncoder &driven) { driven.encoder().powerCycle(); },
        [](DrivenEncoder &driven) { EXPECT_EQ(driven.actual(Parameter::zeroOffset), 0); });
}

void expectBefore(DrivenEncoder &driven)
{
    EXPECT_EQ(driven.state(), EncoderState::operation);
    const bool succeeded = driven.outcome()->result.has_value();
    ByHand encoder(driven.encoder());
    for (const unsigned number : {1u, 2u})
        EXPECT_EQ(encoder.program(number), succeeded ? wanted(number) : before(number));
}

TEST_F(DisturbedCams, ByACancelThatRestoresThePrograms)
{
    cancelAtEachCycle(OnCancel::restorePrevious, false, expectBefore);
}

TEST_F(DisturbedCams, ByACancelThatRestoresTheProgramsOfASlowEncoder)
{
    cancelAtEachCycle(OnCancel::restorePrevious, true, expectBefore);
}

TEST_F(DisturbedCams, ByACancelThatRunsWithWhatItHas)
{
    for (const bool slow : {false, true})
        cancelAtEachCycle(OnCancel::runWithWhatItHas, slow, [](DrivenEncoder &driven) {
            EXPECT_EQ(driven.state(), EncoderState::operation);
            expectTruth(driven);
        });
}

TEST_F(DisturbedCams, ByACancelThatLeavesTheEncoderAsItIs)
{
    for (const bool slow : {false, true})
        cancelAtEachCycle(OnCancel::leaveAsIs, slow, expectTruth);
}

} // namespace
} // namespace codewheel
