// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/simulated_esc_line.h"

namespace codewheel {

std::vector<EscEncoderPlan> trainingLine()
{
    return {
        {.address = {0x03}, .raw = 12'345, .revolutionsPerMinute = 10, .serialNumber = 0x0012'D591},
        {.address = {0x05}, .raw = 0x1235, .serialNumber = 0x0012'D5A4, .operatingTime = 12'876},
        {.address = {0x12}, .raw = 20'000'000, .revolutionsPerMinute = -6, .serialNumber = 0x0013'0008},
    };
}

SimulatedEscLine::SimulatedEscLine(const std::vector<EscEncoderPlan> &encoders, std::uint32_t seed)
    : m_encoders(encoders.begin(), encoders.end())
    , m_wire(seed)
{}

void SimulatedEscLine::begin(const SerialSettings &settings, Instant now)
{
    const std::scoped_lock lock(m_mutex);
    m_settings = settings;
    m_wire.clear();
    m_heard.clear();
    m_cycles = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

void SimulatedEscLine::setBaudRate(int baudRate)
{
    const std::scoped_lock lock(m_mutex);
    m_settings.baudRate = baudRate;
}

SerialSettings SimulatedEscLine::settings() const
{
    const std::scoped_lock lock(m_mutex);
    return m_settings;
}

void SimulatedEscLine::send(const QByteArray &bytes, Instant now)
{
    const std::scoped_lock lock(m_mutex);
    if (!m_unplugged)
        m_wire.send(bytes, EscLineWire::master, now, m_settings);
}

SimulatedEscLine::Arrival SimulatedEscLine::advance(Instant until)
{
    const std::scoped_lock lock(m_mutex);
    Instant now = until;
    while (m_heard.isEmpty() && m_wire.nextEnd().value_or(until + Instant{1}) <= until) {
        const EscLineWire::Ended character = m_wire.take();
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

std::size_t SimulatedEscLine::waiting() const
{
    const std::scoped_lock lock(m_mutex);
    return m_wire.waiting();
}

std::optional<Instant> SimulatedEscLine::nextEnd() const
{
    const std::scoped_lock lock(m_mutex);
    return m_wire.nextEnd();
}

std::optional<Instant> SimulatedEscLine::runEnd() const
{
    const std::scoped_lock lock(m_mutex);
    return m_wire.runEnd();
}

void SimulatedEscLine::turnShaftsTo(Instant now)
{
    using namespace std::chrono;
    for (; m_cycles < duration_cast<milliseconds>(now).count(); ++m_cycles)
        for (SimulatedEscEncoder &encoder : m_encoders)
            encoder.cycle();
}

// Start, data and parity bits determine whether a character can be read; one stop bit less does no harm.
bool SimulatedEscLine::fitsEncoders() const
{
    return m_settings.dataBits == 8 && m_settings.parity == SerialSettings::Parity::none;
}

void SimulatedEscLine::deliver(const EscLineWire::Ended &ended)
{
    const EscLineWire::Character &character = ended.second;
    if (character.sender == EscLineWire::master)
        tellEncoders(ended);
    if (m_unplugged || (character.sender == EscLineWire::master && !m_wire.faults().echo))
        return;
    const bool isRead = !character.spoiled && character.baudRate == m_settings.baudRate &&
                        (character.sender == EscLineWire::master || fitsEncoders());
    m_heard += isRead ? character.byte : m_wire.junk();
}

void SimulatedEscLine::tellEncoders(const EscLineWire::Ended &ended)
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

bool SimulatedEscLine::wait(Instant atMost)
{
    std::unique_lock lock(m_mutex);
    m_woken.wait_for(lock, atMost, [this] { return m_wake || m_unplugged; });
    return !std::exchange(m_wake, false) && !m_unplugged;
}

void SimulatedEscLine::waitForWake(Instant atMost)
{
    std::unique_lock lock(m_mutex);
    m_woken.wait_for(lock, atMost, [this] { return m_wake; });
    m_wake = false;
}

bool SimulatedEscLine::takeWake()
{
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_wake, false);
}

void SimulatedEscLine::wake()
{
    {
        const std::scoped_lock lock(m_mutex);
        m_wake = true;
    }
    m_woken.notify_all();
}

void SimulatedEscLine::setFaults(const EscLineFaults &faults)
{
    const std::scoped_lock lock(m_mutex);
    m_wire.setFaults(faults);
}

EscLineFaults SimulatedEscLine::faults() const
{
    const std::scoped_lock lock(m_mutex);
    return m_wire.faults();
}

void SimulatedEscLine::setAnswerDelay(Instant delay)
{
    const std::scoped_lock lock(m_mutex);
    m_answerDelay = delay;
}

void SimulatedEscLine::setUnplugged(bool unplugged)
{
    {
        const std::scoped_lock lock(m_mutex);
        m_unplugged = unplugged;
    }
    m_woken.notify_all();
}

bool SimulatedEscLine::isUnplugged() const
{
    const std::scoped_lock lock(m_mutex);
    return m_unplugged;
}

std::vector<EscLineAddress> SimulatedEscLine::addresses() const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<EscLineAddress> addresses;
    for (const SimulatedEscEncoder &encoder : m_encoders)
        addresses.push_back(encoder.address());
    return addresses;
}

void SimulatedEscLine::setSilent(bool silent)
{
    const std::scoped_lock lock(m_mutex);
    for (SimulatedEscEncoder &encoder : m_encoders)
        encoder.condition().mute = silent;
}

} // namespace codewheel
