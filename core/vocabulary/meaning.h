// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace codewheel {

// What a process-data word can mean. The sentence for it is made where it is shown (catalog/explain_word.h);
// meaningKey() gives the language-neutral name used in JSON.
enum class MeaningId : std::uint8_t {
    // OUT, K3
    normalRunning,             // 00000000
    normalRunningData,         // D31..D25 = 0 with data in D24..D0: number[0] = data
    run,                       // 80000000
    runIgnoresRest,            // D31 = 1 with other bits: number[0] = the rest
    initialisePreset,          // 40000000
    frabaPreset,               // 60000000
    parameterRequest,          // "parameter n = value": number[0] = number, number[1] = value
    parameterRequestInCamMode, // likewise, but cam mode refuses it
    parameterRequestInvalid,   // likewise, but the parameter does not take this value
    parameterRequestUndefined, // likewise, but the encoder has no parameter of this number
    resetToDefault,            // 0E000000
    velocityOn,                // 20400001
    velocityOff,               // 20400000
    readOutRequest,            // 2021000n: number[0] = code
    opcRegisterRequest,        // 202100xD: number[0] = register
    camMode,                   // 2080000x: number[0] = program (1..8; 9..15 are refused)
    positionMode,              // 20800000
    camConfiguration,          // 2040xxxx: number[0] = cams as bits
    camStart,                  // 4.......: number[0] = cam, number[1] = position
    camStop,                   // 6.......: number[0] = cam, number[1] = position
    setCamShift,               // 201000xx: number[0] = shift_iw
    camConfigurationRequest,
    camStartRequest, // number[0] = cam
    camStopRequest,  // number[0] = cam
    camShiftRequest,
    manufacturerBitIgnored,  // Baumer: D29 = 1 beside a word that means number[0]
    manufacturerSpecificOut, // D29 = 1, make not known: number[0] = word
    // OUT, LA-66
    serviceRead,         // number[0] = service, number[1] = service bit
    serviceWrite,        // number[0] = service, number[1] = data, number[2] = service bit
    serviceWriteInvalid, // likewise, but the service does not take this value
    // OUT, K1, K2, K4
    noOutWord,      // the encoder takes no words: number[0] = word
    undescribedOut, // K4: no source describes its OUT word: number[0] = word
    undefinedOut,   // no manual defines it: number[0] = word

    // IN, K3
    position,            // number[0] = value
    signedPosition,      // number[0] = value
    grayPosition,        // number[0] = decoded value, number[1] = Gray code
    undescribedPosition, // K4, status bits within the position: number[0] = value
    rawPosition,         // coding not known: number[0] = raw D24..D0
    velocity,            // number[0] = revolutions per minute
    cams,                // number[0] = cams as bits, number[1] = position part D24..D8
    processing,          // C0......: number[0] = data
    confirmed,           // number[0] = parameter, number[1] = data
    oldConfirmation,     // as confirmed, while OUT asks for parameter number[2]
    camConfirmation,     // number[0] = the OUT word acknowledged
    selfTestOrReadOut,   // A.......: number[0] = value
    readOutValue,        // number[0] = code asked for, number[1] = value
    opcRegisterValue,    // number[0] = register, number[1] = value
    camConfigurationValue,
    camStartValue, // number[0] = cam, number[1] = position
    camStopValue,
    camShiftValue,
    readOutUnknown,         // A4......: number[0] = data
    noValidPosition,        // 80000000
    deviceError,            // number[0] = error number, number[1] = data
    wrongCamCommand,        // 84...... in cam mode: number[0] = data
    manufacturerError,      // 980000xx: number[0] = code
    unknownState,           // D31 D30 = 01: number[0] = word
    manufacturerSpecificIn, // D31..D29 = 101, make not known: number[0] = word
    // IN, LA-66
    positionWithError, // D29 = 1 in normal mode: number[0] = position
    serviceWritten,    // number[0] = service, number[1] = data
    serviceValue,      // read: number[0] = service, number[1] = value
    oldServiceAnswer,  // number[0] = service, number[1] = data, while OUT asks for service number[2]
    serviceRefused,    // D29 = 1 in service mode: number[0] = the OUT word refused
    // IN, K1, K2, K4
    unusedBitsSet, // no position: number[0] = bits above it that are 1, number[1] = bits it has
    undefinedIn,   // no manual defines it: number[0] = word
};
inline constexpr int meaningCount = static_cast<int>(MeaningId::undefinedIn) + 1;

// One meaning: an id and the numbers its sentence needs.
struct Meaning
{
    MeaningId id = MeaningId::undefinedIn;
    std::array<std::int64_t, 3> number{};

    friend constexpr bool operator==(const Meaning &, const Meaning &) = default;
};

// The meanings a word can have given what is known; never empty once explained. More than one where mode,
// coding or counterpart are not known.
class Explanation
{
public:
    constexpr Explanation() = default;
    constexpr Explanation(Meaning only) { add(only); } // NOLINT(google-explicit-constructor)

    constexpr void add(Meaning meaning)
    {
        for (const Meaning &known : *this)
            if (known == meaning)
                return;
        if (m_size < m_meanings.size())
            m_meanings[m_size++] = meaning;
    }
    constexpr std::size_t size() const { return m_size; }
    constexpr bool isUnique() const { return m_size == 1; }
    constexpr const Meaning &first() const { return m_meanings.front(); }
    constexpr const Meaning *begin() const { return m_meanings.data(); }
    constexpr const Meaning *end() const { return m_meanings.data() + m_size; }

    friend constexpr bool operator==(const Explanation &a, const Explanation &b)
    {
        if (a.m_size != b.m_size)
            return false;
        for (std::size_t i = 0; i < a.m_size; ++i)
            if (!(a.m_meanings[i] == b.m_meanings[i]))
                return false;
        return true;
    }

private:
    std::array<Meaning, 4> m_meanings{};
    std::size_t m_size = 0;
};

} // namespace codewheel
