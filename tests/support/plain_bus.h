// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus unknown to the program: three nodes, one of which is no encoder, and only positions.
#pragma once

#include "bus/bus_outline.h"
#include "bus/encoder_bus.h"
#include "catalog/catalog.h"
#include "catalog/device_description.h"
#include "catalog/json_object.h"
#include "project/bus_kind.h"
#include "project/project_reader.h"
#include "project/project_writer.h"

#include <algorithm>
#include <map>
#include <memory>

namespace codewheel::test {

inline constexpr BusId plainId{9};
inline constexpr Place plainHoist{plainId, NodeId("n:1")};
inline constexpr Place plainGate{plainId, NodeId("n:2")};
inline constexpr Place plainLamp{plainId, NodeId("n:3")};
inline constexpr std::array plainColumns{TrafficColumn::time,      TrafficColumn::sinceLast,
                                         TrafficColumn::direction, TrafficColumn::bytes,
                                         TrafficColumn::meaning,   TrafficColumn::remark};

class PlainEncoder final : public EncoderSession
{
public:
    PlainEncoder(EncoderBus &bus, Place place, const DeviceDescription &device)
        : m_bus(bus)
        , m_place(place)
        , m_device(device)
    {
        m_device.capabilities = {};
    }

    void show(std::int64_t position)
    {
        m_reading.at = m_bus.now();
        m_reading.state = EncoderState::operation;
        m_reading.position = position;
        setFreshness({m_reading, {.isConnected = true, .isRunning = true, .now = m_bus.now()}});
        Q_EMIT latestChanged();
    }

    Place place() const override { return m_place; }
    const DeviceDescription &device() const override { return m_device; }
    const Capabilities &can() const override { return m_device.capabilities; }
    const Reading &latest() const override { return m_reading; }
    std::optional<Known> known(Parameter) const override { return std::nullopt; }
    std::optional<KnownCams> cams(unsigned) const override { return std::nullopt; }
    void tell(Parameter, const std::optional<Value> &) override {}
    Result<std::vector<Step>> planned(const std::vector<Job> &) const override { return std::vector<Step>(); }
    Result<JobId> start(const Job &, Pace) override
    {
        return refuse(RefusalKind::notSupported, RefusalId::readingNotSupported, {m_device.fullName()});
    }
    std::optional<JobId> runningJob() const override { return std::nullopt; }
    void proceed() override {}
    void cancel(OnCancel) override {}
    int eepromWrites() const override { return 0; }
    QDateTime dateTime(Instant at) const override { return m_bus.dateTime(at); }

private:
    EncoderBus &m_bus;
    const Place m_place;
    DeviceDescription m_device;
    Reading m_reading;
};

class PlainOutline final : public BusOutline
{
public:
    PlainOutline(std::vector<BusNode> nodes, const EncoderBus *bus)
        : m_nodes(std::move(nodes))
        , m_bus(bus)
    {}

    QString title() const override { return QStringLiteral("Plain"); }
    QString toolTip() const override { return {}; }
    StateWord state() const override
    {
        return m_bus != nullptr ? StateWord{Role::running, QStringLiteral("on")} : offline();
    }
    std::vector<BusNode> nodes() const override { return m_nodes; }
    NodeState state(std::size_t node) const override
    {
        const EncoderSession *encoder = m_bus != nullptr ? m_bus->encoder(m_nodes.at(node).node) : nullptr;
        if (encoder == nullptr)
            return {planned(), {}, false};
        return {{Role::running, QStringLiteral("there")}, encoder->latest().position, false};
    }
    QString toolTip(std::size_t, const QString &called) const override { return called; }

private:
    const std::vector<BusNode> m_nodes;
    const EncoderBus *m_bus;
};

inline BusNode plainNode(NodeId node, const QString &name)
{
    return {
        .node = node, .parent = {}, .name = name, .profile = QStringLiteral("-"), .code = {}, .words = {}};
}

class PlainBus final : public EncoderBus
{
public:
    explicit PlainBus(const Catalog &catalog)
        : EncoderBus(plainId, QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC), plainColumns)
        , m_catalog(catalog)
        , m_outline({plainNode(plainHoist.node, QStringLiteral("Hoist encoder")),
                     plainNode(plainGate.node, QStringLiteral("Gate encoder")),
                     plainNode(plainLamp.node, QStringLiteral("Lamp"))},
                    this)
    {
        for (const Place place : {plainHoist, plainGate})
            m_encoders[place.node] = std::make_unique<PlainEncoder>(
                *this, place, *catalog.find(QStringLiteral("fraba-ocd-ib-k1")));
        turn();
    }

