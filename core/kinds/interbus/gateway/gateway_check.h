// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/check_outcome.h"
#include "kinds/interbus/gateway/gateway_map.h"
#include "kinds/interbus/gateway/word_reading.h"

#include <QStringList>

#include <map>

namespace codewheel {

enum class GatewayStep : std::uint8_t {
    found,     // the host is known, the serial port is there
    connected, //
    answered,  // by the unit
    inArea,    // all IN registers of the project exist
    outArea,   // all OUT registers exist and can be read back
    status,    // the status register says that the ring runs
    word,      // what the registers of a device show is a word it can have sent
    map,       // no other register map near this one gives words that fit as well
    closing,   // only where it closes the connection after each answer
};
QString gatewayStepKey(GatewayStep step); // language-neutral: "inArea"

// The registers of one device, and what they show.
struct DeviceRegisters
{
    NodeId place{};
    RegisterBlock in{}; // count 0: it has none
    RegisterBlock out{};
    std::vector<Register> inNow{};
    std::vector<Register> outNow{};      // empty: not read
    bool stoodStill = false;             // two reads of IN agreed
    std::vector<WordReading> readings{}; // of IN; empty: it has none

    friend bool operator==(const DeviceRegisters &, const DeviceRegisters &) = default;
};

// What a step of GatewayCheck found.
struct GatewayFinding
{
    GatewayStep step = GatewayStep::found;
    CheckOutcome outcome = CheckOutcome::skipped;
    QString sentence{};
    NodeId place{};                         // of a word
    std::optional<Refusal> why{};           // of a failed one, if it has a refusal
    std::optional<DeviceRegisters> shown{}; // of a word
    std::map<QString, QString> proposed{};  // settings that fit better, by name

    friend bool operator==(const GatewayFinding &, const GatewayFinding &) = default;
};

// A device of the project behind the gateway, and what is known of it.
struct CheckedDevice
{
    RingDevice participant;
    SendingEncoder sender{};
};

// Where the gateway has the words of these devices, by the settings; refused if that cannot be.
Result<GatewayMap> mapOf(const std::vector<CheckedDevice> &devices, const GatewaySettings &settings);

// Tests a gateway step by step: whether it can be reached, whether its registers are long enough for the
// project, and whether what they show are words of these encoders. Writes nothing, ever. Each next() does one
// step, so its caller can show what was found so far, and stop. Used by the connection page and the command
// line.
class GatewayCheck
{
public:
    // `port` must outlive this and is used by nobody else meanwhile. `only`: the one device whose word is
    // looked at ("read now"); empty: all.
    GatewayCheck(RegisterPort &port, const GatewaySettings &settings, std::vector<CheckedDevice> devices,
                 std::optional<NodeId> only = std::nullopt);
    ~GatewayCheck(); // closes the port
    Q_DISABLE_COPY_MOVE(GatewayCheck)

    bool isDone() const { return m_next == m_steps.size(); }
    std::size_t steps() const { return m_steps.size(); }
    // What next() will do, for showing progress: "Address", "Word of 3.0". Not done yet.
    QString nextText() const;
    GatewayFinding next();
    void interrupt() { m_port.interrupt(); } // ends a step that waits. Any thread

private:
    struct Step
    {
        GatewayStep step;
        std::size_t device = 0; // of a word
    };

    NodeId placeOf(const Step &step) const;
    GatewayFinding find();
    GatewayFinding connect();
    GatewayFinding ask();
    GatewayFinding checkIn();
    GatewayFinding checkOut();
    GatewayFinding readStatus();
    GatewayFinding judgedStatus(Register status);
    void recognise(GatewayFinding &finding);
    bool isOfCodewheel();
    bool tellsClosing() const;
    GatewayFinding closing() const;
    GatewayFinding checkWord(std::size_t device);
    GatewayFinding checkMap();
    Result<std::vector<Register>> readIn(int lower);
    Result<std::vector<Register>> readAround(int &first);

    GatewayFinding withOutcome(CheckOutcome outcome, const QString &sentence) const;
    GatewayFinding passed(const QString &sentence) const;
    GatewayFinding failed(const Refusal &why, const QString &more = {});
    GatewayFinding skipped(const QString &sentence) const;
    // Several times, as the settings say.
    Result<void> read(RegisterArea area, const RegisterBlock &block, std::vector<Register> &to);
    Result<void> readAll(RegisterArea area, const std::vector<RegisterBlock> &blocks);
    using Blocks = const RegisterBlock &(GatewayMap::*)(std::size_t device) const;
    // Why an area cannot be read: it ends too early, or so many registers at once are more than it moves.
    GatewayFinding failedArea(const Refusal &why, RegisterArea area, Blocks of,
                              const std::vector<RegisterBlock> &blocks);
    QString whereItEnds(RegisterArea area, Blocks of);
    std::optional<int> mostInRead(RegisterArea area, const std::vector<RegisterBlock> &blocks);
    Result<void> readSteady(const RegisterBlock &block, DeviceRegisters &to);
    GatewayFinding judged(DeviceRegisters shown, const SendingEncoder &sender) const;

    RegisterPort &m_port;
    GatewaySettings m_settings; // what is found to be less than set holds for the steps that follow
    const std::vector<CheckedDevice> m_devices;
    std::vector<Step> m_steps;
    std::size_t m_next = 0;
    Result<GatewayMap> m_map;
    Result<void> m_opened;
    bool m_isOver = false; // nothing further can be found out: no connection, or stopped
};

} // namespace codewheel
