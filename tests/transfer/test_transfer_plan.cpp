// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/step_text.h"
#include "jobs/write_plan.h"
#include "tests/support/places.h"
#include "tests/transfer/transfer_bus.h"
#include "transfer/transfer_words.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::onLoop;
using test::singleTurn;

class TransferPlanning : public test::TransferBus
{
protected:
    // Why nothing is written to the plan's only encoder.
    std::string hindrance(const TransferWish &wish)
    {
        const TransferPlan plan = planTransfer(buses, {wish});
        EXPECT_TRUE(jobsOf(plan).empty() || !plan[0].hindrance);
        return plan[0].hindrance ? refusalText(*plan[0].hindrance).toStdString() : std::string();
    }
};

const ParameterValues steps100 = {{Parameter::steps, 100}};

TEST_F(TransferPlanning, ShowsEachValueWithItsWordInTheOrderOfTheDevice)
{
    encoder(baumer).tell(Parameter::coding, 6);
    const TransferPlan plan = planTransfer(
        buses, {{.place = baumer, .values = {{Parameter::coding, 6}, {Parameter::steps, 4096}}}});
    ASSERT_EQ(plan[0].write.rows.size(), 2u);
    EXPECT_EQ(plan[0].device, QStringLiteral("Baumer GXP6W K3"));
    EXPECT_EQ(plan[0].write.rows[0].wanted.parameter, Parameter::steps);
    EXPECT_EQ(sentText(plan[0].write.rows[0].step.value()), QStringLiteral("02001000"));
    EXPECT_FALSE(plan[0].write.rows[0].known);
    EXPECT_TRUE(plan[0].write.rows[1].isThere); // it cannot be read: what was told counts
    EXPECT_EQ(plan[0].eepromWrites, 1);
    EXPECT_FALSE(plan[0].write.job.onlyWhatDiffers);
}

TEST_F(TransferPlanning, TellsWhyAnEncoderCannotBeWritten)
{
    EXPECT_EQ(hindrance({.place = "9.0"_ring, .values = steps100}),
              "9.0 is not in the ring: its segment is switched off, or a fault lies before it.");
    EXPECT_EQ(hindrance({.place = fraba, .deviceCode = 0x0236, .values = steps100}),
              "1.0: configured is K2, make not known, found was FRABA OCD-IB K3. Compare, and take over what "
              "is right.");
    EXPECT_EQ(hindrance({.place = fraba,
                         .deviceCode = 0x0237,
                         .deviceKey = QStringLiteral("baumer-gxp6w"),
                         .values = steps100}),
              "1.0: configured is Baumer GXP6W K3, found was FRABA OCD-IB K3. Compare, and take over what is "
              "right.");
    EXPECT_EQ(hindrance({.place = "6.0"_ring, .deviceCode = 0x0237, .values = steps100}),
              "6.0: configured is K3, make not known, found was bus terminal. Compare, and take over what is "
              "right.");
    EXPECT_EQ(hindrance({.place = singleTurn, .values = steps100}),
              "The FRABA OCD-IB K1 cannot be parameterized over the bus.");
    EXPECT_EQ(hindrance({.place = baumer, .values = {{Parameter::revolutions, 4097}}}),
              "Revolutions = 4097 is out of range. Give a value from 1 to 4096.");
    EXPECT_EQ(hindrance({.place = baumer, .values = {{Parameter::direction, 3}}}),
              "The Baumer GXP6W K3 does not have the parameter \"Direction\". Leave it out, or check which "
              "encoder it is.");
    EXPECT_EQ(hindrance({.place = baumer, .values = steps100, .cams = {CamProgram{}}}),
              "The Baumer GXP6W K3 has no cams.");
    EXPECT_EQ(hindrance({.place = baumer}), ""); // nothing is wanted of it
    EXPECT_EQ(hindrance({.place = baumer, .values = steps100}), "");
    bus.setOperate(false);
    bus.advance(2);
    EXPECT_EQ(hindrance({.place = baumer, .values = steps100}),
              "Nothing was sent to 2.0: the program only watches. Switch to Operate first.");
}

TEST_F(TransferPlanning, AnEncoderThatHasLostItsParametersGetsAllOrNothing)
{
    training.controls->setFault(TrainingFault::parametersLost, fraba.node, 1);
    bus.advance(50);
    EXPECT_EQ(
        hindrance({.place = fraba, .values = steps100, .position = 12'345}),
        "The encoder has lost its parameters, and works again only with all of parameters 1 to 4. Without "
        "a value: revolutions, direction. Give them one; nothing is sent before.");
    EXPECT_NE(hindrance({.place = fraba, .toPositionMode = true}), "") << "it takes no other word";
    EXPECT_EQ(hindrance({.place = fraba,
                         .values = {{Parameter::steps, 100},
                                    {Parameter::revolutions, 1},
                                    {Parameter::direction, 3},
                                    {Parameter::preset, 0}}}),
              "");
}

TEST_F(TransferPlanning, SaysThatThePositionJumps)
{
    encoder(baumer).tell(Parameter::steps, 255);
    const TransferPlan plan = planTransfer(buses, {{.place = baumer, .values = steps100}});
    EXPECT_TRUE(transfer_words::notes(plan[0]).join(u'\n').contains(
        QStringLiteral("With another scaling the position tells another place")));
}

TEST_F(TransferPlanning, AZeroOffsetIsLeftOutWhereThePositionIsSet)
{
    const ParameterValues values{{Parameter::steps, 4096}, {Parameter::zeroOffset, 30}};
    const TransferPlan plan = planTransfer(buses, {{.place = baumer, .values = values, .position = 500}});
    EXPECT_FALSE(valueOf(plan[0].write.job.values, Parameter::zeroOffset));
    EXPECT_TRUE(transfer_words::notes(plan[0]).join(u'\n').contains(
        QStringLiteral("the wanted one, 30, is left out")));
    const TransferPlan without = planTransfer(buses, {{.place = baumer, .values = values}});
    EXPECT_EQ(valueOf(without[0].write.job.values, Parameter::zeroOffset), 30);
}

TEST_F(TransferPlanning, ACloneTakesTheValuesButNotTheZeroOffset)
{
    encoder(fraba).tell(Parameter::steps, 255);
    encoder(fraba).tell(Parameter::zeroOffset, 12);
    encoder(fraba).tell(Parameter::serialNumber, 20417);
    const TransferWish wish = wishToClone(encoder(fraba), encoder(onLoop), true);
    EXPECT_FALSE(wish.hindrance);
    EXPECT_EQ(wish.values, (ParameterValues{{Parameter::steps, 255}}));
    EXPECT_EQ(hindrance(wishToClone(encoder(fraba), encoder(baumer), true)),
              "1.0 (FRABA OCD-IB K3) and 2.0 (Baumer GXP6W K3) are not the same kind of encoder. Choose "
              "encoders of one kind.");
}

TEST_F(TransferPlanning, AnEncoderThatIsBusyIsLeftAlone)
{
    ASSERT_TRUE(encoder(fraba).start(ReadParameters{{Parameter::steps}}));
    EXPECT_EQ(planTransfer(buses, {{.place = fraba, .values = steps100}})[0].hindrance->id,
              RefusalId::jobRunning);
}

} // namespace
} // namespace codewheel
