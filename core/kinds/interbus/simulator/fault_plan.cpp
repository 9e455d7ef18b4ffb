// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/fault_plan.h"

#include "catalog/strict_json.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "project/file_access.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr qint64 largestFaultPlan = 1'000'000; // bytes, far more than any lesson

constexpr char planFormat[] = "codewheel-faults";
constexpr std::int64_t planVersion = 1;
constexpr std::int64_t latestStep = 24LL * 3'600 * 1'000; // a day

// The rules of the file, part by part. One object per file.
class FaultPlanReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::FaultPlanReader)

public:
    explicit FaultPlanReader(const std::vector<TrainingPlace> &ring)
        : m_ring(ring)
    {}

    static void checkFormat(const Json::Value &root, FaultKeeper &faults);
    FaultPlan read(const JsonObject &json);

private:
    void readStep(const JsonObject &json);
    static TrainingFault readFault(const JsonObject &json);
    const TrainingPlace *readPlace(const JsonObject &json) const;
    static int readValue(const JsonObject &json, TrainingFault fault);

    const std::vector<TrainingPlace> &m_ring;
    FaultPlan m_plan;
};

// Before anything else: a file of another kind has other keys.
void FaultPlanReader::checkFormat(const Json::Value &root, FaultKeeper &faults)
{
    if (!root.isObject() || root["format"] == Json::Value(planFormat))
        return;
    faults.report(root.isMember("format") ? root["format"] : root, QStringLiteral("format"),
                  tr("This is not a fault plan: the format is not \"%1\".").arg(QLatin1String(planFormat)));
}

FaultPlan FaultPlanReader::read(const JsonObject &json)
{
    if (json.number("version") != planVersion)
        json.report("version", tr("Only version %1 of the format can be read.").arg(planVersion));
    m_plan.title = json.textOr("title", {});
    for (const JsonObject &row : json.array("steps", {"at", "fault", "place", "on", "perThousand"}))
        readStep(row);
    if (m_plan.steps.empty())
        json.report("steps", tr("At least one step is expected here."));
    return m_plan;
}

void FaultPlanReader::readStep(const JsonObject &json)
{
    FaultStep step;
    step.at = std::chrono::milliseconds(json.number("at", 0, latestStep));
    if (!m_plan.steps.empty() && step.at < m_plan.steps.back().at)
        json.report("at", tr("The step above comes later: the steps must be in the order of their times."));
    step.fault = readFault(json);
    step.value = readValue(json, step.fault);
    if (const TrainingPlace *place = readPlace(json)) {
        step.place = place->number;
        if (std::ranges::find(place->faults, step.fault, &TrainingPlace::Standing::fault) ==
            place->faults.end())
            json.report("fault",
                        tr("The device at %1 cannot have this fault.").arg(place->number.toString()));
    }
    m_plan.steps.push_back(step);
}

TrainingFault FaultPlanReader::readFault(const JsonObject &json)
{
    const QString name = json.text("fault");
    if (const auto fault = trainingFaultFromKey(name))
        return *fault;
    QStringList known;
    for (int i = 0; i < trainingFaults; ++i)
        known << trainingFaultKey(static_cast<TrainingFault>(i));
    json.reportUnknownName("fault", name, known);
    return {};
}

const TrainingPlace *FaultPlanReader::readPlace(const JsonObject &json) const
{
    const QString text = json.text("place");
    const auto number = DeviceNumber::parse(text);
    const auto found = std::ranges::find_if(
        m_ring, [&](const TrainingPlace &place) { return number && place.number == number->node(); });
    if (found != m_ring.end())
        return &*found;
    json.report("place", tr("There is no device at \"%1\".").arg(text));
    return nullptr;
}

int FaultPlanReader::readValue(const JsonObject &json, TrainingFault fault)
{
    const bool hasRate = fault == TrainingFault::crcErrors;
    const char *other = hasRate ? "on" : "perThousand";
    if (json.has(other))
        json.report(other, hasRate ? tr("CRC errors have \"perThousand\" in place of it.")
                                   : tr("Only CRC errors have a rate."));
    if (hasRate)
        return static_cast<int>(json.number("perThousand", 0, mostCrcErrors));
    const bool isOn = json.flagOr("on", true);
    if (!isOn && fault == TrainingFault::parametersLost)
        json.report("on", tr("Lost parameters come back by parameterizing the encoder only."));
    return isOn ? 1 : 0;
}

} // namespace

Result<FaultPlan> faultPlanFromJson(const QByteArray &json, const QString &name,
                                    const std::vector<TrainingPlace> &ring)
{
    FaultKeeper faults(json, name);
    const Json::Value root = parseStrictly(json, faults);
    FaultPlan plan;
    if (!faults.first())
        FaultPlanReader::checkFormat(root, faults);
    if (!faults.first())
        plan = FaultPlanReader(ring).read(
            JsonObject(root, QString(), {"format", "version", "title", "steps"}, faults));
    if (const auto &fault = faults.first())
        return refuse(RefusalKind::badInput, RingRefusalId::faultPlanBroken,
                      {fault->file, std::int64_t{fault->line}, fault->key, fault->reason});
    return plan;
}

Result<FaultPlan> loadFaultPlan(const QString &path, const std::vector<TrainingPlace> &ring)
{
    return readWholeFile(path, largestFaultPlan).and_then([&](const QByteArray &json) {
        return faultPlanFromJson(json, path, ring);
    });
}

} // namespace codewheel
