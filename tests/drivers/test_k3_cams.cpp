// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivers/driver_table.h"

#include <gtest/gtest.h>

// FRABA manual 5.4.4, 10.5 and 10.6, word by word.
namespace codewheel {
namespace {

constexpr Word pos = 0x0000'3039;
constexpr Word cams = 0x0030'3900; // cam mode: the position above, no cam on

class K3Cams : public testing::Test
{
protected:
    DriverTable m_table{u"fraba-ocd-ib"};

    // Enters the program and answers the configuration.
    void enter(Word program, Word configuration)
    {
        m_table.play({{0x0000'0000, pos},
                      {0x2080'0000 | program, pos},
                      {0x2080'0000 | program, pos},
                      {0x2080'0000 | program, cams}});
        answer(0x2020'0000, configuration);
    }
    void answer(Word readOut, Word value, Word otherwise = cams)
    {
        m_table.play({{readOut, otherwise}, {readOut, 0xA000'0000 | value}, {0x0000'0000, otherwise}});
    }
    // All that the encoder has of a program but the configuration, which is read first.
    void answerRest(const std::vector<std::pair<Word, Word>> &startAndStop, Word shift)
    {
        for (Word cam = 0; cam < 8; ++cam) {
            answer(0x2020'0010 | cam, startAndStop[cam].first);
            answer(0x2020'0020 | cam, startAndStop[cam].second);
        }
        answer(0x2020'0040, shift);
    }
    static std::vector<std::pair<Word, Word>> nothing() { return std::vector<std::pair<Word, Word>>(8); }
    Refusal refusal()
    {
        if (m_table.outcome() && !m_table.outcome()->result)
            return m_table.outcome()->result.error();
        ADD_FAILURE() << "the job was not refused";
        return {};
    }
};

CamProgram manualProgram()
{
    CamProgram program;
    program.cam[3] = {0x15, 0x213, true};
    return program;
}

TEST_F(K3Cams, Manual544WrittenWordByWordAndReadBack)
{
    ASSERT_TRUE(m_table.begin(WriteCams{.programs = {manualProgram()}, .afterwards = {}}));
    enter(1, 0x0000);
    answerRest(nothing(), 0);
    m_table.play({{0x4600'0015, cams},
                  {0x4600'0015, 0xC600'0015},
                  {0x6600'0213, 0xC600'0015},
                  {0x6600'0213, 0xE600'0213},
                  {0x2040'0008, 0xE600'0213},
                  {0x2040'0008, 0xE040'0008},
                  {0x8000'0000, 0xE040'0008},
                  {0x8000'0000, cams},
                  {0x0000'0000, cams}});
    answer(0x2020'0013, 0x15);
    answer(0x2020'0023, 0x213);
    answer(0x2020'0000, 0x08);
    m_table.play({{0x0000'0000, cams}});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_TRUE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->camsWritten, std::vector{manualProgram()});
    EXPECT_EQ(m_table.outcome()->camsRead, std::vector{CamProgram{}});
    EXPECT_EQ(m_table.outcome()->eepromWrites, 0) << "it is saved when it is left";
}

} // namespace
} // namespace codewheel
