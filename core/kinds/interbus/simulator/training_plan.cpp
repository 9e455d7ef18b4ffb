// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/training_plan.h"

#include "catalog/protocol_rules.h"
#include "catalog/strict_json.h"
#include "catalog/total_range.h"
#include "kinds/interbus/simulator/training_controls.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/profiles.h"

namespace codewheel {
namespace {

constexpr auto fastestShaft = static_cast<std::int64_t>(TrainingControls::fastest);

constexpr std::int64_t shortestRod = 20; // mm
constexpr std::int64_t longestRod = 10'000;

// The rules of a training plan, row by row. One object per file.
class TrainingPlanReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::TrainingPlanReader)

public:
    explicit TrainingPlanReader(const Catalog &catalog)
        : m_catalog(catalog)
    {}

    void read(const JsonObject &row);
    TrainingPlan takePlan() { return std::move(m_plan); }

private:
    void readPlace(const JsonObject &row, TrainingParticipant &participant) const;
    bool hasTerminal(int segment) const;
    void readDevice(const JsonObject &row, TrainingParticipant &participant) const;
    static void readRod(const JsonObject &row, TrainingParticipant &participant);
    static void readShaft(const JsonObject &row, TrainingParticipant &participant);
    static ParameterValues readKnown(const JsonObject &row, const char *key, const DeviceDescription &device);
    static void refuseKeys(const JsonObject &row, std::initializer_list<const char *> keys,
                           const QString &reason);

    const Catalog &m_catalog;
    TrainingPlan m_plan;
};

void TrainingPlanReader::read(const JsonObject &row)
{
    TrainingParticipant participant;
    readPlace(row, participant);
    if (row.flagOr("busTerminal", false))
        refuseKeys(row,
                   {"device", "position", "revolutionsPerMinute", "rodMillimetres", "millimetres",
                    "millimetresPerSecond", "serialNumber", "operatingTime", "known", "knownInWindow"},
                   tr("A bus terminal has no encoder."));
    else
        readDevice(row, participant);
    m_plan.push_back(std::move(participant));
}

bool TrainingPlanReader::hasTerminal(int segment) const
{
    return std::ranges::any_of(m_plan, [segment](const TrainingParticipant &other) {
        return other.number == DeviceNumber{segment, 0}.node() && other.device == nullptr;
    });
}

void TrainingPlanReader::readPlace(const JsonObject &row, TrainingParticipant &participant) const
{
    const auto number = DeviceNumber::parse(row.text("place"));
    participant.number = number.value_or(DeviceNumber()).node();
    if (!number)
        row.report("place", tr("A device number such as \"6.1\" is expected here."));
    else if (!m_plan.empty() && number->node() <= m_plan.back().number)
        row.report("place", tr("The participants must be in the order of the ring."));
    else if (number->position > 0 && !hasTerminal(number->segment))
        row.report("place", tr("A branch needs a bus terminal before it: %1.0.").arg(number->segment));
}

void TrainingPlanReader::readDevice(const JsonObject &row, TrainingParticipant &participant) const
{
    const QString key = row.text("device");
    participant.device = m_catalog.find(key);
    if (!participant.device) {
        row.report("device", tr("There is no device \"%1\" in the catalog.").arg(key));
        return;
    }
    if (!canBeSimulated(*participant.device)) {
        row.report("device", tr("The device \"%1\" cannot be simulated.").arg(key));
        return;
    }
    if (isRod(*participant.device))
        readRod(row, participant);
    else
        readShaft(row, participant);
    if (participant.device->dialect == k3::Dialect::fraba) {
        participant.serialNumber = row.optionalNumber("serialNumber", 0, k3::dataMask).value_or(0);
        participant.operatingTime = row.optionalNumber("operatingTime", 0, k3::dataMask).value_or(0);
    } else {
        refuseKeys(row, {"serialNumber", "operatingTime"}, tr("Only a FRABA K3 has this."));
    }
    participant.known = readKnown(row, "known", *participant.device);
    participant.knownInWindow = readKnown(row, "knownInWindow", *participant.device);
}

void TrainingPlanReader::readRod(const JsonObject &row, TrainingParticipant &participant)
{
    refuseKeys(row, {"position", "revolutionsPerMinute"}, tr("A linear encoder has no shaft."));
    participant.rodMillimetres = row.number("rodMillimetres", shortestRod, longestRod);
    participant.millimetres = row.optionalNumber("millimetres", 0, participant.rodMillimetres).value_or(0);
    participant.millimetresPerSecond =
        row.optionalNumber("millimetresPerSecond", -longestRod, longestRod).value_or(0);
}

void TrainingPlanReader::readShaft(const JsonObject &row, TrainingParticipant &participant)
{
    refuseKeys(row, {"rodMillimetres", "millimetres", "millimetresPerSecond"},
               tr("Only a linear encoder has a rod."));
    const DeviceDescription &device = *participant.device;
    const std::int64_t range = physicalRange(device);
    participant.position = row.optionalNumber("position", 0, range - 1).value_or(0);
    participant.revolutionsPerMinute =
        row.optionalNumber("revolutionsPerMinute", -fastestShaft, fastestShaft).value_or(0);
}

ParameterValues TrainingPlanReader::readKnown(const JsonObject &row, const char *key,
                                              const DeviceDescription &device)
{
    ParameterValues known;
    if (!row.has(key))
        return known;
    for (const JsonObject &json : row.array(key, {"parameter", "value"})) {
        const QString name = json.text("parameter");
        const auto parameter = parameterFromKey(name);
        const ParameterDescription *description = parameter ? device.find(*parameter) : nullptr;
        if (description)
            replaceValue(known,
                         {*parameter, json.number("value", description->minimum, description->maximum)});
        else
            json.report("parameter", tr("The device has no parameter \"%1\".").arg(name));
    }
    return known;
}

void TrainingPlanReader::refuseKeys(const JsonObject &row, std::initializer_list<const char *> keys,
                                    const QString &reason)
{
    for (const char *key : keys)
        if (row.has(key))
            row.report(key, reason);
}

} // namespace

bool canBeSimulated(const DeviceDescription &device)
{
    if (isRod(device))
        return true;
    const bool hasResolution = device.physicalStepsPerTurn > 0 && device.physicalTurns > 0;
    const bool isK3 = device.profile == profile::k3 && device.dialect != k3::Dialect::generic;
    return hasResolution && (isK3 || onlyTellsPosition(device));
}

tl::expected<TrainingPlan, Catalog::Fault> readTrainingPlan(const QByteArray &json, const QString &file,
                                                            const Catalog &catalog)
{
    FaultKeeper faults(json, file);
    const Json::Value root = parseStrictly(json, faults);
    TrainingPlanReader reader(catalog);
    if (!faults.first()) {
        const JsonObject plan(root, QString(), {"participants"}, faults);
        for (const JsonObject &row :
             plan.array("participants", {"place", "device", "busTerminal", "position", "revolutionsPerMinute",
                                         "rodMillimetres", "millimetres", "millimetresPerSecond",
                                         "serialNumber", "operatingTime", "known", "knownInWindow"}))
            reader.read(row);
    }
    if (faults.first())
        return tl::unexpected(*faults.first());
    return reader.takePlan();
}

} // namespace codewheel
