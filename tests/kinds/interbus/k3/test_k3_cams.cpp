// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_refusals.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

// FRABA manual 5.4.4, 10.5 and 10.6, word by word.
namespace codewheel {
namespace {

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
                      {0x2080'0000 | program, posInCamMode}});
        answer(0x2020'0000, configuration);
    }
    void answer(Word readOut, Word value, Word otherwise = posInCamMode)
    {
        m_table.play({{readOut, otherwise}, {readOut, 0xA000'0000 | value}, {0x0000'0000, otherwise}});
    }
    // Answers everything the encoder has of a program except the configuration, which is read first.
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
    m_table.play({{0x4600'0015, posInCamMode},
                  {0x4600'0015, 0xC600'0015},
                  {0x6600'0213, 0xC600'0015},
                  {0x6600'0213, 0xE600'0213},
                  {0x2040'0008, 0xE600'0213},
                  {0x2040'0008, 0xE040'0008},
                  {0x8000'0000, 0xE040'0008},
                  {0x8000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    answer(0x2020'0013, 0x15);
    answer(0x2020'0023, 0x213);
    answer(0x2020'0000, 0x08);
    m_table.play({{0x0000'0000, posInCamMode}});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_TRUE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->camsWritten, std::vector{manualProgram()});
    EXPECT_EQ(m_table.outcome()->camsRead, std::vector{CamProgram{}});
    EXPECT_EQ(m_table.outcome()->eepromWrites, 0) << "it is saved when it is left";
}

TEST_F(K3Cams, WhatTheEncoderHasIsNotWrittenAgain)
{
    ASSERT_TRUE(m_table.begin(WriteCams{.programs = {manualProgram()}, .afterwards = {}}));
    enter(1, 0xFF08); // bits 8..15 belong to no cam
    auto values = nothing();
    values[3] = {0x15, 0x213};
    answerRest(values, 0);
    m_table.play({{0x0000'0000, posInCamMode}});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_TRUE(m_table.outcome()->result);
    EXPECT_TRUE(m_table.outcome()->camsWritten.empty());
    EXPECT_EQ(m_table.outcome()->camsRead, std::vector{manualProgram()});
}

// 40000000 would initialise the preset outside cam mode: it never opens the parameterization.
TEST_F(K3Cams, NoWordThatMeansSomethingElseInPositionModeOpensTheParameterization)
{
    CamProgram wanted;
    wanted.cam[0] = {0, 0, true};
    ASSERT_TRUE(m_table.begin(WriteCams{.programs = {wanted}, .afterwards = {}}));
    enter(1, 0x0000);
    auto values = nothing();
    values[0] = {0x10, 0x20};
    answerRest(values, 5);
    m_table.play({{0x2010'0000, posInCamMode}, // it differs, but would come last
                  {0x2010'0000, 0xE010'0000},
                  {0x4000'0000, 0xE010'0000},
                  {0x4000'0000, 0xC000'0000},
                  {0x6000'0000, 0xC000'0000},
                  {0x6000'0000, 0xE000'0000},
                  {0x2040'0001, 0xE000'0000},
                  {0x2040'0001, 0xE040'0001},
                  {0x8000'0000, 0xE040'0001},
                  {0x8000'0000, posInCamMode}});
}

// Not in cam mode after all, e.g. another make: only the question was sent, and its error is ended.
TEST_F(K3Cams, AnEncoderThatDoesNotAnswerAReadOutOfCamsGetsNoCamWord)
{
    ASSERT_TRUE(m_table.begin(WriteCams{.programs = {manualProgram()}, .afterwards = {}}));
    m_table.play({{0x0000'0000, pos},
                  {0x2080'0001, pos},
                  {0x2080'0001, pos},
                  {0x2080'0001, pos},
                  {0x2020'0000, pos},
                  {0x2020'0000, 0x8400'0000},
                  {0x0000'0000, 0x8400'0000},
                  {0x8000'0000, 0x8400'0000},
                  {0x8000'0000, pos},
                  {0x0000'0000, pos},
                  {0x0000'0000, pos}});
    EXPECT_EQ(refusal(), (Refusal{RefusalKind::device,
                                  WordRefusalId::readOutUnknown,
                                  {Word{0x2020'0000}, Word{0x8400'0000}}}));
    EXPECT_EQ(m_table.driver().reading().mode, std::nullopt);
}

TEST_F(K3Cams, AnEncoderThatIsSilentGetsNoCamWord)
{
    DriverTable table(u"fraba-ocd-ib", {.settle = Instant{0}, .timeOut = std::chrono::milliseconds(10)});
    ASSERT_TRUE(table.begin(WriteCams{.programs = {manualProgram()}, .afterwards = {}}));
    table.play({{0x0000'0000, pos}});
    table.repeat(3, {0x2080'0001, pos});
    table.repeat(10, {0x2020'0000, pos});
    table.repeat(3, {0x0000'0000, pos});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::noAnswer);
}

struct CamErrorRow
{
    const char *name;
    CamProgram program;
    Word out; // the refused one, the first to be sent
    Word in;
    RefusalCode id;
    std::vector<RefusalArgument> arguments;
};

class K3CamError : public testing::TestWithParam<CamErrorRow>
{};

CamProgram with(std::size_t cam, Cam values, unsigned shift = 0)
{
    CamProgram program{.number = 1, .cam = {}, .shift = shift};
    program.cam[cam] = values;
    return program;
}

// FRABA manual 10.6, instead of the acknowledgement
INSTANTIATE_TEST_SUITE_P(Manual106, K3CamError,
                         testing::Values(CamErrorRow{"startAbove",
                                                     with(2, {9000, 0, false}),
                                                     0x4400'2328,
                                                     0x9800'0004,
                                                     WordRefusalId::camPositionAboveRange,
                                                     {std::int64_t{2}, Word{0x9800'0004}}},
                                         CamErrorRow{"stopAbove",
                                                     with(7, {0, 9000, false}),
                                                     0x6E00'2328,
                                                     0x9800'0004,
                                                     WordRefusalId::camPositionAboveRange,
                                                     {std::int64_t{7}, Word{0x9800'0004}}},
                                         CamErrorRow{"wrongData",
                                                     with(0, {}, 25),
                                                     0x2010'0019,
                                                     0x8200'0000,
                                                     WordRefusalId::camWordRefused,
                                                     {Word{0x2010'0019}, Word{0x8200'0000}}},
                                         CamErrorRow{"wrongCommand",
                                                     with(5, {1, 0, false}),
                                                     0x4A00'0001,
                                                     0x8400'0000,
                                                     WordRefusalId::camWordRefused,
                                                     {Word{0x4A00'0001}, Word{0x8400'0000}}},
                                         CamErrorRow{"parametersLost",
                                                     with(5, {1, 0, false}),
                                                     0x4A00'0001,
                                                     0x8600'0000,
                                                     WordRefusalId::lostInCamMode,
                                                     {Word{0x8600'0000}}},
                                         CamErrorRow{"anotherOfTheManufacturer",
                                                     with(5, {1, 0, false}),
                                                     0x4A00'0001,
                                                     0x9800'0007,
                                                     RefusalId::manufacturerError,
                                                     {std::int64_t{7}, Word{0x9800'0007}}}),
                         [](const auto &row) { return row.param.name; });

TEST_P(K3CamError, IsNamedAndStopsTheJob)
{
    const CamErrorRow &row = GetParam();
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(WriteCams{.programs = {row.program}, .afterwards = {}}));
    table.play({{0x0000'0000, pos}});
    table.repeat(2, {0x2080'0001, pos});
    table.play({{0x2080'0001, posInCamMode}});
    std::vector<Word> readOuts{0x2020'0000};
    for (Word cam = 0; cam < 8; ++cam)
        readOuts.insert(readOuts.end(), {0x2020'0010 | cam, 0x2020'0020 | cam});
    readOuts.push_back(0x2020'0040);
    for (const Word readOut : readOuts)
        table.play({{readOut, posInCamMode}, {readOut, 0xA000'0000}, {0x0000'0000, posInCamMode}});
    table.play({{row.out, posInCamMode}, {row.out, row.in}, {0x0000'0000, row.in}, {0x0000'0000, row.in}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error(), (Refusal{RefusalKind::device, row.id, row.arguments}));
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::error);
}

TEST_F(K3Cams, AProgramThatReadsBackDifferentlyEndsTheJob)
{
    ASSERT_TRUE(m_table.begin(WriteCams{
        .programs = {with(0, {1, 0, false}), {.number = 2, .cam = {}, .shift = 0}}, .afterwards = {}}));
    enter(1, 0x0000);
    answerRest(nothing(), 0);
    m_table.play({{0x4000'0001, posInCamMode},
                  {0x4000'0001, 0xC000'0001},
                  {0x8000'0000, 0xC000'0001},
                  {0x8000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    answer(0x2020'0010, 0x02);
    m_table.play({{0x0000'0000, posInCamMode}, {0x0000'0000, posInCamMode}});
    EXPECT_EQ(refusal(),
              (Refusal{RefusalKind::device, WordRefusalId::camVerificationFailed, {std::int64_t{1}}}));
    EXPECT_TRUE(m_table.outcome()->camsWritten.empty());
}

TEST_F(K3Cams, LeavingAChangedProgramIsOneEepromWrite)
{
    ASSERT_TRUE(m_table.begin(
        WriteCams{.programs = {with(0, {1, 0, false})}, .afterwards = SwitchMode{Mode::position}}));
    enter(1, 0x0000);
    answerRest(nothing(), 0);
    m_table.play({{0x4000'0001, posInCamMode},
                  {0x4000'0001, 0xC000'0001},
                  {0x8000'0000, 0xC000'0001},
                  {0x8000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    answer(0x2020'0010, 0x01);
    EXPECT_EQ(m_table.eepromWrites(), 0);
    m_table.play({{0x2080'0000, posInCamMode},
                  {0x2080'0000, posInCamMode},
                  {0x2080'0000, pos},
                  {0x0000'0000, pos},
                  {0x0000'0000, pos}});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_TRUE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->eepromWrites, 1);
    EXPECT_EQ(m_table.driver().reading().position, pos);
    ASSERT_TRUE(m_table.cams(1));
    EXPECT_EQ(m_table.cams(1)->program, with(0, {1, 0, false}));
}

// The encoder's present program comes first and is not entered again, since that would save it.
TEST_F(K3Cams, TheProgramTheEncoderIsInIsReadFirst)
{
    m_table.repeat(3, {0x0000'0000, pos});
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::cam, 3}));
    m_table.play({{0x0000'0000, pos},
                  {0x2080'0003, pos},
                  {0x2080'0003, pos},
                  {0x2080'0003, posInCamMode},
                  {0x0000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    EXPECT_EQ(m_table.driver().reading().camProgram, 3u);
    EXPECT_EQ(m_table.driver().reading().cams, (Reading::Cams{0x00, 0x3039}));
    EXPECT_EQ(m_table.driver().reading().position, std::nullopt);

    ASSERT_TRUE(m_table.begin(ReadCams{.programs = {1, 3}, .afterwards = SwitchMode{Mode::cam, 3}}));
    m_table.play({{0x0000'0000, posInCamMode}});
    for (const Word program : {3u, 1u}) {
        if (program == 1)
            m_table.repeat(3, {0x2080'0001, posInCamMode});
        answer(0x2020'0000, program);
        answerRest(nothing(), 0);
    }
    m_table.repeat(3, {0x2080'0003, posInCamMode});
    m_table.repeat(2, {0x0000'0000, posInCamMode});
    ASSERT_TRUE(m_table.outcome());
    ASSERT_EQ(m_table.outcome()->camsRead.size(), 2u);
    EXPECT_EQ(m_table.outcome()->camsRead[0],
              (CamProgram{.number = 3, .cam = {{{0, 0, true}, {0, 0, true}}}, .shift = 0}));
    EXPECT_EQ(m_table.outcome()->eepromWrites, 0);
}

TEST_F(K3Cams, BadInputIsRefusedAndNothingIsSent)
{
    m_table.tell(Parameter::steps, 8192);
    m_table.tell(Parameter::revolutions, 4096); // x 4096 turns: positions 0..8191
    struct Row
    {
        Job job;
        RefusalCode id;
        std::vector<RefusalArgument> arguments;
    };
    const SwitchMode programNine{Mode::cam, 9};
    const Row rows[] = {
        {ReadCams{.programs = {}, .afterwards = {}}, RefusalId::nothingToDo, {}},
        {ReadCams{.programs = {0}, .afterwards = {}},
         RefusalId::camProgramOutOfRange,
         {std::int64_t{0}, std::int64_t{8}}},
        {ReadCams{.programs = {1, 9}, .afterwards = {}},
         RefusalId::camProgramOutOfRange,
         {std::int64_t{9}, std::int64_t{8}}},
        {ReadCams{.programs = {1, 1}, .afterwards = {}}, RefusalId::camProgramGivenTwice, {std::int64_t{1}}},
        {ReadCams{.programs = {1}, .afterwards = programNine},
         RefusalId::camProgramOutOfRange,
         {std::int64_t{9}, std::int64_t{8}}},
        {WriteCams{.programs = {}, .afterwards = {}}, RefusalId::nothingToDo, {}},
        {WriteCams{.programs = {{}, {}}, .afterwards = {}},
         RefusalId::camProgramGivenTwice,
         {std::int64_t{1}}},
        {WriteCams{.programs = {with(4, {8191, 8192, false})}, .afterwards = {}},
         RefusalId::camPositionTooLarge,
         {std::int64_t{4}, std::int64_t{8192}, std::int64_t{8191}}},
        {WriteCams{.programs = {with(2, {1, 2, true, 3})}, .afterwards = {}},
         RefusalId::camHasMore,
         {std::int64_t{2}}},
        {WriteCams{.programs = {with(0, {}, 26)}, .afterwards = {}},
         RefusalId::camShiftOutOfRange,
         {std::int64_t{26}}},
        {SwitchMode{Mode::cam, 0}, RefusalId::camProgramOutOfRange, {std::int64_t{0}, std::int64_t{8}}},
        {programNine, RefusalId::camProgramOutOfRange, {std::int64_t{9}, std::int64_t{8}}},
    };
    for (const Row &row : rows) {
        const auto begun = m_table.begin(row.job);
        ASSERT_FALSE(begun);
        EXPECT_EQ(begun.error(), (Refusal{RefusalKind::badInput, row.id, row.arguments}));
        m_table.repeat(3, {0x0000'0000, pos});
    }
}

TEST_F(K3Cams, AnEncoderWithoutCamsHasNone)
{
    DriverTable baumer(u"baumer-gxp6w");
    for (const Job &job : {Job{ReadCams{.programs = {1}, .afterwards = {}}},
                           Job{WriteCams{.programs = {{}}, .afterwards = {}}}, Job{SwitchMode{Mode::cam, 1}}})
        EXPECT_EQ(baumer.begin(job).error().id, RefusalId::camsNotSupported);
}

// 2080000p would end it, and what it sets is not known.
TEST_F(K3Cams, AParameterizationThatIsNoneOfCamsIsLeftAlone)
{
    m_table.play({{0x0000'0000, 0xC200'00FF}});
    const auto begun = m_table.begin(ReadCams{.programs = {1}, .afterwards = {}});
    ASSERT_FALSE(begun);
    EXPECT_EQ(begun.error().id, RefusalId::inParameterization);
}

// In cam mode as far as we know, yet in a parameterization that is not about cams: run would put into effect
// what somebody else has sent.
TEST_F(K3Cams, NoRunIsSentIntoAParameterizationOfOthers)
{
    m_table.tell(Parameter::startUpMode, 3); // cam program 1
    m_table.play({{0x0000'0000, 0xC200'00FF}});
    ASSERT_TRUE(m_table.begin(ReadCams{.programs = {1}, .afterwards = {}}));
    m_table.play({{0x0000'0000, 0xC200'00FF},
                  {0x2020'0000, 0xC200'00FF},
                  {0x2020'0000, 0x8400'0000},
                  {0x0000'0000, 0x8400'0000},
                  {0x0000'0000, 0x8400'0000},
                  {0x0000'0000, 0x8400'0000}});
    EXPECT_EQ(refusal(), (Refusal{RefusalKind::device,
                                  WordRefusalId::camsInParameterization,
                                  {Word{0x2020'0000}, Word{0x8400'0000}}}));
    EXPECT_EQ(m_table.outcome()->leftIn, EncoderState::error);
    EXPECT_EQ(m_table.outcome()->eepromWrites, 0);
    EXPECT_EQ(m_table.driver().reading().mode, std::nullopt) << "it is not in cam mode after all";
}

TEST_F(K3Cams, RestoredCamsAreReadBack)
{
    ASSERT_TRUE(m_table.begin(WriteCams{.programs = {manualProgram()}, .afterwards = {}}));
    enter(1, 0x0000);
    answerRest(nothing(), 0);
    m_table.play({{0x4600'0015, posInCamMode}, {0x4600'0015, 0xC600'0015}, {0x6600'0213, 0xC600'0015}});
    m_table.driver().cancel(OnCancel::restorePrevious, Instant{});
    m_table.play({{0x6600'0213, 0xE600'0213}, {0x0000'0000, 0xE600'0213}});
    answer(0x2020'0000, 0x00, 0xE600'0213);
    m_table.play({{0x4600'0000, 0xE600'0213},
                  {0x4600'0000, 0xC600'0000},
                  {0x6600'0000, 0xE600'0000},
                  {0x8000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    answer(0x2020'0013, 0x00);
    answer(0x2020'0023, 0x00);
    m_table.play({{0x0000'0000, posInCamMode}});
    EXPECT_EQ(refusal().id, RefusalId::cancelled);
    EXPECT_EQ(m_table.outcome()->restored, Evidence::read);
    EXPECT_EQ(m_table.outcome()->camsWritten, std::vector{CamProgram{}});
}

TEST_F(K3Cams, APowerLossInTheParameterizationIsNoticedBeforeTheNextWord)
{
    ASSERT_TRUE(m_table.begin(WriteCams{.programs = {manualProgram()}, .afterwards = {}}));
    enter(1, 0x0000);
    answerRest(nothing(), 0);
    m_table.play({{0x4600'0015, posInCamMode},
                  {0x4600'0015, 0xC600'0015},
                  {0x6600'0213, 0x0000'0000}, // no power
                  {0x0000'0000, 0x0000'0000},
                  {0x0000'0000, posInCamMode}});
    EXPECT_EQ(refusal().id, WordRefusalId::restarted);
    ASSERT_TRUE(m_table.cams(1));
    EXPECT_EQ(m_table.cams(1)->program, CamProgram{}) << "as it was read, and saved";
}

// The first program was written and read back, the second is under way: then both are as before, and the
// first is not reported as written.
TEST_F(K3Cams, CancelledInTheSecondProgramBothAreRestored)
{
    CamProgram first = with(0, {1, 0, false});
    CamProgram second = with(0, {2, 3, false});
    second.number = 2;
    ASSERT_TRUE(m_table.begin(WriteCams{.programs = {first, second}, .afterwards = {}}));
    enter(1, 0x0000);
    answerRest(nothing(), 0);
    m_table.play({{0x4000'0001, posInCamMode},
                  {0x4000'0001, 0xC000'0001},
                  {0x8000'0000, 0xC000'0001},
                  {0x8000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    answer(0x2020'0010, 0x01);
    m_table.repeat(3, {0x2080'0002, posInCamMode});
    answer(0x2020'0000, 0x00);
    answerRest(nothing(), 0);
    m_table.play({{0x4000'0002, posInCamMode}, {0x4000'0002, 0xC000'0002}, {0x6000'0003, 0xC000'0002}});
    m_table.driver().cancel(OnCancel::restorePrevious, Instant{});
    m_table.play({{0x6000'0003, 0xE000'0003}, {0x0000'0000, 0xE000'0003}});
    answer(0x2020'0000, 0x00, 0xE000'0003);
    m_table.play({{0x2010'0000, 0xE000'0003}, // opens what 40000000 must not
                  {0x2010'0000, 0xE010'0000},
                  {0x4000'0000, 0xC000'0000},
                  {0x6000'0000, 0xE000'0000},
                  {0x8000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    answer(0x2020'0010, 0x00);
    answer(0x2020'0020, 0x00);
    m_table.repeat(3, {0x2080'0001, posInCamMode});
    answer(0x2020'0000, 0x00);
    m_table.play({{0x2010'0000, posInCamMode},
                  {0x2010'0000, 0xE010'0000},
                  {0x4000'0000, 0xC000'0000},
                  {0x8000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    answer(0x2020'0010, 0x00);
    m_table.play({{0x0000'0000, posInCamMode}});
    EXPECT_EQ(refusal().id, RefusalId::cancelled);
    EXPECT_EQ(m_table.outcome()->restored, Evidence::read);
    EXPECT_EQ(m_table.outcome()->camsWritten,
              (std::vector{CamProgram{.number = 1, .cam = {}}, CamProgram{.number = 2, .cam = {}}}));
}

// Of words sent as they are, only those that set something in a program count as taken.
TEST_F(K3Cams, AWordByHandThatSetsNothingOfAProgramIsNotTakenForOne)
{
    m_table.repeat(3, {0x0000'0000, pos});
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::cam, 3}));
    m_table.play({{0x0000'0000, pos},
                  {0x2080'0003, pos},
                  {0x2080'0003, pos},
                  {0x2080'0003, posInCamMode},
                  {0x0000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    ASSERT_TRUE(m_table.begin(SendWords{.words = {0x4600'0015, 0x8000'0000, 0x0000'0000}}));
    m_table.play({{0x0000'0000, posInCamMode},
                  {0x4600'0015, posInCamMode},
                  {0x4600'0015, 0xC600'0015},
                  {0x8000'0000, 0xC600'0015},
                  {0x8000'0000, posInCamMode},
                  {0x0000'0000, posInCamMode}});
    EXPECT_FALSE(m_table.progress().canRestore) << "what the program was before is not known";
    EXPECT_TRUE(m_table.progress().hasTaken);
}

} // namespace
} // namespace codewheel
