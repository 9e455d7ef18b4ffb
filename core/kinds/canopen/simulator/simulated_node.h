// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/can_participant.h"
#include "kinds/canopen/protocol/nmt.h"
#include "kinds/canopen/simulator/encoder_measurement.h"
#include "kinds/canopen/simulator/error_control.h"
#include "kinds/canopen/simulator/lss_slave.h"
#include "kinds/canopen/simulator/sdo_server.h"
#include "kinds/canopen/simulator/transmit_pdo.h"

#include <deque>

namespace codewheel::canopen {

// A CANopen encoder with its shaft on a simulated bus (CiA 301, 305 and 406). What it does where these are
// silent is marked as assumed.
class SimulatedNode : public CanParticipant, private SdoObjects
{
public:
    static constexpr Instant bootTime{50'000}; // from power or reset to boot-up (assumed)
    static constexpr Instant answerDelay{300}; // to SDO, LSS and guarding (assumed)

    explicit SimulatedNode(const CanopenEncoderPlan &plan);

    bool isOn() const override { return m_isOn; }
    int rate() const override { return m_rate; }
    const CanFrame *toSend() const override;
    void sent(const CanFrame &frame, Instant now) override;
    void take(const CanFrame &frame, Instant now) override;
    std::optional<Instant> wakesAt() const override { return m_isTouched ? m_now : m_wakes; }
    void proceed(Instant now) override;

    std::optional<int> node() const { return m_node; } // empty: it has none, or is off
    NmtState state() const { return m_state; }
    const ObjectDictionary &objects() const { return m_objects; }
    std::uint64_t eepromWrites() const { return m_eepromWrites; }
    const TurningShaft &shaft() const { return m_measurement.shaft(); }
    // The number that it has, or has stored where it is off; empty: none.
    std::optional<int> plannedNode() const { return m_node ? m_node : m_storedSettings.node; }
    std::uint16_t alarms() const { return m_alarms; }
    std::uint16_t warnings() const { return m_warnings; }
    bool isEepromBroken() const { return m_isEepromBroken; }
    const NodeQuirks &quirks() const { return m_plan.quirks; }

    // For the trainer. What it leads to is seen after the next proceed(), which wakesAt() asks for at once.
    TurningShaft &shaft();
    void setOn(bool on);                  // off, it forgets what is not stored; its shaft turns nevertheless
    void setAlarms(std::uint16_t alarms); // 6503h; each that is new is an EMCY
    void setWarnings(std::uint16_t warnings); // 6505h, those that its shaft does not make
    void setEepromBroken(bool broken) { m_isEepromBroken = broken; }
    void setQuirks(const NodeQuirks &quirks); // as of another make: it begins anew, with what is stored

private:
    using Written = tl::expected<void, AbortCode>;
    struct WriteRule;
    static const std::array<WriteRule, 10> writeRules;

    struct Outgoing
    {
        CanFrame frame;
        Instant due{};
    };
    struct Error
    {
        std::uint16_t code = 0;
        std::uint8_t bits = 0; // of 1001h

        friend bool operator==(const Error &, const Error &) = default;
    };

    tl::expected<std::vector<std::uint8_t>, AbortCode> read(SdoObject object) override;
    Written write(SdoObject object, Octets octets, bool isSizeTold) override;

    // In simulated_node_writes.cpp.
    Written clearErrors(const SimulatedObject &with);
    Written store(const SimulatedObject &with);
    Written restore(const SimulatedObject &with);
    Written setNode(const SimulatedObject &with);
    Written setPdo(const SimulatedObject &with);
    Written setOperatingParameters(const SimulatedObject &with);
    Written preset(const SimulatedObject &with);
    Written setCyclicTimer(const SimulatedObject &with);
    Written setWorkArea(const SimulatedObject &with);

    enum class Reset : std::uint8_t { node, communication };
    void restart(Reset what);
    void boot();
    void enter(NmtState state);
    void command(const NmtRequest &request);
    void answerRemote(std::uint32_t identifier);
    void answerLss(Octets data);
    void carryOut(LssSlave::Event event);
    void raise(const Error &error);
    void clear(const Error &error);
    void tellError(std::uint16_t code);
    std::uint32_t syncIdentifier() const { return m_objects.word(0x1005) & largestStandardId; }
    bool concerns(const CanFrame &frame) const;
    void pass(Instant now);
    void heed(const CanFrame &frame);
    void settle(); // after each event
    void measure();
    void offerPdos();
    std::optional<Instant> nextTime() const;
    void send(std::uint32_t identifier, Octets data, Instant delay = {});
    void wrote() { ++m_eepromWrites; }
    bool isSilent() const { return m_now < m_silentUntil; }
    bool isRunning() const { return m_isOn && m_state != NmtState::bootUp; }

    CanopenEncoderPlan m_plan;
    EncoderMeasurement m_measurement;
    ObjectDictionary m_objects;
    ObjectDictionary::Kept m_stored{};
    NodeSettings m_storedSettings;
    std::uint64_t m_eepromWrites = 0;
    bool m_isEepromBroken = false;

    bool m_isOn = true;
    bool m_isTouched = true;          // by the trainer
    bool m_isStarting = true;         // power has come
    std::optional<Instant> m_boots{}; // then it tells of boot-up
    std::optional<int> m_node{};
    NmtState m_state = NmtState::bootUp;
    int m_rate;
    std::optional<Instant> m_changesRate{};
    Instant m_now{};
    std::optional<Instant> m_wakes{};
    Instant m_silentUntil{};
    std::int64_t m_millisecondsOn = 0;
    std::uint16_t m_alarms = 0;
    std::uint16_t m_warnings = 0;
    std::vector<Error> m_errors{};

    SdoServer m_sdo;
    LssSlave m_lss;
    ErrorControl m_errorControl;
    std::array<TransmitPdo, transmitPdoCount> m_pdos{TransmitPdo(1), TransmitPdo(2)};
    std::deque<Outgoing> m_out{};
};

} // namespace codewheel::canopen
