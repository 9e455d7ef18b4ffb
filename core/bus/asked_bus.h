// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_outline.h"
#include "bus/encoder_bus.h"
#include "bus/encoder_on_bus.h"
#include "jobs/job_command.h"

#include <memory>
#include <vector>

namespace codewheel {

class AskedBus;

// An encoder that is asked, as views see it: turns jobs into commands for the runner of its bus, and what the
// bus pumps out of its thread into signals.
class AskedEncoder : public EncoderOnBus
{
public:
    AskedEncoder(AskedBus &bus, std::size_t device, NodeId node, const DeviceDescription &description);
    using EncoderOnBus::index;
    using EncoderOnBus::moveTo;

private:
    Result<void> mayStart(const Job &job) const override;
    void post(JobCommand command) override;

    AskedBus &m_bus;
};

// A connected bus whose encoders are asked one by one: they are added to it and removed, and their addresses
// do not depend on each other. What it shares with others that have such encoders, apart from what runs below
// it (BusSession).
class AskedBus : public EncoderBus
{
public:
    // What is peculiar to a kind of bus.
    struct Traits
    {
        std::span<const TrafficColumn> columns;
        const AskedOutlineWords &words;
        const char *name;   // of its protocol, for the user
        RefusalCode closed; // that it is not open
    };

    AskedBus(BusId id, const QDateTime &begin, const Traits &traits, const Catalog &catalog, QObject *parent);
    ~AskedBus() override;

    // Adds an encoder, which is asked from then on. Refused for an address that cannot be or is taken, and
    // for a device of another kind of bus.
    Result<void> add(NodeId node, const QString &deviceKey);
    Result<void> remove(Place place);
    // The encoder has another address now. What was known of it has to be read again. Refused like add() and
    // remove().
    Result<void> renumber(Place from, NodeId to);
    std::vector<Place> places() const override;

    const Catalog &catalog() const override { return m_catalog; }
    std::optional<Participant> found(Place place) const override;
    // Those where nobody is asked.
    std::map<NodeId, Refusal> strangers(const std::vector<Participant> &planned) const override;
    std::optional<Refusal> isOther(Place place, const QString &deviceKey,
                                   const QString &serialNumber) const override;
    // Any encoder for this kind of bus.
    Result<void> canBe(Place place, const DeviceDescription &device) const override;
    Result<void> name(Place place, const QString &deviceKey, int turns = 0, int stepsPerTurn = 0) override;

    virtual QString linkName() const = 0;
    // Whether the open bus allows the job now.
    virtual Result<void> mayStart(const Job &job, const QString &place) const = 0;
    Refusal closedRefusal() const { return {RefusalKind::link, m_traits.closed, {}}; }

protected:
    friend class AskedEncoder;
    AskedEncoder *encoderAt(NodeId node) const override;
    AskedEncoder *encoderOf(std::size_t device) const;      // null: removed, or no such one
    std::size_t count() const { return m_encoders.size(); } // with those removed
    void retireAll();
    void endRetired(); // unless handlers may still be looking at them

private:
    struct Encoder
    {
        // A copy, so that a driver may keep it whatever becomes of the catalog.
        std::unique_ptr<const DeviceDescription> description;
        std::unique_ptr<AskedEncoder> session; // null: removed
    };

    virtual bool isBegun() const = 0; // opening, or open
    virtual bool isPumping() const = 0;
    virtual void postJob(JobCommand command) = 0;
    virtual void startAsking(NodeId node, const DeviceDescription &device) = 0;
    virtual void stopAsking(std::size_t device) = 0;
    // Why there can be no encoder at an address that is not taken.
    virtual Result<void> mayAdd(NodeId node) const = 0;
    virtual std::unique_ptr<AskedEncoder> makeEncoder(std::size_t device, NodeId node,
                                                      const DeviceDescription &description);
    // What was set for the session of an encoder is to be set for the one that follows.
    virtual void carryOver(const AskedEncoder & /*before*/) {}

    AskedEncoder &take(NodeId node, const DeviceDescription &device);
    std::unique_ptr<AskedEncoder> leave(AskedEncoder &encoder);

    const Traits m_traits;
    const Catalog &m_catalog;
    std::vector<Encoder> m_encoders; // by the runner's index
    std::vector<Encoder> m_retired;  // from an earlier connection, one of which may be emitting right now
};

} // namespace codewheel
