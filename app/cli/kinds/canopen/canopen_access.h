// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/bus_access.h"
#include "cli/call/stop_signals.h"
#include "cli/kinds/canopen/canopen_link.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/described_node.h"
#include "kinds/canopen/protocol/first_pdos_heard.h"

#include <functional>
#include <memory>

namespace codewheel {

class SlcanLink;

// What answered or was heard on the bus.
struct NodeOnBus
{
    CanopenSnapshot::Node heard{};
    std::optional<canopen::FoundNode> asked{}; // empty: it was not asked, or did not answer
};

// A CAN bus of a call. It is opened, in Watch, when it is first needed, and switched to Operate, which is
// said, for what sends. The simulated bus has virtual time.
class CanopenAccess : public BusAccess
{
public:
    // The catalog must outlive it.
    CanopenAccess(std::unique_ptr<CanLink> link, const CanopenLink &settings, const Catalog &catalog,
                  BusId id = firstCanBus);

    // To what is named, or to a new simulated bus.
    static std::unique_ptr<CanopenAccess> to(const CanopenLink &link, const Catalog &catalog, BusId id);

    CanopenSession &session() const { return *m_session; }
    const CanopenLink &link() const { return m_link; }
    Checked<void> open() override;
    // The same, in Operate: nothing keeps frames from being sent. It listens first; where nothing is heard,
    // the user is asked, or told where nobody can be asked.
    Checked<void> openToSend(const Call &call);
    // To listen only. What is to be said of the adapter is said.
    Checked<void> openToListen(const Call &call);
    // Before something is sent that was asked about meanwhile: another master may be at work by now.
    Checked<void> listenAgain();
    Hindrances hindrances() const override;

    std::optional<Complaint> whyNot(const Subcommand &command) const override;
    std::optional<NodeId> placeTyped(const QString &text) const override;
    bool knowsItsPlaces() const override { return false; }
    bool isMeant(const QString &typed) const override;
    Complaint notAPlace(const QString &typed) const override;
    QString somePlaces() const override;
    // The node as the device that --device or the project names, or else as its device type says. For a
    // command that only listens: as soon as it is heard. For others: it has answered, and shows its position.
    Checked<EncoderSession *> encoder(const Call &call, NodeId node, bool namesIt) override;
    Checked<void> contact(const Call &call, const ProjectDevice &planned) override;
    Checked<void> lookFor(const Call &call, const ProjectDevice &planned) override
    {
        return contact(call, planned);
    }

    bool startThread() override;
    Complaint complaint(const Refusal &why) const override;
    void listenBefore(const EncoderSession &encoder, const Job &job) override;
    void prepare(const Job &job) override;
    void lookAgain(const EncoderSession &encoder) override;
    std::unique_ptr<JobTrace> trace(const std::vector<const EncoderSession *> &encoders) override;
    QStringList remarks(const Reading &reading) const override;
    QJsonObject remarksJson(const Reading &reading) const override;
    void addFigures(const Call &call, const EncoderSession &encoder, Answer &answer) const override;
    Checked<void> checkScan(const Call &call) const override;
    Checked<Answer> scan(const Call &call) override;
    bool hasFoundNobody() const override { return m_found.empty(); }
    void keepFound(const Call &call, Project &project) const override;
    Refusal whatIsLost() const override;

    // The link for programs; "training" for the simulated bus.
    virtual QString linkKey() const;
    // As long as it lives, Ctrl+C ends what is done by hand: what has not been sent is not, and what was is
    // waited for.
    class ByHand
    {
    public:
        explicit ByHand(CanopenAccess &bus);
        ~ByHand();
        ByHand(const ByHand &) = delete;
        ByHand &operator=(const ByHand &) = delete;

    private:
        CanopenAccess &m_bus;
    };
    enum class WhenStopped : std::uint8_t { ends, goesOn };

    // What the node tells, as far as a description of the catalog needs it to be recognised.
    Checked<canopen::ToldIdentity> identityOf(const Call &call, int node);
    // By hand, in Operate, each to its end. Refused after Ctrl+C, unless it `goesOn`, as to find out what
    // became of a write; and where more than one answer comes.
    Checked<canopen::SdoOutcome> transfer(const canopen::SdoRequest &request,
                                          WhenStopped stopped = WhenStopped::ends);
    Checked<canopen::LssOutcome> configure(const canopen::LssRequest &request,
                                           WhenStopped stopped = WhenStopped::ends);
    Checked<CanFate> send(const CanFrame &frame);
    // Whether the rate of the link can be another one: an adapter has its own, an interface that of the
    // system.
    bool canChangeRate() const { return m_adapter != nullptr; }
    // Opened anew at this rate, in Operate.
    Checked<void> changeRate(int rate);
    // Of the node with this number there are two.
    std::optional<Complaint> whetherDoubled(int node) const;
    // Nobody acknowledges what is sent, so it never ends.
    bool isAlone() const;
    bool mayBeAlone() const;
    Complaint aboutNobody() const; // who acknowledges
    // Only frames of 29 bits were heard: there is nobody to send anything to, as far as the user does
    // not say otherwise.
    std::optional<Complaint> whetherOnlyJ1939() const;
    // With the load of the bus, where it may be why something does not come.
    Complaint besideLoad(Complaint told) const;
    // Why what was waited for did not come.
    Complaint whyNothingCame() const;
    // False: the link is gone, nobody acknowledges, it was stopped, or it did not become so.
    bool waitUntil(const std::function<bool()> &isDone, Instant atMost,
                   WhenStopped stopped = WhenStopped::ends);

protected:
    CanopenAccess(const CanopenLink &settings, std::unique_ptr<CanopenSession> session);

private:
    Checked<void> whetherHeldBack() const;
    void tellRemark(const Call &call) const;
    Checked<void> listenFirst(const Call &call);
    Checked<void> open(CanopenSession::Start start);
    bool isStopped();
    Complaint aboutOpening(const Refusal &why) const;
    QString howToAgree(const Refusal &why) const;
    Checked<QString> deviceAt(const Call &call, CanopenAddress address);
    Checked<EncoderSession *> heard(EncoderSession *encoder);
    Checked<EncoderSession *> inContact(EncoderSession *encoder);
    int showing(const Reading &reading) const; // the node; 0: none of this bus

    CanopenLink m_link;
    std::unique_ptr<CanopenSession> m_session;
    std::vector<NodeOnBus> m_found; // by the search
    canopen::FirstPdosHeard m_firstPdos;
    SlcanLink *m_adapter = nullptr;     // of the session; null: it uses none
    std::optional<Refusal> m_notOpened; // the reason
    std::optional<StopSignals> m_stop;  // while something is done by hand
    bool m_isStopped = false;           // by Ctrl+C
};

} // namespace codewheel
