// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus unknown to the program, in projects: three nodes, one of which is no encoder.
#pragma once

#include "bus/bus_outline.h"
#include "bus/encoder_bus.h"
#include "catalog/json_object.h"
#include "project/bus_kind.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "report/bus_sections.h"
#include "report/report_words.h"
#include "tests/kinds/plain/plain_meaning.h"
#include "tests/kinds/plain/plain_protocol.h"
#include "tests/kinds/plain/telegram_protocol.h"

#include <memory>

namespace codewheel::test {

inline constexpr BusId plainId{9};
inline constexpr Place plainHoist{plainId, NodeId("n:1")};
inline constexpr Place plainGate{plainId, NodeId("n:2")};
inline constexpr Place plainLamp{plainId, NodeId("n:3")};
inline constexpr Place telegramWinch{plainId, NodeId("n:4")};
inline constexpr Place telegramCrab{plainId, NodeId("n:5")};

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

// What a project has of one of its nodes.
struct PlainNodeSettings
{
    int heartbeat = 0; // milliseconds; 0: none

    friend bool operator==(const PlainNodeSettings &, const PlainNodeSettings &) = default;
};

// What only this bus tells of a node.
struct PlainDetails
{
    int inputBytes = 0;

    friend bool operator==(const PlainDetails &, const PlainDetails &) = default;
};

inline ReportTable plainTable(const Project & /*project*/, BusId /*bus*/,
                              const std::vector<ReportedDevice> &devices)
{
    using enum ReportTable::Column;
    ReportTable table{{QStringLiteral("Node"), QStringLiteral("Device"), QStringLiteral("Heartbeat")},
                      {text, text, number},
                      {}};
    for (const ReportedDevice &device : devices)
        table.rows.push_back(
            {{device.place().toString(), report_words::device(device),
              QStringLiteral("%1 ms").arg(device.planned->its<PlainNodeSettings>().heartbeat)}});
    return table;
}
inline constexpr report_sections::BusSections plainSections{plainTable};

// Its row in projects, and in recordings.
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
        for (const JsonObject &row :
             json.array("devices", {"place", "device", "station", "group", "serialNumber", "label",
                                    "heartbeat", "inputBytes", "wanted", "stored", "lastPosition"})) {
            ProjectDevice &device = devices.emplace_back();
            device.participant.number = NodeId(row.text("place").toStdString());
            device.participant.deviceKey = row.freeText("device");
            device.set(PlainNodeSettings{row.numberOr("heartbeat", 0, 0, 10'000)});
            if (const int bytes = row.numberOr("inputBytes", 0, 0, 8); bytes != 0)
                device.participant.details = KindData(PlainDetails{bytes});
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
            if (const int heartbeat = device.its<PlainNodeSettings>().heartbeat; heartbeat != 0)
                writer.json().member("heartbeat", heartbeat);
            if (const auto *told = device.participant.details.as<PlainDetails>())
                writer.json().member("inputBytes", told->inputBytes);
            writer.writeValues(device);
            writer.writeLastPosition(device);
        });
    }
    std::unique_ptr<RecordedRows> recordedRows(Profile profile) const override
    {
        return profile == plainProfile || profile == telegramProfile ? makePlainRows() : nullptr;
    }
    const report_sections::BusSections *reportSections() const override { return &plainSections; }
};

} // namespace codewheel::test
