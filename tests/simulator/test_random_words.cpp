// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "simulator/baumer_k3.h"
#include "simulator/fraba_k3.h"

#include <random>

// A million words nobody in his senses would send. Whatever comes: IN is of a form the manuals tell, and
// valid words bring the encoder back.
namespace codewheel {
namespace {

constexpr PhysicalResolution thirteenPlusTwelve{8192, 4096};
constexpr int words = 1'000'000;
constexpr int wordsBetweenRecoveries = 500;

constexpr Word corners[] = {
    0x0000'0000, 0x8000'0000, 0x4000'0000, 0x6000'0000, 0xC000'0000, 0xFFFF'FFFF, 0x0E00'0000, 0x0200'00FF,
    0x0400'0001, 0x0600'0003, 0x0600'0004, 0x0800'0064, 0x0A00'0005, 0x0C00'0005, 0x1E00'0005, 0x2040'0000,
    0x2040'0001, 0x2080'0000, 0x2080'0001, 0x2080'0008, 0x2080'000F, 0x4600'0015, 0x6600'0213, 0x2040'0008,
    0x2010'0000, 0x2010'0019, 0x2010'001A, 0x2020'0000, 0x2020'0013, 0x2020'0023, 0x2020'0040, 0x2021'0000,
    0x2021'0005, 0x2021'0009, 0x2021'000B, 0x2021'00FD, 0x0000'FFFF, 0x01FF'FFFF, 0x8200'00FF,
};

class WordSource
{
public:
    Word next()
    {
        switch (below(4)) {
        case 0:
            return any();
        case 1:
            return (any() & 0x1E00'0000) | (any() & dataMask()); // a parameter
        case 2:
            return (any() & 0xFE00'0000) | (any() & dataMask());
        default:
            return corners[static_cast<std::size_t>(below(std::size(corners)))];
        }
    }
    int below(std::size_t limit) { return static_cast<int>(m_random() % limit); }

private:
    Word any() { return static_cast<Word>(m_random()); }
    // Small values are the ones that get through.
    Word dataMask() { return 0x01FF'FFFF >> below(25); }

    std::mt19937 m_random{71};
};

bool isDocumentedForFraba(Word in)
{
    const Word data = in & 0x01FF'FFFF;
    const unsigned number = (in >> 25) & 0xF;
    switch (in >> 29) {
    case 0:
        return number == 0;
    case 6:
        return true; // confirmation of a parameter or the start of a cam; told apart below
    case 7:
        return number <= 7;
    case 4:
        return in == 0x8000'0000 || in == 0x8200'0000 || in == 0x8400'0000 || in == 0x8600'0000 ||
               in == 0x9800'0004;
    case 5:
        return number == 0 || (number == 2 && data <= 0xFFFF);
    default:
        return false;
    }
}

bool isConfirmationOfFraba(Word in)
{
    const unsigned number = (in >> 25) & 0xF;
    return (in >> 29) != 6 || number <= 7;
}

bool isDocumentedForBaumer(Word in)
{
    switch (in >> 29) {
    case 0:
        return ((in >> 25) & 0xF) == 0;
    case 6:
        return true;
    case 4:
        return in == 0x8200'0000 || in == 0x8400'0000 || in == 0x8600'0000 || in == 0x9C00'0000;
    default:
        return false;
    }
}

void disturb(SimulatedK3 &encoder, WordSource &source)
{
    switch (source.below(5'000)) {
    case 0:
        encoder.powerCycle();
        break;
    case 1:
        encoder.loseParameters();
        break;
    case 2:
        encoder.setBatteryLow(true);
        break;
    case 3:
        encoder.setSpeed(source.below(14'000) - 7'000);
        break;
    default:
        break;
    }
}

template <typename Documented, typename Recover>
void sendRandomWords(SimulatedK3 &encoder, Documented documented, Recover recover)
{
    WordSource source;
    for (int i = 0; i < words; ++i) {
        const Word out = source.next();
        const int cycles = 1 + source.below(5);
        for (int cycle = 0; cycle < cycles; ++cycle) {
            const Word in = encoder.cycle(out);
            ASSERT_TRUE(documented(in)) << "word " << i << ": " << hex8(out) << " / " << hex8(in);
        }
        disturb(encoder, source);
        if (i % wordsBetweenRecoveries == wordsBetweenRecoveries - 1) {
            encoder.setSpeed(0);
            recover();
            if (testing::Test::HasFailure())
                return;
        }
    }
}

TEST(RandomWords, LeaveAFrabaInADocumentedStateFromWhichItComesBack)
{
    FrabaK3 encoder(thirteenPlusTwelve, 12'345, {.serialNumber = 1});
    const auto documented = [](Word in) { return isDocumentedForFraba(in) && isConfirmationOfFraba(in); };
    sendRandomWords(encoder, documented, [&encoder] {
        for (int i = 0; i < 60; ++i)
            encoder.cycle(0); // a power cycle may be under way
        encoder.turnTo(12'345);
        EXPECT_EQ(hex8(send(encoder, {0x2080'0000, 0x0000'0000, 0x8000'0000, 0x0000'0000, 0x0E00'0000})),
                  "CE000000");
        EXPECT_EQ(hex8(send(encoder, {0x8000'0000, 0x0000'0000})), "00003039");
        EXPECT_EQ(hex8(send(encoder, {0x0200'00FF, 0x8000'0000, 0x0000'0000})), "00000180");
    });
}

TEST(RandomWords, LeaveABaumerInADocumentedStateFromWhichItComesBack)
{
    BaumerK3 encoder(thirteenPlusTwelve, 12'345);
    sendRandomWords(encoder, isDocumentedForBaumer, [&encoder] {
        for (int i = 0; i < 80; ++i)
            encoder.cycle(0);
        encoder.turnTo(12'345);
        EXPECT_EQ(hex8(send(encoder, {0x8000'0000, 0x0000'0000, 0x0E00'0000})), "CE000000");
        EXPECT_EQ(hex8(send(encoder, {0x8000'0000, 0x0000'0000})), "00003039");
        EXPECT_EQ(hex8(send(encoder, {0x0200'00FF, 0x8000'0000, 0x0000'0000})), "00000180");
    });
}

} // namespace
} // namespace codewheel
