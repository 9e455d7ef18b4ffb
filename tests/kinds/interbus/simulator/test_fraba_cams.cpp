// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/fraba_k3.h"

namespace codewheel {
namespace {

class CamMode : public testing::Test
{
protected:
    Word at(std::int64_t raw)
    {
        m_encoder.turnTo(raw);
        return m_encoder.cycle(0);
    }
    Word readOut(Word out) { return send(m_encoder, {0x0000'0000, out}); }

    FrabaK3 m_encoder{{8192, 4096}, 0x100, {}};
};

// FRABA manual 5.4.4: cam 3 on from 15h to 213h in program 1
TEST_F(CamMode, Manual544Cam3From15hTo213h)
{
    play(m_encoder, {
                        {0x0000'0000, 0x0000'0100},    {0x2080'0001, 0x0000'0100, 2},
                        {0x2080'0001, 0x0001'0000, 2}, // cam mode at once: no cam, position above
                        {0x4600'0015, 0x0001'0000, 2}, {0x4600'0015, 0xC600'0015, 3},
                        {0x6600'0213, 0xC600'0015, 2}, {0x6600'0213, 0xE600'0213, 3},
                        {0x2040'0008, 0xE600'0213, 2}, {0x2040'0008, 0xE040'0008, 3},
                        {0x8000'0000, 0xE040'0008},    {0x8000'0000, 0x0001'0008, 2},
                        {0x2020'0013, 0x0001'0008, 2}, {0x2020'0013, 0xA000'0015, 3},
                        {0x2020'0023, 0xA000'0015, 2}, {0x2020'0023, 0xA000'0213, 3},
                        {0x2020'0000, 0xA000'0213, 2}, {0x2020'0000, 0xA000'0008, 3},
                        {0x0000'0000, 0xA000'0008},    {0x0000'0000, 0x0001'0008, 2},
                    });
}

TEST_F(CamMode, ACamIsOnFromStartToStopInclusive)
{
    send(m_encoder, {0x2080'0001, 0x4600'0015, 0x6600'0213, 0x2040'0008, 0x8000'0000, 0x0000'0000});
    EXPECT_EQ(at(0x14), 0x0000'1400);
    EXPECT_EQ(at(0x15), 0x0000'1508);
    EXPECT_EQ(at(0x213), 0x0002'1308);
    EXPECT_EQ(at(0x214), 0x0002'1400);
}

TEST_F(CamMode, StartBehindStopWrapsThroughZero)
{
    send(m_encoder, {0x2080'0002, 0x4000'0213, 0x6000'0015, 0x2040'0001, 0x8000'0000, 0x0000'0000});
    EXPECT_EQ(at(0), 0x0000'0001);
    EXPECT_EQ(at(0x15), 0x0000'1501);
    EXPECT_EQ(at(0x16), 0x0000'1600);
    EXPECT_EQ(at(0x213), 0x0002'1301);
    EXPECT_EQ(at(0x1FF'FFFF), 0x01FF'FF01); // 17 bits of the position
}

TEST_F(CamMode, OnlyActiveCamsShow)
{
    send(m_encoder, {0x2080'0001, 0x6E00'1000, 0x6000'1000, 0x2040'8180, 0x8000'0000, 0x0000'0000});
    EXPECT_EQ(at(0x10), 0x0000'1080);             // cam 0 is not active, bits 8..15 do nothing
    EXPECT_EQ(readOut(0x2020'0000), 0xA000'8180); // and are kept
}

TEST_F(CamMode, ShiftChoosesTheBitsOfThePosition)
{
    send(m_encoder, {0x2080'0001, 0x2010'0008, 0x8000'0000, 0x0000'0000});
    EXPECT_EQ(at(0x123'4567), 0x0123'4500);
    EXPECT_EQ(readOut(0x2020'0040), 0xA000'0008);
    EXPECT_EQ(send(m_encoder, {0x2010'0019}), 0xE010'0019);
    send(m_encoder, {0x8000'0000, 0x0000'0000});
    EXPECT_EQ(at(0x1FF'FFFF), 0x0000'0000); // cams only
}

struct ErrorRow
{
    Word out;
    Word in;
};

// FRABA manual 10.6, instead of the acknowledgement; the old value is kept
TEST_F(CamMode, Manual106Errors)
{
    send(m_encoder, {0x0200'0100, 0x8000'0000, 0x0000'0000}); // 256 x 4096 = 100000h
    send(m_encoder, {0x2080'0001, 0x4200'0055, 0x8000'0000, 0x0000'0000});
    const ErrorRow rows[] = {
        {0x2080'0009, 0x8200'0000}, {0x2080'000F, 0x8200'0000}, {0x2010'001A, 0x8200'0000},
        {0x0200'00FF, 0x8400'0000}, {0x0E00'0000, 0x8400'0000}, {0x1E00'0001, 0x8400'0000},
        {0x5000'0000, 0x8400'0000}, {0x7E00'0000, 0x8400'0000}, {0x2080'0010, 0x8400'0000},
        {0x2000'0001, 0x8400'0000}, {0x2200'0000, 0x8400'0000}, {0x4210'0000, 0x9800'0004},
        {0x6210'0000, 0x9800'0004}, {0x43FF'FFFF, 0x9800'0004},
    };
    for (const ErrorRow &row : rows) {
        EXPECT_EQ(hex8(send(m_encoder, {row.out})), hex8(row.in)) << hex8(row.out);
        EXPECT_EQ(hex8(send(m_encoder, {0x0000'0000, 0x8000'0000})), "00000800") << hex8(row.out);
        EXPECT_EQ(hex8(readOut(0x2020'0011)), "A0000055") << hex8(row.out);
    }
    EXPECT_EQ(hex8(send(m_encoder, {0x420F'FFFF})), "C20FFFFF"); // the largest position
}

TEST_F(CamMode, UndefinedReadOutsAreAnsweredAsUnknown)
{
    send(m_encoder, {0x2080'0001});
    for (const Word what : {0x0001u, 0x0018u, 0x0028u, 0x0030u, 0x0041u, 0x0100u})
        EXPECT_EQ(hex8(readOut(0x2020'0000 | what)), hex8(0xA400'0000 | what));
    EXPECT_EQ(hex8(readOut(0x2021'0001)), "A0002000"); // the parameters can be read here too
}

TEST_F(CamMode, ReadOutWorksInsideTheCamParameterization)
{
    send(m_encoder, {0x2080'0001, 0x4600'0015});
    play(m_encoder, {{0x2020'0013, 0xC600'0015, 2},
                     {0x2020'0013, 0xA000'0015},
                     {0x0000'0000, 0xA000'0015},
                     {0x0000'0000, 0xC600'0015}});
}

// The previous content stays in IN until the cam word is acknowledged: the cams, or the last acknowledgement.
TEST_F(CamMode, ASlowEncoderTakesItsTimeToAcknowledge)
{
    send(m_encoder, {0x2080'0001});
    m_encoder.setSlow(true);
    play(m_encoder, {{0x4600'0015, 0x0001'0000, 102},
                     {0x4600'0015, 0xC600'0015, 3},
                     {0x2040'0008, 0xC600'0015, 102},
                     {0x2040'0008, 0xE040'0008, 3},
                     {0x2010'001A, 0xE040'0008, 102},
                     {0x2010'001A, 0x8200'0000, 3}});
}

TEST_F(CamMode, ASlowEncoderGoesOnWithAWordThatHasLeftOut)
{
    send(m_encoder, {0x2080'0001});
    m_encoder.setSlow(true);
    play(m_encoder, {{0x4600'0015, 0x0001'0000, 3},
                     {0x0000'0000, 0x0001'0000, 99},
                     {0x0000'0000, 0xC600'0015, 3},
                     {0x8000'0000, 0xC600'0015},
                     {0x8000'0000, 0x0001'0000}});
    m_encoder.setSlow(false);
    EXPECT_EQ(readOut(0x2020'0013), 0xA000'0015);
}

// The same words have other meanings in position mode.
TEST_F(CamMode, PresetAndVelocityWordsMeanCams)
{
    send(m_encoder, {0x0800'0064, 0x8000'0000, 0x0000'0000, 0x2080'0001});
    EXPECT_EQ(hex8(send(m_encoder, {0x4000'0000})), "C0000000");
    EXPECT_EQ(hex8(send(m_encoder, {0x6000'0000})), "E0000000");
    EXPECT_EQ(hex8(send(m_encoder, {0x2040'0001})), "E0400001");
    EXPECT_EQ(hex8(send(m_encoder, {0x2040'0000})), "E0400000");
    EXPECT_EQ(hex8(send(m_encoder, {0x8000'0000, 0x2080'0000, 0x0000'0000})),
              "00000100"); // no preset was set
    EXPECT_EQ(hex8(readOut(0x2021'0006)), "A0000001");
}

TEST_F(CamMode, ChangingTheProgramSavesTheOldOneWithOneWriteAndEndsTheParameterization)
{
    send(m_encoder, {0x2080'0001, 0x4600'0015});
    EXPECT_EQ(m_encoder.eepromWrites(), 0);
    play(m_encoder, {{0x2080'0002, 0xC600'0015, 2}, {0x2080'0002, 0x0001'0000, 2}});
    EXPECT_EQ(m_encoder.eepromWrites(), 1);
    EXPECT_EQ(readOut(0x2020'0013), 0xA000'0000);
    EXPECT_EQ(readOut(0x2021'0009), 0xA000'0004); // start-up mode: cam program 2
    send(m_encoder, {0x0000'0000, 0x2080'0001});
    EXPECT_EQ(m_encoder.eepromWrites(), 1); // nothing was changed
    EXPECT_EQ(readOut(0x2020'0013), 0xA000'0015);
}

TEST_F(CamMode, ChangingTheProgramDoesNotEndAParameterizationOfTheEncoder)
{
    EXPECT_EQ(send(m_encoder, {0x0200'00FF, 0x2080'0001, 0x2080'0002}), 0xC200'00FF);
    EXPECT_EQ(send(m_encoder, {0x8000'0000}), 0x0000'0700); // floor(256 x 255 / 8192) = 7
    m_encoder.loseParameters();
    EXPECT_EQ(send(m_encoder, {0x2080'0001, 0x2080'0002}), 0x8600'0000);
}

TEST_F(CamMode, AProgramNotLeftIsLostAtPowerOff)
{
    send(m_encoder, {0x2080'0001, 0x4600'0015, 0x8000'0000, 0x2080'0001, 0x4600'0016, 0x8000'0000});
    m_encoder.setPower(false);
    m_encoder.setPower(true);
    EXPECT_EQ(m_encoder.cycle(0), 0x0001'0000); // still cam mode
    EXPECT_EQ(readOut(0x2020'0013), 0xA000'0015);
    EXPECT_EQ(readOut(0x2021'0009), 0xA000'0003);
}

TEST_F(CamMode, DefaultSwitchesTheCamsOff)
{
    send(m_encoder,
         {0x2080'0001, 0x4600'0015, 0x2040'0008, 0x8000'0000, 0x2080'0000, 0x0E00'0000, 0x8000'0000});
    send(m_encoder, {0x0000'0000, 0x2080'0001});
    EXPECT_EQ(readOut(0x2020'0013), 0xA000'0000);
    EXPECT_EQ(readOut(0x2020'0000), 0xA000'0000);
}

TEST_F(CamMode, LostParametersEndTheCamMode)
{
    send(m_encoder, {0x2080'0001, 0x0000'0000});
    m_encoder.loseParameters();
    EXPECT_EQ(hex8(send(m_encoder, {0x0E00'0000})), "CE000000");
    EXPECT_EQ(hex8(send(m_encoder, {0x8000'0000})), "00000100");
}

TEST_F(CamMode, ShowsNothingValidAbove800Kilohertz)
{
    send(m_encoder, {0x2080'0001, 0x0000'0000});
    m_encoder.setSpeed(6000);
    EXPECT_EQ(hex8(m_encoder.cycle(0)), "80000000");
}

} // namespace
} // namespace codewheel
