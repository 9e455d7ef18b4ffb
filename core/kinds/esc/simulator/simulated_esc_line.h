// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/simulator/esc_line_wire.h"
#include "kinds/esc/simulator/simulated_esc_encoder.h"

#include <condition_variable>
#include <mutex>
#include <vector>

namespace codewheel {

// The encoders 03, 05 and 12h of the training bus. 05 is at position 1235h, as in the manual's example.
std::vector<EscEncoderPlan> trainingLine();

// A serial line with simulated ESC encoders on it, and what happens to it. Every character takes its time; at
// a baud rate other than the listener's, or in a format other than 8 data bits without parity, it is junk to
// the listener. Time is an argument: SimulatedEscLineLink makes it virtual or real. One thread uses the line;
// the trainer's functions may be called by any.
class SimulatedEscLine
{
public:
    static constexpr Instant usualAnswerDelay{200}; // of an encoder (assumed: the manual's figure is lost)

    explicit SimulatedEscLine(const std::vector<EscEncoderPlan> &encoders = trainingLine(),
                              std::uint32_t seed = 1);

    // What reached the master, and when its last byte did.
    struct Arrival
    {
        QByteArray bytes;
        Instant at;
    };

    // At this time nothing is on the wire.
    void begin(const SerialSettings &settings, Instant now = {});
    void setBaudRate(int baudRate);
    SerialSettings settings() const;
    void send(const QByteArray &bytes, Instant now);
    // Lets time pass up to `until`, or to the first bytes that reach the master before it.
    Arrival advance(Instant until);
    // Characters on the wire or waiting for it, of all senders.
    std::size_t waiting() const;
    // When there will be something to do; empty: the line is quiet.
    std::optional<Instant> nextEnd() const;
    // When what is on the wire will have passed, up to the next gap.
    std::optional<Instant> runEnd() const;

    // Really waits for this long; false: wake() ended it or had been called before, or the adapter is
    // unplugged.
    bool wait(Instant atMost);
    void waitForWake(Instant atMost); // the same while the adapter is unplugged
    // True if wake() was called since the last wait.
    bool takeWake();
    void wake();

    // For the trainer.
    void setFaults(const EscLineFaults &faults);
    EscLineFaults faults() const;
    void setAnswerDelay(Instant delay);
    void setUnplugged(bool unplugged); // the adapter: nothing goes in or out
    bool isUnplugged() const;
    std::vector<EscLineAddress> addresses() const;
    // Calls `change` with each encoder at the address; there are two if the user set them up that way. False:
    // none is there.
    template <typename Change>
    bool withEncoder(EscLineAddress address, Change change)
    {
        const std::scoped_lock lock(m_mutex);
        bool found = false;
        for (SimulatedEscEncoder &encoder : m_encoders)
            if (encoder.address() == address) {
                change(encoder);
                found = true;
            }
        return found;
    }
    void setSilent(bool silent); // all of them: they hear and act, but say nothing

private:
    void turnShaftsTo(Instant now);
    void deliver(const EscLineWire::Ended &character);
    void tellEncoders(const EscLineWire::Ended &character);
    bool fitsEncoders() const;

    mutable std::mutex m_mutex;
    std::condition_variable m_woken;
    bool m_wake = false;

    std::vector<SimulatedEscEncoder> m_encoders;
    EscLineWire m_wire;
    SerialSettings m_settings; // of the master
    Instant m_answerDelay = usualAnswerDelay;
    std::int64_t m_cycles = 0; // the time in ms up to which the shafts have turned
    QByteArray m_heard;        // by the master
    bool m_unplugged = false;
};

} // namespace codewheel
