// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "jobs/known_values.h"
#include "kinds/interbus/words/word_reach.h"

namespace codewheel {

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

} // namespace codewheel
