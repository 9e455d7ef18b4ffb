// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/parameter_set.h"
#include "kinds/interbus/words/k3_word.h"

namespace codewheel {

// From the physical position to the word on the bus, for one valid set of parameters (Baumer 5). Created anew
// when the parameters change, so that a bus cycle costs no 64-bit division.
//
//     raw -> scaled x -> API (absolute) -> PI (process value) -> coded
class EncoderArithmetic
{
public:
    EncoderArithmetic(const ParameterSet &set, PhysicalResolution physical)
        : m_steps(set.steps)
        , m_divisor(set.revolutions * physical.stepsPerTurn)
        , m_reciprocal(1.0 / static_cast<double>(m_divisor))
        , m_total(totalRange(set))
        , m_shift((set.zeroOffset + set.offset) % m_total)
        , m_preset(set.preset)
        , m_clockwise(set.coding % 2 == 1)
        , m_code(codeOf(set.coding))
    {}

    std::int64_t total() const { return m_total; }
    bool isClockwise() const { return m_clockwise; }

    // API, 0..total - 1
    std::int64_t absoluteValue(std::int64_t raw) const
    {
        std::int64_t x = scaled(raw);
        if (x >= m_total)
            x %= m_total;
        return m_clockwise ? x : m_total - 1 - x;
    }

    // PI = API + NPV + O, 0..total - 1
    std::int64_t processValue(std::int64_t raw) const
    {
        const std::int64_t sum = absoluteValue(raw) + m_shift;
        return sum >= m_total ? sum - m_total : sum;
    }

    // D24..D0 of IN
    Word codedValue(std::int64_t raw) const
    {
        const std::int64_t value = processValue(raw);
        switch (m_code) {
        case Code::signedBinary:
            return static_cast<Word>(value < (m_total + 1) / 2 ? value : value - m_total) & k3::dataMask;
        case Code::gray:
            return static_cast<Word>(value ^ (value >> 1));
        case Code::binary:
            break;
        }
        return static_cast<Word>(value);
    }

    // The NPV that makes PI = PW + O at this position: (PW - API) mod total
    std::int64_t zeroOffsetForPreset(std::int64_t raw) const
    {
        const std::int64_t difference = m_preset - absoluteValue(raw);
        return difference < 0 ? difference + m_total : difference;
    }

private:
    enum class Code : std::uint8_t { binary, signedBinary, gray };

    static Code codeOf(std::int64_t coding)
    {
        return coding <= 2 ? Code::signedBinary : coding <= 4 ? Code::binary : Code::gray;
    }

    // floor(raw x steps / (revolutions x physical steps)). The product is below 2^50: the quotient computed
    // with the reciprocal, itself off by at most 2^-53, may be one too small but never too large.
    std::int64_t scaled(std::int64_t raw) const
    {
        const std::int64_t product = raw * m_steps;
        const auto quotient = static_cast<std::int64_t>(static_cast<double>(product) * m_reciprocal);
        const std::int64_t rest = product - quotient * m_divisor;
        return quotient + (rest >= m_divisor);
    }

    std::int64_t m_steps;
    std::int64_t m_divisor;
    double m_reciprocal;
    std::int64_t m_total;
    std::int64_t m_shift; // NPV + O
    std::int64_t m_preset;
    bool m_clockwise;
    Code m_code;
};

} // namespace codewheel
