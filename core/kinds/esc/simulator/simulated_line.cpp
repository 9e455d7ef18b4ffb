// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/simulated_line.h"

namespace codewheel {

std::vector<EscEncoderPlan> trainingLine()
{
    return {
        {.address = {0x03}, .raw = 12'345, .revolutionsPerMinute = 10, .serialNumber = 0x0012'D591},
        {.address = {0x05}, .raw = 0x1235, .serialNumber = 0x0012'D5A4, .operatingTime = 12'876},
        {.address = {0x12}, .raw = 20'000'000, .revolutionsPerMinute = -6, .serialNumber = 0x0013'0008},
    };
}

SimulatedLine::SimulatedLine(const std::vector<EscEncoderPlan> &encoders, std::uint32_t seed)
    : m_encoders(encoders.begin(), encoders.end())
    , m_wire(seed)
{}

void SimulatedLine::begin(const SerialSettings &settings, Instant now)
{
    const std::scoped_lock lock(m_mutex);
    m_settings = settings;
    m_wire.clear();
    m_heard.clear();
    m_cycles = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

void SimulatedLine::setBaudRate(int baudRate)
{
    const std::scoped_lock lock(m_mutex);
    m_settings.baudRate = baudRate;
}

SerialSettings SimulatedLine::settings() const
{
    const std::scoped_lock lock(m_mutex);
    return m_settings;
}

void SimulatedLine::send(const QByteArray &bytes, Instant now)
{
    const std::scoped_lock lock(m_mutex);
    if (!m_unplugged)
        m_wire.send(bytes, LineWire::master, now, m_settings);
}

SimulatedLine::Arrival SimulatedLine::advance(Instant until)
{
    const std::scoped_lock lock(m_mutex);
    Instant now = until;
    while (m_heard.isEmpty() && m_wire.nextEnd().value_or(until + Instant{1}) <= until) {
        const LineWire::Ended character = m_wire.take();
        now = character.first;
        turnShaftsTo(now);
        deliver(character);
    }
    if (m_heard.isEmpty()) {
        turnShaftsTo(until);
        return {{}, until};
    }
    return {std::exchange(m_heard, {}), now};
}

std::size_t SimulatedLine::waiting() const
{
    const std::scoped_lock lock(m_mutex);
    return m_wire.waiting();
}

std::optional<Instant> SimulatedLine::nextEnd() const
{
    const std::scoped_lock lock(m_mutex);
    return m_wire.nextEnd();
}

std::optional<Instant> SimulatedLine::runEnd() const
{
    const std::scoped_lock lock(m_mutex);
    return m_wire.runEnd();
}

void SimulatedLine::turnShaftsTo(Instant now)
{
    using namespace std::chrono;
    for (; m_cycles < duration_cast<milliseconds>(now).count(); ++m_cycles)
        for (SimulatedEscEncoder &encoder : m_encoders)
            encoder.cycle();
}

// Start, data and parity bits determine whether a character can be read; one stop bit less does no harm.
bool SimulatedLine::fitsEncoders() const
{
    return m_settings.dataBits == 8 && m_settings.parity == SerialSettings::Parity::none;
}

void SimulatedLine::deliver(const LineWire::Ended &ended)
{
    const LineWire::Character &character = ended.second;
    if (character.sender == LineWire::master)
        tellEncoders(ended);
    if (m_unplugged || (character.sender == LineWire::master && !m_wire.faults().echo))
        return;
    const bool isRead = !character.spoiled && character.baudRate == m_settings.baudRate &&
                        (character.sender == LineWire::master || fitsEncoders());
    m_heard += isRead ? character.byte : m_wire.junk();
}

void SimulatedLine::tellEncoders(const LineWire::Ended &ended)
{
    const auto &[now, character] = ended;
    for (std::size_t i = 0; i < m_encoders.size(); ++i) {
        SimulatedEscEncoder &encoder = m_encoders[i];
        if (character.spoiled || character.baudRate != encoder.baudRate() || !fitsEncoders()) {
            encoder.hearJunk();
            continue;
        }
        if (const auto reply = encoder.hear(character.byte))
            m_wire.send(reply->bytes, static_cast<int>(i), now + m_answerDelay,
                        SerialSettings{.baudRate = reply->baudRate});
    }
}

bool SimulatedLine::wait(Instant atMost)
{
    std::unique_lock lock(m_mutex);
    m_woken.wait_for(lock, atMost, [this] { return m_wake || m_unplugged; });
    return !std::exchange(m_wake, false) && !m_unplugged;
}

void SimulatedLine::waitForWake(Instant atMost)
{
    std::unique_lock lock(m_mutex);
    m_woken.wait_for(lock, atMost, [this] { return m_wake; });
    m_wake = false;
}

bool SimulatedLine::takeWake()
{
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_wake, false);
}

void SimulatedLine::wake()
{
    {
        const std::scoped_lock lock(m_mutex);
        m_wake = true;
    }
    m_woken.notify_all();
}

void SimulatedLine::setFaults(const LineFaults &faults)
{
    const std::scoped_lock lock(m_mutex);
    m_wire.setFaults(faults);
}

LineFaults SimulatedLine::faults() const
{
    const std::scoped_lock lock(m_mutex);
    return m_wire.faults();
}

void SimulatedLine::setAnswerDelay(Instant delay)
{
    const std::scoped_lock lock(m_mutex);
    m_answerDelay = delay;
}

void SimulatedLine::setUnplugged(bool unplugged)
{
    {
        const std::scoped_lock lock(m_mutex);
        m_unplugged = unplugged;
    }
    m_woken.notify_all();
}

bool SimulatedLine::isUnplugged() const
{
    const std::scoped_lock lock(m_mutex);
    return m_unplugged;
}

std::vector<LineAddress> SimulatedLine::addresses() const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<LineAddress> addresses;
    for (const SimulatedEscEncoder &encoder : m_encoders)
        addresses.push_back(encoder.address());
    return addresses;
}

void SimulatedLine::setSilent(bool silent)
{
    const std::scoped_lock lock(m_mutex);
    for (SimulatedEscEncoder &encoder : m_encoders)
        encoder.condition().mute = silent;
}

} // namespace codewheel
