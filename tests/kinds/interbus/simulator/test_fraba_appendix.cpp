// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/fraba_k3.h"
#include "tests/support/fraba_appendix.h"

namespace codewheel {
namespace {

class AppendixEncoder
{
public:
    explicit AppendixEncoder(const AppendixRow &row)
        : m_encoder({8192, 4096}, 0x3039, {.serialNumber = 4711, .operatingTime = 99},
                    {.startUp = row.happening == Happening::startsUp ? 20 : 0})
    {
        for (const Word word : row.before)
            send(m_encoder, {word});
        cause(row.happening);
    }

    Word answer(Word out, int cycles)
    {
        Word in = 0;
        for (int cycle = 0; cycle < cycles; ++cycle)
            in = m_encoder.cycle(out);
        return in;
    }

private:
    void cause(Happening happening)
    {
        switch (happening) {
        case Happening::nothing:
            break;
        case Happening::turnsAt1500Rpm:
            m_encoder.setSpeed(1500);
            break;
        case Happening::turnsAt6000Rpm:
            m_encoder.setSpeed(6000);
            break;
        case Happening::losesItsParameters:
            m_encoder.loseParameters();
            break;
        case Happening::startsUp:
            m_encoder.setPower(false);
            m_encoder.setPower(true);
            break;
        }
    }

    FrabaK3 m_encoder;
};

TEST(FrabaAppendix, EveryRowIsAnsweredAsDocumented)
{
    for (const AppendixRow &row : frabaAppendix())
        EXPECT_EQ(hex8(AppendixEncoder(row).answer(row.out, row.cycles)), hex8(row.in))
            << row.section << ' ' << row.name << ": " << hex8(row.out);
}

} // namespace
} // namespace codewheel