    const BusOutline &outline() const override { return m_outline; }
    std::vector<Place> places() const override { return {plainHoist, plainGate, plainLamp}; }
    const Catalog &catalog() const override { return m_catalog; }
    std::optional<Participant> found(Place place) const override
    {
        Participant participant;
        participant.number = place.node;
        if (const auto encoder = m_encoders.find(place.node); encoder != m_encoders.end()) {
            participant.deviceKey = encoder->second->device().key;
            participant.deviceCode = encoder->second->device().deviceCode;
        }
        return std::ranges::count(places(), place) > 0 ? std::optional(participant) : std::nullopt;
    }
    std::map<NodeId, Refusal> strangers(const std::vector<Participant> &) const override { return {}; }
    Result<void> canBe(Place, const DeviceDescription &) const override { return {}; }
    Result<void> name(Place, const QString &, int, int) override { return {}; }
    BusState state() const override { return m_isOpen ? BusState::open : BusState::closed; }
    bool isSimulated() const override { return true; }
    bool isRunning() const override { return m_isOpen; }
    bool isOperating() const override { return false; }
    Instant now() const override { return m_now; }
    void pump() override {}
    // Each encoder advances by one step per millisecond.
    void advance(Instant duration) override
    {
        m_now += duration;
        turn();
        Q_EMIT updated();
    }
    void close() override
    {
        m_isOpen = false;
        tellState();
    }
    void setRunning(bool) override {}
    void setOperate(bool) override {}
    void alarmStop() override {}
    using EncoderBus::tellTraffic;

private:
    EncoderSession *encoderAt(NodeId node) const override
    {
        const auto found = m_encoders.find(node);
        return found == m_encoders.end() ? nullptr : found->second.get();
    }
    void turn()
    {
        for (const auto &[node, encoder] : m_encoders)
            encoder->show(1'000 + m_now / std::chrono::milliseconds(1));
    }

    const Catalog &m_catalog;
    const PlainOutline m_outline;
    std::map<NodeId, std::unique_ptr<PlainEncoder>> m_encoders;
    Instant m_now{1'000};
    bool m_isOpen = true;
};

// Its row in projects.
class PlainKind final : public BusKind
{
public:
    QString key() const override { return QStringLiteral("plain"); }
    QString title() const override { return QStringLiteral("Plain bus"); }
    QString usualName() const override { return QStringLiteral("Plain"); }
    KindData usual() const override { return KindData(24); }
    QString linkText(const KindData &) const override { return QStringLiteral("by hand"); }
    bool isTraining(const KindData & /*settings*/) const override { return true; }
    std::unique_ptr<BusOutline> outline(const Project &project, BusId bus, const Catalog &) const override
    {
        std::vector<BusNode> nodes;
        for (const ProjectDevice &device : devicesOn(project, bus))
            nodes.push_back(plainNode(device.place().node, device.station));
        return std::make_unique<PlainOutline>(std::move(nodes), nullptr);
    }
    KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const override
    {
        json.allowOnly({"kind", "number", "name", "volts", "devices"});
        for (const JsonObject &row : json.array("devices", {"place", "device", "station"})) {
            ProjectDevice &device = devices.emplace_back();
            device.participant.number = NodeId(row.text("place").toStdString());
            device.participant.deviceKey = row.freeText("device");
            ProjectReader::readWhatIsKnown(row, device);
        }
        return KindData(json.numberOr("volts", 24, 1, 230));
    }
    void write(ProjectWriter &writer, const KindData &settings,
               std::span<const ProjectDevice> devices) const override
    {
        writer.json().member("volts", *settings.as<int>());
        writer.json().list("devices", devices, [&](const ProjectDevice &device) {
            writer.json().member("place", device.place().toString());
            writer.writeText("device", device.participant.deviceKey);
            writer.writeNames(device);
        });
    }
};

} // namespace codewheel::test
