// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "serial/serial_settings.h"
#include "vocabulary/instant.h"

#include <QByteArray>

#include <map>
#include <optional>
#include <random>

namespace codewheel {

// What happens to the bytes on a simulated serial line, in both directions. Counts are per 1000 bytes; what
// happens to a byte is drawn from a random generator with a known seed, so that a run can be repeated.
struct EscLineFaults
{
    int lost = 0;
    int corrupted = 0; // one of its bits is flipped
    int doubled = 0;
    int delayed = 0; // together with all that follow it
    Instant delay{20'000};
    bool echo = false; // the adapter hears what it sends: half duplex

    friend bool operator==(const EscLineFaults &, const EscLineFaults &) = default;
};

// The two wires of a simulated serial line: who sends which character from when to when. Characters sent at
// the same time spoil each other. Used by SimulatedEscLine; time is its own.
class EscLineWire
{
public:
    static constexpr int master = -1; // as a sender; encoders are 0 and up

    struct Character
    {
        Instant begin;
        int sender = master;
        int baudRate = 0;
        char byte = 0;
        bool spoiled = false;
    };
    using Ended = std::pair<Instant, Character>;

    explicit EscLineWire(std::uint32_t seed)
        : m_random(seed)
    {}

    void setFaults(const EscLineFaults &faults) { m_faults = faults; }
    const EscLineFaults &faults() const { return m_faults; }

    // The sender's characters follow each other, starting at `earliest` or when its previous ones are out.
    void send(const QByteArray &bytes, int sender, Instant earliest, const SerialSettings &settings);
    std::size_t waiting() const { return m_characters.size(); } // characters that are not complete yet
    // When the next character is complete.
    std::optional<Instant> nextEnd() const;
    // When that one and all that follow it without a gap are complete.
    std::optional<Instant> runEnd() const;
    // That character, with its end; requires that there is one.
    Ended take();
    void clear();

    // What a receiver makes of a character it cannot read. Never ASCII.
    char junk() { return static_cast<char>(0x80 | m_random() % 0x80); }

private:
    bool strikes(int ofThousand) { return static_cast<int>(m_random() % 1'000) < ofThousand; }
    char corrupted(char byte) { return static_cast<char>(byte ^ 1 << m_random() % 8); }
    void put(Instant end, Character character);

    EscLineFaults m_faults;
    std::mt19937 m_random;                          // its sequence is the same on every platform
    std::multimap<Instant, Character> m_characters; // by their end
    std::map<int, Instant> m_freeFrom;              // by sender
};

} // namespace codewheel
