// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/interbus/ring_access.h"
#include "kinds/interbus/gateway/gateway_check.h"
#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/gateway/sent_zeros.h"
#include "project/project.h"

#include <functional>

namespace codewheel {

class GatewayLink;

// complaintAbout() in the words of the command line, where those of the refusal are of the window.
Complaint complaintAtGateway(const Refusal &why);

// A ring of a call behind a gateway. Which devices it has is what the project says. It is opened, in Watch,
// when it is first needed, and takes its time; only while jobs run it is in Operate.
class GatewayAccess final : public RingAccess
{
public:
    // `project`: null if the call has none; then the ring cannot be opened. The catalog must outlive it.
    GatewayAccess(const GatewaySettings &gateway, const Project *project, BusId ring, const Catalog &catalog);

    const GatewaySettings &gateway() const { return m_gateway; }
    const std::vector<CheckedDevice> &devices() const { return m_devices; }
    SentZeros sentZeros() const;

    Checked<void> open() override;
    Hindrances hindrances() const override; // also whether its host can be reached
    std::optional<Complaint> whyNot(const Subcommand &command) const override;
    bool mayReachMaster() const override { return false; }
    std::vector<Place> knownPlaces() const override;
    // The ring is what the project says.
    Checked<void> checkStation(const Project &, const QString &) const override { return {}; }
    void useProject(const Call &, const Project &) override {}
    Checked<EncoderSession *> encoder(const Call &call, NodeId node, bool namesIt) override;
    Checked<void> contact(const Call &call, const ProjectDevice &planned) override;
    bool startThread() override;
    void prepare(const Job &job) override;
    void rest() override;
    Complaint complaint(const Refusal &why) const override;
    Checked<Answer> scan(const Call &call) override;
    Refusal whatIsLost() const override;

protected:
    std::shared_ptr<const LinkFigures> figures() const override; // of this moment; not beside its thread

private:
    struct Behind // the link is the session's
    {
        std::unique_ptr<RingSession> session;
        GatewayLink &link;
    };

    GatewayAccess(Behind behind, const GatewaySettings &gateway, const Project *project, BusId ring,
                  const Catalog &catalog);
    static Behind sessionBehind(const GatewaySettings &gateway, const Project *project, BusId ring,
                                const Catalog &catalog);
    void nameLabelled();
    void operate(bool on);
    void exchange(); // waits for one
    void waitUntil(const std::function<bool()> &isSo);
    Instant longestTurn() const;
    Checked<void> inContact(const Call &call, Place place);

    GatewayLink &m_link;
    const GatewaySettings m_gateway;
    std::vector<ProjectDevice> m_planned;
    std::vector<CheckedDevice> m_devices;
    const bool m_hasProject;
    std::optional<Refusal> m_notOpened; // the reason
    std::optional<Refusal> m_refusal;   // of the ring, the last one
    bool m_outIsUnknown = false;        // and nobody was told yet
    QObject m_scope;
};

} // namespace codewheel
