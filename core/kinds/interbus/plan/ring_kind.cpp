// SPDX-License-Identifier: GPL-3.0-or-later
// docs/project-files.md
#include "catalog/hex_code.h"
#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/plan/process_addresses.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/plan/ring_plan_rules.h"
#include "kinds/interbus/report/ring_sections.h"
#include "kinds/interbus/ring/cycle_time.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_outline.h"
#include "kinds/interbus/ring/ring_rows.h"
#include "kinds/interbus/ring/ring_rules.h"
#include "kinds/interbus/words/device_number.h"
#include "kinds/interbus/words/profiles.h"
#include "project/bus_kind.h"
#include "project/project_keys.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "vocabulary/refusal_text.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr NamedValue<AddressRules::Unit> units[] = {
    {"byte", AddressRules::Unit::byte},
    {"word", AddressRules::Unit::word},
};

using namespace project_keys;

constexpr int mostWords = ring_limit::points / 16; // of the whole ring in one direction

std::optional<int> address(const JsonObject &json, const char *key)
{
    const auto number = json.optionalNumber(key, 0, largestAddress);
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

// The settings of a kind of link that this program does not have are kept as they are.
ProjectLink readLink(const JsonObject &json)
{
    ProjectLink link{json.text("kind"), json.textsByKey("settings")};
    if (!isGatewayLink(link.kind))
        return link;
    if (const auto settings = gatewaySettings(link.kind, link.settings); !settings)
        json.objectOfAny("settings")
            .report(std::get<QString>(settings.error().arguments.front()).toUtf8().constData(),
                    refusalText(settings.error()));
    return link;
}

AddressRules readAddresses(const JsonObject &json)
{
    AddressRules rules;
    if (json.has("unit"))
        rules.unit = json.oneOf("unit", units);
    rules.first = json.numberOr("first", 0, 0, largestAddress);
    rules.step5 = json.flagOr("step5", false);
    return rules;
}

// The number follows from the place in the list; it is stored as well to make the file readable.
NodeId readPlace(const JsonObject &json, DeviceNumber before)
{
    const QString told = json.text("place");
    const bool onLocalBus = told.contains(u'.') && !told.endsWith(QStringLiteral(".0"));
    const DeviceNumber place = nextNumber(before, onLocalBus);
    if (told != place.toString())
        json.report("place", ProjectReader::tr("\"%1\" cannot be here: by its place in the list this device "
                                               "is %2 on the remote bus, or %3 on a local bus.")
                                 .arg(told, nextNumber(before, false).toString(),
                                      nextNumber(before, true).toString()));
    return place.node();
}

RingDevice readRingDevice(const JsonObject &json, DeviceNumber before)
{
    RingDevice participant;
    participant.number = readPlace(json, before);
    participant.level = json.numberOr("level", 0, 0, ring_limit::levels - 1);
    participant.deviceCode = json.hexNumber("deviceCode");
    if (participant.deviceCode > 0xFFFF)
        json.report("deviceCode",
                    ProjectReader::tr("A device code has at most four digits, such as \"0237h\"."));
    participant.inWords = static_cast<int>(json.number("inWords", 0, mostWords));
    participant.outWords = static_cast<int>(json.number("outWords", 0, mostWords));
    participant.deviceKey = json.freeText("device");
    return participant;
}

ProjectDevice readDevice(const JsonObject &json, DeviceNumber before)
{
    ProjectDevice device;
    device.participant = readRingDevice(json, before);
    device.set(GivenAddresses{address(json, "inAddress"), address(json, "outAddress")});
    device.wantedCams = ProjectReader::readWantedCams(json);
    device.storedCams = ProjectReader::readStoredCams(json);
    ProjectReader::readWhatIsKnown(json, device);
    return device;
}

void writeLink(JsonWriter &json, const ProjectLink &link)
{
    json.object("link", [&] {
        json.member("kind", link.kind);
        if (!link.settings.empty())
            json.object("settings", [&] {
                for (const auto &[key, text] : link.settings)
                    json.member(key, text);
            });
    });
}

void writeAddresses(JsonWriter &json, const AddressRules &rules)
{
    json.object("addresses", [&] {
        json.member("unit", nameOf(units, rules.unit));
        json.member("first", rules.first);
        json.flag("step5", rules.step5);
    });
}

void writeRingDevice(ProjectWriter &writer, const RingDevice &participant)
{
    JsonWriter &json = writer.json();
    json.member("place", participant.number.toString());
    json.member("level", participant.level);
    json.member("deviceCode", hexCode(participant.deviceCode, 4));
    json.member("inWords", participant.inWords);
    json.member("outWords", participant.outWords);
    writer.writeText("device", participant.deviceKey);
}

void writeDevice(ProjectWriter &writer, const ProjectDevice &device)
{
    writeRingDevice(writer, ringDevice(device.participant));
    writer.writeNames(device);
    const auto addresses = device.its<GivenAddresses>();
    writer.writeNumber("inAddress", addresses.in);
    writer.writeNumber("outAddress", addresses.out);
    writer.writeValues(device);
    writer.writeCams(device);
    writer.writeLastPosition(device);
}

// A ring in a project (ring_plan.h).
class RingKind final : public BusKind
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingKind)
public:
    QString key() const override { return QString::fromLatin1(interbusKind); }
    QString title() const override { return tr("INTERBUS ring"); }
    QString usualName() const override { return QStringLiteral("Ring"); }
    std::optional<BusId> trainingBus() const override { return firstBus; }
    KindData usual() const override { return KindData(RingPlan()); }
    QString linkText(const KindData &settings) const override;
    bool isTraining(const KindData &settings) const override
    {
        const auto *plan = settings.as<RingPlan>();
        return plan == nullptr || plan->link.kind == ProjectLink().kind;
    }
    std::unique_ptr<BusOutline> outline(const Project &project, BusId bus,
                                        const Catalog &catalog) const override
    {
        return std::make_unique<PlannedRingOutline>(structureOf(project, bus), catalog);
    }
    KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const override;
    void write(ProjectWriter &writer, const KindData &settings,
               std::span<const ProjectDevice> devices) const override;
    const PlanRules &planRules() const override { return m_planRules; }
    std::unique_ptr<RecordedRows> recordedRows(Profile profile) const override
    {
        return std::ranges::count(profile::ofRings, profile) > 0 ? makeRingRows() : nullptr;
    }
    const report_sections::BusSections *reportSections() const override { return &report_sections::ofRings; }

