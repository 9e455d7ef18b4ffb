// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/baumer_k3.h"
#include "kinds/interbus/simulator/fraba_k3.h"
#include "kinds/interbus/simulator/simulated_position_encoder.h"
#include "tests/support/word_source.h"

#include <memory>
#include <set>

// A million words nobody in their right mind would send, to each kind of device of the training bus. Whatever
// comes: IN has one of the manuals' forms, each of these forms occurs, and valid words bring the device back.
namespace codewheel {
namespace {

constexpr int words = 1'000'000;
constexpr int wordsBetweenRecoveries = 500;

unsigned numberOf(Word in)
{
    return (in >> 25) & 0xF;
}

bool isDocumentedForFraba(Word in)
{
    const Word data = in & 0x01FF'FFFF;
    switch (in >> 29) {
    case 0:
        return numberOf(in) == 0;
    case 6:
    case 7: // confirmation of a parameter, start or stop of a cam
        return numberOf(in) <= 7;
    case 4:
        return in == 0x8000'0000 || in == 0x8200'0000 || in == 0x8400'0000 || in == 0x8600'0000 ||
               in == 0x9800'0004;
    case 5:
        return numberOf(in) == 0 || (numberOf(in) == 2 && data <= 0xFFFF);
    default:
        return false;
    }
}

bool isDocumentedForBaumer(Word in)
{
    switch (in >> 29) {
    case 0:
        return numberOf(in) == 0;
    case 6:
        return true;
    case 4:
        return in == 0x8200'0000 || in == 0x8400'0000 || in == 0x8600'0000 || in == 0x9A00'0000 ||
               in == 0x9C00'0000 || in == 0x9E00'0000;
    default:
        return false;
    }
}

void bringBackFraba(SimulatedDevice &encoder)
{
    EXPECT_EQ(hex8(send(encoder, {0x2080'0000, 0x0000'0000, 0x8000'0000, 0x0000'0000, 0x0E00'0000})),
              "CE000000");
    EXPECT_EQ(hex8(send(encoder, {0x8000'0000, 0x0000'0000})), "00003039");
    EXPECT_EQ(hex8(send(encoder, {0x0200'00FF, 0x8000'0000, 0x0000'0000})), "00000180");
}

void bringBackBaumer(SimulatedDevice &encoder)
{
    EXPECT_EQ(hex8(send(encoder, {0x8000'0000, 0x0000'0000, 0x0E00'0000})), "CE000000");
    EXPECT_EQ(hex8(send(encoder, {0x8000'0000, 0x0000'0000})), "00003039");
    EXPECT_EQ(hex8(send(encoder, {0x0200'00FF, 0x8000'0000, 0x0000'0000})), "00000180");
}

// 12 bits per turn
template <int turns>
std::unique_ptr<SimulatedDevice> makePositionEncoder()
{
    return std::make_unique<SimulatedPositionEncoder>(PhysicalResolution{4096, turns}, 12'345);
}

struct RandomRow
{
    const char *name;
    std::unique_ptr<SimulatedDevice> (*make)();
    bool (*isDocumented)(Word in);
    std::set<Word> firstBytes; // that occur at least
    void (*bringBack)(SimulatedDevice &device);
};

void PrintTo(const RandomRow &row, std::ostream *out)
{
    *out << row.name;
}

const RandomRow rows[] = {
    {"FrabaK3",
     []() -> std::unique_ptr<SimulatedDevice> {
         return std::make_unique<FrabaK3>(thirteenPlusTwelve, 12'345, FrabaPlate{.serialNumber = 1});
     },
     isDocumentedForFraba,
     {0x00, 0x01, 0x80, 0x82, 0x84, 0x86, 0x98, 0xA0, 0xA4, 0xC0, 0xC2, 0xC4, 0xC6,
      0xC8, 0xCA, 0xCC, 0xCE, 0xE0, 0xE2, 0xE4, 0xE6, 0xE8, 0xEA, 0xEC, 0xEE},
     bringBackFraba},
    {"BaumerK3",
     []() -> std::unique_ptr<SimulatedDevice> {
         return std::make_unique<BaumerK3>(thirteenPlusTwelve, 12'345);
     },
     isDocumentedForBaumer,
     {0x00, 0x01, 0x82, 0x84, 0x86, 0x9A, 0x9C, 0x9E, 0xC0, 0xC2, 0xC4, 0xC6,
      0xC8, 0xCA, 0xCC, 0xCE, 0xD0, 0xD2, 0xD4, 0xD6, 0xD8, 0xDA, 0xDC, 0xDE},
     bringBackBaumer},
    {"FrabaK1",
     makePositionEncoder<1>,
     [](Word in) { return in <= 0xFFF; },
     {0x00},
     [](SimulatedDevice &encoder) { EXPECT_EQ(hex8(send(encoder, {0x0000'0000})), "00000039"); }},
    {"FrabaK2",
     makePositionEncoder<4096>,
     [](Word in) { return in <= 0xFF'FFFF; },
     {0x00},
     [](SimulatedDevice &encoder) { EXPECT_EQ(hex8(send(encoder, {0x0000'0000})), "00003039"); }},
};

class RandomWords : public testing::TestWithParam<RandomRow>
{
protected:
    void disturb()
    {
        switch (m_source.below(5'000)) {
        case 0:
            m_device->powerCycle();
            break;
        case 1:
            m_device->loseParameters();
            break;
        case 2:
            m_device->setBatteryLow(true);
            break;
        case 3:
            m_device->setSpeed(m_source.below(14'000) - 7'000);
            break;
        case 4:
            m_device->setEepromWornOut(true);
            break;
        case 5:
            m_device->setCodeDiscFaulty(true);
            break;
        default:
            break;
        }
    }

    void mend()
    {
        m_device->setEepromWornOut(false);
        m_device->setCodeDiscFaulty(false);
        m_device->setSpeed(0);
        for (int cycle = 0; cycle < 80; ++cycle)
            m_device->cycle(0); // a power cycle may be under way
        m_device->turnTo(12'345);
    }

    WordSource m_source;
    std::unique_ptr<SimulatedDevice> m_device = GetParam().make();
};

TEST_P(RandomWords, LeaveADeviceInADocumentedStateFromWhichItComesBack)
{
    std::set<Word> firstBytes;
    for (int i = 0; i < words && !HasFailure(); ++i) {
        const Word out = m_source.next();
        const int cycles = 1 + m_source.below(5);
        for (int cycle = 0; cycle < cycles; ++cycle) {
            const Word in = m_device->cycle(out);
            ASSERT_TRUE(GetParam().isDocumented(in))
                << "word " << i << ": " << hex8(out) << " / " << hex8(in);
            firstBytes.insert(in >> 24);
        }
        disturb();
        if (i % wordsBetweenRecoveries == wordsBetweenRecoveries - 1) {
            mend();
            GetParam().bringBack(*m_device);
        }
    }
    for (const Word expected : GetParam().firstBytes)
        EXPECT_TRUE(firstBytes.contains(expected)) << std::hex << expected;
}

INSTANTIATE_TEST_SUITE_P(Training, RandomWords, testing::ValuesIn(rows),
                         [](const auto &row) { return std::string(row.param.name); });

} // namespace
} // namespace codewheel
