// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_status.h"
#include "kinds/interbus/ring/ring_device.h"
#include "vocabulary/refusal.h"

#include <QString>

namespace codewheel {

// A configuration as stored by a master, with the name of the file it came from.
struct KeptConfiguration
{
    QString fileName;
    RingStructure structure;

    friend bool operator==(const KeptConfiguration &, const KeptConfiguration &) = default;
};

// The services of a ring's master (IBS SYS FW G4), if a link reaches it. Used by the thread that exchanges;
// no call blocks longer than an exchange. What is not possible in the master's state is refused:
// masterStateWrong.
class MasterLink
{
public:
    virtual ~MasterLink() = default;

    // The state of the ring after the last cycle or service.
    virtual const MasterStatus &status() const = 0;
    // Counts up whenever status() has changed.
    virtual std::uint64_t statusChanges() const = 0;
    // Without data: lets the time of one bus cycle pass while the ring does not run, so that the master goes
    // on looking for a fault or notices that it has been repaired.
    virtual void idleCycle() = 0;

    // 0710: one ID cycle of creating the configuration from the ring. Call it again until `complete`; the
    // ring is then active with what was found.
    struct IdCycle
    {
        RingStructure found; // so far
        bool complete = false;
    };
    virtual Result<IdCycle> createConfiguration() = 0;
    // 0711: activates the configuration that was created or loaded last, and returns it. Refused if the ring
    // is different (ringDiffers) or faulty (busFault), or there is none (noConfiguration).
    virtual Result<RingStructure> activateConfiguration() = 0;
    virtual Result<void> deactivateConfiguration() = 0; // 0712
    virtual Result<void> startDataTransfer() = 0;       // 0701
    virtual Result<void> stopDataTransfer() = 0;        // 0702
    virtual void alarmStop() = 0; // 1303: outputs to 0 and the bus stopped, from every state
    // 0713: a segment is taken out of the data cycles, with everything behind it. It stays out until it is
    // switched on, or another configuration is created or loaded. Refused (unknownDevice): no such segment.
    virtual Result<void> switchSegment(int segment, bool on) = 0;
    virtual Result<void> confirmDiagnostics() = 0; // 0760

    // Downloads it: the master stores it, and activates it at the next 0711.
    virtual Result<void> keepConfiguration(const KeptConfiguration &configuration) = 0;
    virtual Result<KeptConfiguration> keptConfiguration() = 0; // 030B; refused (noConfiguration)
};

} // namespace codewheel
