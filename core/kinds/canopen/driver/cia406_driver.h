// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/driver/node_job.h"
#include "kinds/canopen/protocol/kept_identifier.h"
#include "kinds/canopen/protocol/pdo_mappings_heard.h"

#include <optional>
#include <utility>
#include <vector>

namespace codewheel::canopen {

// Drives an encoder of CiA 406. Its position comes by PDO as the mapping says that was read from it, or by
// SDO where no PDO brings it; alarms and warnings are asked for now and then, and jobs are carried out in
// between, so that none of them waits for more than one request of the other.
class Cia406Driver final : public NodeDriver
{
public:
    // The description must outlive the driver.
    Cia406Driver(const DeviceDescription &device, int node, const NodeTimes &settings = {});

    const Reading &reading() const override { return m_encoder.reading; }
    std::optional<NmtState> state() const override { return m_encoder.state(); }
    bool busy() const override { return m_job.has_value(); }
    void setKnown(const std::vector<Known> &known) override { m_encoder.values.set(known); }
    Result<void> begin(JobId id, const Job &job, Pace pace, Instant now) override;
    void mayStopNode(bool may) override { m_mayStop = may; }
    void proceed() override;
    void cancel(OnCancel how, Instant now) override;
    void stop(const Refusal &why, Instant now) override;
    std::optional<Instant> wakesAt() const override;
    std::optional<NodeRequest> next(Instant now) override;
    void answered(const NodeRequest &request, const SdoOutcome &outcome, Instant now) override;
    void observe(const SdoRequest &request, const SdoOutcome &outcome, Instant now) override;
    void take(const CanFrame &frame, Instant now) override;
    void hear(const SdoFrame &sdo) override;
    void takeUsualMapping() override;
    void lost(Instant now) override;
    bool mayBeSilent() const override { return m_job && m_job->mayBeSilent(); }
    int node() const override { return m_encoder.node; }
    std::optional<std::uint32_t> deviceType() const override { return m_deviceType; }
    std::span<const PdoMapping> transmitPdos() const override { return m_pdos; }
    std::span<const KeptIdentifier> keptIdentifiers() const override { return m_kept; }
    std::vector<Event> takeEvents() override { return std::exchange(m_encoder.events, {}); }
    std::vector<Message> takeMessages() override { return std::exchange(m_encoder.messages, {}); }

private:
    enum class Asks : std::uint8_t { nobody, poll, job };

    std::optional<NodeRequest> jobRequest(Instant now);
    std::optional<NodeRequest> pollRequest(Instant now);
    std::optional<SdoObject> polled(Instant now);
    std::optional<SdoObject> toGetToKnow() const;
    bool isPositionByPdo(Instant now) const;
    bool mayPoll() const;
    void getToKnow();
    void endJob();
    void count(const SdoOutcome &outcome, Instant now);
    void fallSilent(Instant now, int tries);
    void pollAnswered(SdoObject object, const SdoOutcome &outcome, Instant now);
    void gotToKnow(SdoObject object, const SdoOutcome &outcome, Instant now);
    void noteWrite(SdoObject object, bool isDone);
    bool wantsType() const;
    bool waitsForType() const;
    void takeType(const SdoOutcome &outcome, Instant now);
    Refusal otherProfile() const; // than that of encoders
    void noteMappings();
    void takeSerialNumber();
    void takeIdentifier(SdoObject object, const SdoOutcome &outcome, Instant now);
    void takePdo(const CanFrame &frame, Instant now);
    void takeValues(const PdoMapping &pdo, const CanFrame &frame, Instant now);
    void forgetValues();

    NodeEncoder m_encoder;
    std::optional<NodeJob> m_job;
    bool m_mayStop = false;
    Asks m_asks = Asks::nobody; // whose request is under way
    bool m_wasPoll = false;     // the last request
    std::vector<PdoMapping> m_pdos;
    std::vector<PdoMapping> m_read; // those of them that were read, and are on
    PdoMappingsHeard m_heard;
    std::optional<PdoMapping> m_usual{}; // empty: the user has not said so
    std::vector<SdoObject> m_toKnow;     // once, when it answers
    std::vector<KeptIdentifier> m_kept;
    std::vector<KeptIdentifier> m_keptTold; // since it is this encoder
    std::optional<std::uint32_t> m_deviceType{};
    bool m_isTypeAsked = false;        // since it got to know the node
    std::optional<SdoObject> m_mute{}; // of these: it has not answered for it
    std::vector<SdoObject> m_bits;     // alarms and warnings, in turn
    std::size_t m_nextBits = 0;
    Instant m_positionDue{};
    Instant m_bitsDue{};
    Instant m_silenceUntil{};
    std::optional<Instant> m_pdoAt{}; // the last one with a position
    std::optional<std::int64_t> m_serialNumber;
    int m_unanswered = 0; // in a row
    Instant m_now{};
};

} // namespace codewheel::canopen
