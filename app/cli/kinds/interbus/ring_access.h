// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/bus_access.h"
#include "kinds/interbus/training_session.h"

namespace codewheel {

// A ring of a call. A cycle is 1 ms, and since the training ring runs without waiting, what it does is there
// at once.
class RingAccess : public BusAccess
{
public:
    explicit RingAccess(RingSession &ring); // open; it must outlive this
    explicit RingAccess(TrainingSession training);
    explicit RingAccess(std::unique_ptr<RingSession> ring);

    RingSession &ring() const { return m_ring; }
    // Whether the link may reach the ring's master; it says so once it is open.
    virtual bool mayReachMaster() const { return true; }

    bool followsFaultPlan() const override { return m_owned.controls != nullptr; }
    Checked<void> followFaultPlan(const QString &file) override;
    std::optional<NodeId> placeTyped(const QString &text) const override;
    // A device may be elsewhere if the ring differs from the project at all.
    Checked<void> checkStation(const Project &project, const QString &station) const override;
    // Refused if the project has a different device there.
    Checked<EncoderSession *> encoder(const Call &call, NodeId node, bool namesIt) override;
    void useProject(const Call &call, const Project &project) override;
    Instant lookInterval() const override;
    std::unique_ptr<JobTrace> trace(const std::vector<const EncoderSession *> &encoders) override;
    std::optional<Exchange> currentRow(const EncoderSession &encoder) const override;
    Checked<Answer> scan(const Call &call) override;
    // What the project knows stays with the devices that are the same or moved.
    void keepFound(const Call &call, Project &project) const override;
    QJsonObject participantJson(const Participant &device) const override;
    Refusal whatIsLost() const override;
    std::optional<Complaint> whyItStands() const override;
    void addFigures(const Call &call, const EncoderSession &encoder, Answer &answer) const override;

protected:
    virtual std::shared_ptr<const LinkFigures> figures() const { return m_ring.latest().figures; }

private:
    QString doubtOfRegisters(const EncoderSession &encoder) const;

    TrainingSession m_owned; // empty: it has another owner; without controls: it is no training
    RingSession &m_ring;
};

} // namespace codewheel
