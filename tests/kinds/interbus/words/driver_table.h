// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/interbus/k3/k3_driver.h"
#include "kinds/interbus/la66/la66_driver.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

// The IN words of an encoder standing still.
inline constexpr Word pos = 0x0000'3039;          // 12345
inline constexpr Word posInCamMode = 0x0030'3900; // the same in cam mode, no cam on

// One bus cycle as in the manuals' tables: the OUT word the driver must have put there, and the IN word
// beside it.
struct Row
{
    Word out;
    Word in;
};

// From the built-in catalog.
const DeviceDescription &describe(QStringView key);

// Runs a driver on a table instead of a bus: plays rows and collects what the driver reports. 1 cycle = 1 ms.
class DriverTable
{
public:
    explicit DriverTable(QStringView device, K3Timing timing = {.settle = Instant{0}});
    explicit DriverTable(La66Timing timing); // a TR LA-66

    CyclicDriver &driver() { return *m_driver; }
    void tell(Parameter parameter, std::int64_t value);
    // The job begins at the words of the last row; before the first, at 00000000 / 00000000.
    Result<void> begin(const Job &job, Pace pace = Pace::byItself);
    // Each row is one cycle; a wrong OUT is a test failure that names the row.
    void play(const std::vector<Row> &rows);
    void repeat(int cycles, Row row);

    const std::optional<Outcome> &outcome();
    const Progress &progress();
    std::optional<std::int64_t> known(Parameter parameter);
    std::optional<Evidence> evidence(Parameter parameter);
    std::optional<KnownCams> cams(unsigned program);
    int eepromWrites();

private:
    void collect();
    const Known *find(Parameter parameter);

    std::unique_ptr<CyclicDriver> m_driver;
    std::vector<Known> m_told;
    Word m_out = 0;
    Word m_in = 0;
    Instant m_now{};
    std::optional<Outcome> m_outcome;
    Progress m_progress;
    std::vector<Known> m_known;
    std::map<unsigned, KnownCams> m_cams;
    int m_eepromWrites = 0;
};

} // namespace codewheel
