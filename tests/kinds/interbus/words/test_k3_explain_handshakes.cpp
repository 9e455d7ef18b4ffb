// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/words/explain_table.h"

#include <gtest/gtest.h>

namespace codewheel::k3 {
namespace {

using enum MeaningId;

constexpr Word somewhere = 0x0000'3039;
constexpr Meaning at12345{position, {12345}};

TEST(K3Explain, Fraba53ParameterizationOf255Steps)
{
    constexpr Meaning steps{parameterRequest, {1, 255}};
    constexpr Meaning turns{parameterRequest, {2, 1}};
    constexpr Meaning direction{parameterRequest, {3, 3}};
    constexpr Meaning preset{parameterRequest, {4, 0}};
    constexpr HandshakeRow rows[] = {
        {0x0000'0000, somewhere, {normalRunning}, at12345},
        {0x0200'00FF, somewhere, steps, at12345},
        {0x0200'00FF, 0xC200'00FF, steps, {confirmed, {1, 255}}},
        {0x0400'0001, 0xC200'00FF, turns, {oldConfirmation, {1, 255, 2}}},
        {0x0400'0001, 0xC200'0100, turns, {oldConfirmation, {1, 256, 2}}}, // as printed in the manual
        {0x0400'0001, 0xC400'0001, turns, {confirmed, {2, 1}}},
        {0x0600'0003, 0xC400'0001, direction, {oldConfirmation, {2, 1, 3}}},
        {0x0600'0003, 0xC600'0003, direction, {confirmed, {3, 3}}},
        {0x0800'0000, 0xC600'0003, preset, {oldConfirmation, {3, 3, 4}}},
        {0x0800'0000, 0xC800'0000, preset, {confirmed, {4, 0}}},
        {0x8000'0000, 0xC800'0000, {run}, {confirmed, {4, 0}}},
        {0x8000'0000, 0x0000'0000, {run}, {position, {0}}},
        {0x0000'0000, 0x0000'0001, {normalRunning}, {position, {1}}},
    };
    expectHandshake(rows, Dialect::fraba, Mode::position, PositionCoding::binary);
}

TEST(K3Explain, Fraba53InitialisationOfThePreset)
{
    constexpr HandshakeRow rows[] = {
        {0x0000'0000, somewhere, {normalRunning}, at12345},
        {0x4000'0000, somewhere, {initialisePreset}, at12345},
        {0x4000'0000, 0x0000'0000, {initialisePreset}, {position, {0}}},
        {0x0000'0000, 0x0000'0000, {normalRunning}, {position, {0}}},
    };
    expectHandshake(rows, Dialect::fraba, Mode::position, PositionCoding::binary);
    expectHandshake(rows, Dialect::baumer, {}, PositionCoding::binary);
    expectHandshake(rows, Dialect::generic, Mode::position, PositionCoding::binary);
}

TEST(K3Explain, BaumerExample2)
{
    constexpr Meaning revolutions{parameterRequest, {2, 20'000}};
    constexpr Meaning coding{parameterRequest, {3, 1}};
    constexpr HandshakeRow rows[] = {
        {0x0000'0000, somewhere, {normalRunning}, at12345},
        {0x0400'4E20, somewhere, revolutions, at12345},
        {0x0400'4E20, 0xC000'4E20, revolutions, {processing, {20'000}}},
        {0x0400'4E20, 0xC400'4E20, revolutions, {confirmed, {2, 20'000}}},
        {0x0600'0001, 0xC400'4E20, coding, {oldConfirmation, {2, 20'000, 3}}},
        {0x0600'0001, 0xC400'0001, coding, {processing, {1}}}, // the previous number, the new data
        {0x0600'0001, 0xC600'0001, coding, {confirmed, {3, 1}}},
        {0x8000'0000, 0xC600'0001, {run}, {confirmed, {3, 1}}},
        {0x8000'0000, 0x8200'0000, {run}, {deviceError, {1, 0}}},
    };
    expectHandshake(rows, Dialect::baumer, {}, PositionCoding::binary);
}

TEST(K3Explain, Fraba544Cam3From15hTo213h)
{
    constexpr HandshakeRow rows[] = {
        {0x2080'0001, 0x0000'0000, {camMode, {1}}, {cams, {0, 0}}},
        {0x4600'0015, 0xC600'0015, {camStart, {3, 0x15}}, {camConfirmation, {0x4600'0015}}},
        {0x6600'0213, 0xE600'0213, {camStop, {3, 0x213}}, {camConfirmation, {0x6600'0213}}},
        {0x2040'0008, 0xE040'0008, {camConfiguration, {8}}, {camConfirmation, {0x2040'0008}}},
        {0x8000'0000, 0x0000'2008, {run}, {cams, {8, 0x20}}},
        {0x2020'0013, 0xA000'0015, {camStartRequest, {3}}, {camStartValue, {3, 0x15}}},
        {0x2020'0023, 0xA000'0213, {camStopRequest, {3}}, {camStopValue, {3, 0x213}}},
        {0x2020'0000, 0xA000'0008, {camConfigurationRequest}, {camConfigurationValue, {8}}},
        {0x2020'0030, 0xA000'0019, {camShiftRequest}, {camShiftValue, {25}}}, // FRABA 10.5, table
        {0x2020'0040, 0xA000'0019, {camShiftRequest}, {camShiftValue, {25}}}, // its bit row, and 5.4.4
    };
    expectHandshake(rows, Dialect::fraba, Mode::cam, PositionCoding::binary);
}

} // namespace
} // namespace codewheel::k3
