// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "jobs/known_values.h"
#include "kinds/interbus/la66/la66_plan.h"
#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/word_reach.h"
#include "vocabulary/position_speed.h"
#include "vocabulary/reading.h"

namespace codewheel {

// The error number of a magnet outside the measuring range: its bit of the error status (LA-66 manual 3.5).
inline constexpr unsigned magnetErrorNumber = 5;

// What IN of an LA-66 shows. With the error bit in normal mode the position is the last valid one, or is
// valid again but the error status has not been read.
Reading decodeLa66(Word in, Instant at) noexcept;

// What an LA-66 is known to have, learned from the answers in IN, whoever asked: a write that came back is
// active at once and in EEPROM, a read reports its value.
class La66Knowledge
{
public:
    explicit La66Knowledge(const DeviceDescription &device)
        : m_device(device)
    {}

    void observe(Word in, Instant now);
    void setOthersWrite(bool on) { m_othersWrite = on; } // as CyclicDriver

    const ParameterDescription *find(unsigned service) const { return findNumber(m_device, service); }
    KnownValues &values() { return m_values; }
    const KnownValues &values() const { return m_values; }

private:
    void observeAnswer(Word in, Instant now);

    const DeviceDescription &m_device;
    KnownValues m_values;
    bool m_othersWrite = false;
    bool m_serviceMode = true; // an answer that is there in the first cycle is to nobody we know
};

// One LA-66 as currently known: what it shows, what it has. Shared by the driver and by the job in progress.
struct La66Encoder
{
    // The description must outlive this.
    La66Encoder(const DeviceDescription &device, La66Timing how)
        : timing(how)
        , knowledge(device)
        , plan(device, timing)
    {
        speed.setScale(PositionSpeed::Scale{.stepsPerTurn = finestStepsIn100Millimetres});
    }

    void setKnown(const std::vector<Known> &known) { knowledge.values().set(known); }
    Result<void> check(const Job &job) const { return plan.check(job); }
    void observe(Word in, Word out, Instant now);
    static bool isAnswer(Word in) { return la66::isServiceMode(in); }
    void forget(Parameter parameter);
    // No job is running: what `out`, whose answer nobody sees, may have written is reported as in doubt.
    void loseSightByHand(Word out);
    void reportChanges();

    static constexpr double finestStepsIn100Millimetres = 20'000; // of 0.005 mm (assumed)

    La66Timing timing;
    La66Knowledge knowledge;
    La66Plan plan;
    PositionSpeed speed;
    Reading reading;
    std::vector<Event> events;
};

} // namespace codewheel