private:
    RingPlanRules m_planRules;
};

QString RingKind::linkText(const KindData &settings) const
{
    const auto *plan = settings.as<RingPlan>();
    if (isTraining(settings))
        return tr("training bus (simulated)");
    if (isGatewayLink(plan->link.kind))
        if (const auto gateway = gatewaySettings(plan->link.kind, plan->link.settings))
            return gatewayText(*gateway);
    QStringList parts{plan->link.kind};
    for (const auto &[name, value] : plan->link.settings)
        parts << QStringLiteral("%1 = %2").arg(name, value);
    return parts.join(QStringLiteral(", "));
}

KindData RingKind::read(const JsonObject &json, std::vector<ProjectDevice> &devices) const
{
    json.allowOnly({"kind", "number", "name", "link", "addresses", "cableKilometres", "devices"});
    RingPlan plan;
    if (json.has("link"))
        plan.link = readLink(json.object("link", {"kind", "settings"}));
    if (json.has("addresses"))
        plan.addresses = readAddresses(json.object("addresses", {"unit", "first", "step5"}));
    plan.cableKilometres = json.decimalOr("cableKilometres", 0, 0, longestRemoteBus);
    DeviceNumber last;
    for (const JsonObject &row : json.array("devices",
                                            {"place", "level", "deviceCode", "inWords", "outWords", "device",
                                             "station", "group", "note", "label", "inAddress", "outAddress",
                                             "wanted", "stored", "wantedCams", "storedCams", "lastPosition"},
                                            ring_limit::devices)) {
        devices.push_back(readDevice(row, last));
        last = DeviceNumber::of(devices.back().participant.number);
    }
    return KindData(std::move(plan));
}

void RingKind::write(ProjectWriter &writer, const KindData &settings,
                     std::span<const ProjectDevice> devices) const
{
    const auto *plan = settings.as<RingPlan>();
    if (plan == nullptr)
        return;
    writeLink(writer.json(), plan->link);
    writeAddresses(writer.json(), plan->addresses);
    writer.json().member("cableKilometres", plan->cableKilometres);
    writer.json().list("devices", devices, [&](const ProjectDevice &device) { writeDevice(writer, device); });
}

} // namespace

std::unique_ptr<const BusKind> makeRingKind()
{
    return std::make_unique<RingKind>();
}

} // namespace codewheel
