// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_session.h"
#include "kinds/esc/driver/esc_fraction_bits.h"
#include "kinds/esc/line/esc_line_command.h"
#include "kinds/esc/line/esc_line_event.h"
#include "kinds/esc/line/esc_line_outline.h"
#include "kinds/esc/line/esc_line_snapshot.h"
#include "kinds/esc/line/row_text.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "serial/byte_link.h"

#include <functional>
#include <memory>
#include <vector>

namespace codewheel {

class EscEncoderSession;

// A connected serial line as the window and the command line see it.
//
// In Watch only reads are sent: positions are polled, values may be read. Writing needs Operate.
class EscLineSession final : public BusSession<EscLineCommand, EscLineEvent, EscLineSnapshot, ByteLink>
{
    Q_OBJECT

public:
    // Null for a device that cannot be driven; the description outlives the driver.
    using DriverFactory =
        std::function<std::unique_ptr<RequestDriver>(const DeviceDescription &, EscLineAddress)>;

    // The catalog must outlive the session. `begin` is the date and time of the line's Instant 0.
    EscLineSession(std::unique_ptr<ByteLink> link, const Catalog &catalog, const QDateTime &begin,
                   DriverFactory makeDriver, QObject *parent = nullptr, BusId id = firstLine);

    // Opens the line; it is polled from then on. Encoders added while its thread is opening it are asked once
    // it is open.
    Result<void> open(const SerialSettings &settings, const esc::Timing &timing, Start start, Drive drive,
                      SleepWatch::Slept slept = SleepWatch::ofThisComputer);

    std::vector<DataCheck> dataChecks(NodeId node, const std::vector<Participant> &planned) const override;

    const SerialSettings &settings() const { return m_settings; }

    // Why an encoder at `own` cannot get the address `wanted`: another one of the line answers there, or at
    // the other reading of its digits. Empty: nothing is known of one.
    std::optional<Refusal> addressTaken(EscLineAddress wanted, EscLineAddress own) const;

    using AskedBus::add;
    Result<void> add(EscLineAddress address, const QString &deviceKey)
    {
        return add(address.node(), deviceKey);
    }
    const BusOutline &outline() const override { return m_outline; }
    const EscLineSnapshot::Device *shown(Place place) const; // null: no such device

    // The adapter that otherAdapterFound() reported is the right one: it is used from now on.
    void takeOtherAdapter() { post(line_command::TakeOtherAdapter{}); }
    // "Determine from device": reads what determines the format of its scaling factor; ends with
    // fractionBitsDetermined(). Sets nothing.
    Result<void> determineFractionBits(Place place);
    // Of the scaling factor, for all encoders, including those added later; what a job will send is worked
    // out with them.
    void setFractionBits(int bits);
    int fractionBits() const { return m_fractionBits; }
    // Whether the warnings of this encoder come with their two bytes in the other order (the manual's example
    // of E reads 0098 as 9800h). No effect without such an encoder.
    void setSwapsWarningBytes(Place place, bool on);
    // For putting requests and answers on this line into words.
    esc::ExplainOptions explainOptions() const;

    Result<void> mayStart(const Job &job, const QString &place) const override;
    void alarmStop() override;
    bool hasTerminal() const override { return true; }
    void scan(const ScanWish &wish) { post(line_command::Scan{wish}); }
    // Sends what was typed, once, in its turn; ends with typedAnswered, which says if it was refused.
    void send(const esc::Request &request);

Q_SIGNALS:
    void explainOptionsChanged();
    // The port is gone, and what is plugged in is not known to be its adapter (portOfOther): it is not used
    // unasked.
    void otherAdapterFound(const codewheel::Refusal &which);
    void fractionBitsDetermined(codewheel::Place place, const codewheel::Result<int> &bits);
    void alarmStopped(); // by alarmStop(): nothing may be sent automatically any more
    void passed(const codewheel::esc::EscLineRow &row); // what went over the line
    void typedAnswered(const codewheel::TypedAnswered &answer);
    void scanProgressed(const codewheel::ScanProgress &progress);
    void scanEnded(const codewheel::ScanEnded &result);

private:
    Message openedMessage() const override;
    Message closedMessage() const override;
    void complete(LineState &opened) const override { opened.lowLatency = link().lowLatency(); }
    void startAsking(NodeId node, const DeviceDescription &device) override;
    Result<void> mayAdd(NodeId node) const override;
    std::unique_ptr<AskedEncoder> makeEncoder(std::size_t device, NodeId node,
                                              const DeviceDescription &description) override;
    void carryOver(const AskedEncoder &before) override;
    void takeOther(const EscLineEvent &event) override;
    EscEncoderSession *its(NodeId node) const;
    std::vector<TypedWrite> writesOf(const esc::Request &request) const;
    void tellEnd(const TypedAnswered &answered);
    void tellTyped(Place place, const TypedAnswered &answered);

    const EscLineOutline m_outline;
    DriverFactory m_makeDriver;
    SerialSettings m_settings;
    int m_fractionBits = esc::defaultFractionBits;
    EscLineTraffic m_traffic;
};

} // namespace codewheel
