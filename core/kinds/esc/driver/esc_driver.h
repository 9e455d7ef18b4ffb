// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/driver/esc_agreement.h"
#include "kinds/esc/driver/esc_encoder.h"
#include "kinds/esc/driver/esc_job.h"
#include "kinds/esc/driver/esc_poll_plan.h"
#include "kinds/esc/driver/esc_request_driver.h"

#include <optional>
#include <utility>

namespace codewheel {

// Drives a Kübler encoder with the ESC protocol: asks for its position again and again, for warnings and
// alarms now and then, for its identity on first contact and after a silence, and carries out jobs between
// two positions. A position is never delayed by more than one request.
class EscDriver final : public RequestDriver
{
public:
    using Figures = EscPositionGuard::Figures;

    // The description must outlive the driver. Address 0, the master address: the only encoder of its line.
    EscDriver(const DeviceDescription &device, EscLineAddress address, EscSettings settings = {});

    const Reading &reading() const override { return m_encoder.reading; }
    bool busy() const override { return m_job.has_value(); }
    void setKnown(const std::vector<Known> &known) override { m_encoder.values.set(known); }
    Result<void> begin(JobId id, const Job &job, Pace pace, Instant now) override;
    void proceed() override;
    void cancel(OnCancel how, Instant now) override;
    void stop(const Refusal &why, Instant now) override;
    Instant positionInterval() const override { return m_encoder.settings.positionInterval; }
    std::optional<Instant> wakesAt() const override;
    std::optional<esc::Request> next(Instant now) override;
    void answered(const esc::Request &request, const esc::ExchangeResult &result, Instant now) override;
    EscLineAddress address() const override { return m_encoder.address; }
    std::optional<int> wantedBaudRate() const override { return m_encoder.wantedBaudRate; }
    std::vector<Event> takeEvents() override { return std::exchange(m_encoder.events, {}); }
    std::vector<Message> takeMessages() override { return std::exchange(m_encoder.messages, {}); }

    void setSettings(const EscSettings &settings);
    const EscSettings &settings() const { return m_encoder.settings; }
    // The rate used for this encoder, in Bd.
    void setLineBaudRate(int baudRate) override;
    // The other encoders of the line, with a name for the user: no job may move an encoder to one of their
    // addresses.
    void setTaken(const EscPlan::Taken &taken) override { m_encoder.taken = taken; }
    // What somebody else asked this encoder, e.g. at a terminal.
    void observe(const esc::Request &request, const esc::ExchangeResult &result, Instant now) override;

    void lost(Instant now) override;
    void setFractionBits(int bits) override { m_encoder.settings.fractionBits = bits; }
    void setSwapsWarningBytes(bool on) override { m_encoder.setSwapsWarningBytes(on); }

    const Figures &figures() const { return m_encoder.guard.figures(); }
    const QString &version() const { return m_encoder.version; }

private:
    enum class Asks : std::uint8_t { nobody, position, between, job };

    std::optional<esc::Request> position(Instant now);
    std::optional<esc::Request> other(Instant now);
    bool isJobTooLate(const esc::ExchangeResult &result, Instant now) const;
    void count(const esc::ExchangeResult &result, Instant now);
    void contact(Instant now);
    void positionAnswered(const esc::ExchangeResult &result, Instant now);
    void betweenAnswered(esc::Command command, const esc::ExchangeResult &result, Instant now);
    void betweenAgreed(esc::Command command, const esc::Answer &answer, Instant now);
    void endJob();

    EscEncoder m_encoder;
    EscPollPlan m_polls;
    EscAgreement m_between; // the reads of whatever is asked between two positions
    std::optional<EscJob> m_job;
    Asks m_asks = Asks::nobody;                 // whose request is under way
    bool m_wasPosition = false;                 // the last request was for the position
    Instant m_confirmed{};                      // the job, or its next step
    Instant m_answered{};                       // any request
    int m_unanswered = 0;                       // requests in a row
    int m_tries = 0;                            // how often these were sent
    std::optional<std::int64_t> m_serialNumber; // of the encoder currently there
    Instant m_now{};
};

} // namespace codewheel
