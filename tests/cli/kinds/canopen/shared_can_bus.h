// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "tests/cli/cli_run.h"

namespace codewheel {

// Calls that share the simulated CAN bus, in virtual time.
class SharedCanBus
{
public:
    explicit SharedCanBus(
        const std::vector<canopen::CanopenEncoderPlan> &encoders = canopen::trainingEncoders())
        : m_plant(encoders)
    {}

    // `line` may contain --link canopen:training with settings, and --ledger.
    CliRun runLine(const QString &line, const Person &person = {});
    canopen::SimulatedCanopenPlant &plant() { return m_plant; }
    Catalog &catalog() { return m_catalog; }
    // Of the encoder that is node 6.
    std::uint64_t eepromWritesOf6();
    canopen::NmtState stateOf6();

private:
    Catalog m_catalog = Catalog::builtIn();
    canopen::SimulatedCanopenPlant m_plant;
};

} // namespace codewheel
