// SPDX-License-Identifier: GPL-3.0-or-later
// docs/project-files.md
#include "catalog/catalog.h"
#include "kinds/canopen/bus/canopen_outline.h"
#include "kinds/canopen/bus/canopen_traffic.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/plan_rules.h"
#include "project/project_keys.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "replay/recorded_rows.h"
#include "vocabulary/sentence.h"

#include <QLocale>

#include <algorithm>
#include <set>

namespace codewheel {
namespace {

using namespace project_keys;

// By their numbers.
class CanopenPlanRules final : public PlanRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenPlanRules)

    std::vector<Finding> complete(std::vector<PlanRow> &rows, const Project &, BusId,
                                  const Catalog &) const override
    {
        for (PlanRow &row : rows)
            row.toolTip += u'\n' + sentence(tr("Node %1"), {CanopenAddress::of(row.place.node).shown()});
        return {};
    }
    QString placeTitle() const override { return tr("Node"); }
    std::vector<NodeId> places() const override
    {
        std::vector<NodeId> places;
        for (int node = 1; node <= canopen::lastNode; ++node)
            places.push_back(CanopenAddress{node}.place());
        return places;
    }
    bool isOffered(const DeviceDescription &device) const override
    {
        return device.profile == profile::cia406;
    }
};

std::vector<ProjectDevice> readNodes(const JsonObject &json)
{
    std::vector<ProjectDevice> encoders;
    std::set<QString> places;
    for (const JsonObject &row : json.array("devices",
                                            {"place", "device", "station", "group", "note", "label", "wanted",
                                             "stored", "lastPosition", "file"},
                                            canopen::lastNode)) {
        ProjectDevice encoder;
        const QString told = row.text("place");
        const auto address = CanopenAddress::read(told);
        if (!address)
            row.report("place", ProjectReader::tr("A node from \"can:1\" to \"can:127\" is expected here."));
        else if (!places.insert(told).second)
            row.report("place", ProjectReader::tr("The node \"%1\" is already given above.").arg(told));
        encoder.participant.number = address.value_or(CanopenAddress{1}).place();
        encoder.participant.deviceKey = row.text("device");
        ProjectReader::readWhatIsKnown(row, encoder);
        encoder.set(CanopenEncoderSettings{.file = row.freeText("file")});
        encoders.push_back(std::move(encoder));
    }
    std::ranges::sort(encoders, {}, [](const ProjectDevice &encoder) { return encoder.place(); });
    return encoders;
}

class CanopenKind final : public BusKind
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenKind)
public:
    QString key() const override { return QString::fromLatin1(canopenKind); }
    QString title() const override { return tr("CAN bus (CANopen)"); }
    QString usualName() const override { return QStringLiteral("CAN"); }
    std::optional<BusId> trainingBus() const override { return firstCanBus; }
    KindData usual() const override { return KindData(CanopenPlan()); }
    QString linkText(const KindData &settings) const override
    {
        const CanopenSettings its = settingsOf(settings);
        return sentence(tr("%1, %2 kBit/s"), {its.link.isEmpty() ? tr("training bus (simulated)") : its.link,
                                              QLocale().toString(its.rate / 1'000)});
    }
    bool isTraining(const KindData &settings) const override { return settingsOf(settings).link.isEmpty(); }
    std::unique_ptr<BusOutline> outline(const Project &project, BusId bus,
                                        const Catalog &catalog) const override;
    KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const override;
    void write(ProjectWriter &writer, const KindData &settings,
               std::span<const ProjectDevice> devices) const override;
    const PlanRules &planRules() const override { return m_planRules; }
    std::unique_ptr<RecordedRows> recordedRows(Profile profile) const override
    {
        return profile == profile::cia406 ? makeCanopenRows() : nullptr;
    }

private:
    static CanopenSettings settingsOf(const KindData &settings)
    {
        const auto *plan = settings.as<CanopenPlan>();
        return plan != nullptr ? plan->settings : CanopenSettings();
    }

    CanopenPlanRules m_planRules;
};

std::unique_ptr<BusOutline> CanopenKind::outline(const Project &project, BusId bus,
                                                 const Catalog &catalog) const
{
    const CanopenPlan *plan = canopenPlan(project, bus);
    std::vector<PlannedAskedOutline::Encoder> encoders;
    for (const ProjectDevice &encoder : devicesOn(project, bus))
        encoders.push_back({encoder.place().node, m_planRules.nameOf(encoder.participant, catalog)});
    return std::make_unique<PlannedAskedOutline>(
        canopenOutlineWords, plan != nullptr ? plan->settings.link : QString(), std::move(encoders));
}

KindData CanopenKind::read(const JsonObject &json, std::vector<ProjectDevice> &devices) const
{
    json.allowOnly({"kind", "number", "name", "link", canRateKey, "devices"});
    CanopenPlan plan;
    plan.settings.link = json.freeText("link");
    const CanSetting &rate = *canSetting(QString::fromLatin1(canRateKey));
    plan.settings.rate = json.numberOr(canRateKey, plan.settings.rate, rate.least, rate.most);
    devices = readNodes(json);
    return KindData(std::move(plan));
}

void CanopenKind::write(ProjectWriter &writer, const KindData &settings,
                        std::span<const ProjectDevice> devices) const
{
    const CanopenSettings its = settingsOf(settings);
    JsonWriter &json = writer.json();
    std::vector<ProjectDevice> byNumber(devices.begin(), devices.end());
    std::ranges::stable_sort(byNumber, {}, &ProjectDevice::place);
    writer.writeText("link", its.link);
    json.member(canRateKey, its.rate);
    json.list("devices", byNumber, [&](const ProjectDevice &encoder) {
        json.member("place", encoder.place().toString());
        writer.writeText("device", encoder.participant.deviceKey);
        writer.writeNames(encoder);
        writer.writeValues(encoder);
        writer.writeLastPosition(encoder);
        writer.writeText("file", encoder.its<CanopenEncoderSettings>().file);
    });
}

} // namespace

const CanopenPlan *canopenPlan(const Project &project, BusId bus)
{
    const PlannedBus *planned = findBus(project, bus);
    return planned != nullptr ? planned->settings.as<CanopenPlan>() : nullptr;
}

void setCanopenPlan(Project &project, BusId bus, CanopenPlan plan)
{
    planBus(project, bus, *busKind(QString::fromLatin1(canopenKind))).settings = KindData(std::move(plan));
}

std::unique_ptr<const BusKind> makeCanopenKind()
{
    return std::make_unique<CanopenKind>();
}

} // namespace codewheel
