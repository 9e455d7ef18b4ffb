// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/bus_access.h"
#include "cli/kinds/esc/esc_line_link.h"
#include "kinds/esc/line/esc_line_session.h"
#include "serial/byte_link.h"

#include <functional>
#include <memory>

namespace codewheel {

class SerialPortLink;

// A serial line of a call. It is opened, in Watch, when it is first needed. A simulated line has virtual
// time, so that whatever it does is there at once; a real one takes its time.
class EscLineAccess final : public BusAccess
{
public:
    // The catalog must outlive it.
    EscLineAccess(std::unique_ptr<ByteLink> link, const EscLineLink &settings, const Catalog &catalog,
                  BusId id = firstLine);

    // To the port that is named, or to a new simulated line.
    static std::unique_ptr<EscLineAccess> to(const EscLineLink &link, const Catalog &catalog, BusId id);

    EscLineSession &line() const { return *m_session; }
    Checked<void> open() override;
    Hindrances hindrances() const override;
    const EscLineLink &link() const { return m_link; }
    esc::ExplainOptions explainOptions() const { return m_link.explainOptions(); }

    std::optional<Complaint> whyNot(const Subcommand &command) const override;
    std::optional<NodeId> placeTyped(const QString &text) const override;
    bool knowsItsPlaces() const override { return false; }
    bool isMeant(const QString &typed) const override;
    Complaint notAPlace(const QString &typed) const override;
    QString somePlaces() const override;
    // The encoder at the address, polled as the device that --device or the project names, and in contact: it
    // shows its position, and has reported its serial number if it knows one. Refused if none answers.
    Checked<EncoderSession *> encoder(const Call &call, NodeId node, bool namesIt) override;
    Checked<EncoderSession *> encoder(EscLineAddress address, const QString &deviceKey);
    Checked<void> contact(const Call &call, const ProjectDevice &planned) override;
    Checked<void> lookFor(const Call &call, const ProjectDevice &planned) override
    {
        return contact(call, planned);
    }

    Complaint complaint(const Refusal &why) const override;
    void prepare(const Job &job) override; // reading needs no Operate
    void lookAgain(const EncoderSession &encoder) override;
    std::unique_ptr<JobTrace> trace(const std::vector<const EncoderSession *> &encoders) override;
    bool tellsVersion() const override { return true; } // it is read together with the identity
    QString versionOf(const EncoderSession &encoder) override;
    Checked<void> readBefore(const Call &call, EncoderSession &encoder,
                             const ParameterValues &wanted) override; // only if it answers
    Checked<void> prepareWrite(const Call &call, EncoderSession &encoder,
                               const ParameterValues &wanted) override;
    std::unique_ptr<WriteAccount> account(const EncoderSession &encoder, const ParameterValues &wanted,
                                          const FinishedJob &job) const override;
    QString whereItIsNow(const EncoderSession &encoder, const ParameterValues &wanted) const override;
    QStringList remarks(const Reading &reading) const override;
    QJsonObject remarksJson(const Reading &reading) const override;
    void addFigures(const Call &call, const EncoderSession &encoder, Answer &answer) const override;
    Checked<void> checkScan(const Call &call) const override;
    bool startThread() override;
    Checked<Answer> scan(const Call &call) override;
    bool hasFoundNobody() const override { return m_found.empty(); }
    void keepFound(const Call &call, Project &project) const override;
    Refusal whatIsLost() const override;

    // The port for programs; "training" for the simulated line.
    QString portKey() const;
    // Bytes received so far that are neither answers nor echo.
    std::uint64_t strayBytes() const;
    QString strayBytesText() const; // how many, and what that can mean; empty if there are none

private:
    EscLineAccess(const EscLineLink &settings, std::unique_ptr<EscLineSession> session);
    Checked<EncoderSession *> inContact(EncoderSession *encoder);
    Complaint noAnswerFrom(EscLineAddress address) const;
    Checked<void> determineFractionBits(Place place);
    bool waitUntil(const std::function<bool()> &isDone, Instant atMost);

    EscLineLink m_link;
    std::unique_ptr<EscLineSession> m_session;
    std::vector<FoundEncoder> m_found;      // by the search
    const SerialPortLink *m_port = nullptr; // of the session; null: it uses none
    std::optional<Refusal> m_notOpened;     // the reason
};

} // namespace codewheel
