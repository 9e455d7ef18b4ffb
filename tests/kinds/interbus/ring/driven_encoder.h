// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/k3/k3_driver.h"
#include "kinds/interbus/simulator/simulated_k3.h"

#include <map>
#include <memory>
#include <optional>

namespace codewheel {

// A driver and the simulated encoder it drives, word for word and without a ring, so that a test can disturb
// each single cycle and compare what the driver reports with what the encoder has.
class DrivenEncoder
{
public:
    DrivenEncoder(QStringView device, std::unique_ptr<SimulatedK3> encoder);

    SimulatedK3 &encoder() { return *m_encoder; }
    K3Driver &driver() { return m_driver; }
    Word in() const { return m_in; }
    Word out() const { return m_out; }
    const std::optional<Outcome> &outcome() const { return m_outcome; }
    int countedWrites() const { return m_eepromWrites; }

    // Tells the driver what the encoder has.
    void tellAll();
    void tell(Parameter parameter, std::int64_t value);
    void begin(const Job &job, Pace pace = Pace::byItself);
    void cycle(); // 1 ms
    void cycles(int count);
    // Runs until the job has ended; returns the number of cycles, or nothing if it does not end within 10 s.
    std::optional<int> finish();

    std::int64_t actual(Parameter parameter) const;
    EncoderState state() const;
    std::optional<CamProgram> knownCams(unsigned program) const;
    // What the outcome reports as written, and what is known, is what the encoder has; OUT is 0.
    void expectTruth() const;

private:
    void collect();

    std::unique_ptr<SimulatedK3> m_encoder;
    const DeviceDescription &m_device;
    K3Driver m_driver;
    Word m_in = 0;
    Word m_out = 0;
    Instant m_now{};
    std::optional<Outcome> m_outcome;
    std::map<Parameter, Known> m_known;
    std::map<unsigned, KnownCams> m_cams;
    int m_eepromWrites = 0;
};

std::unique_ptr<SimulatedK3> frabaK3();
std::unique_ptr<SimulatedK3> baumerK3();

} // namespace codewheel
