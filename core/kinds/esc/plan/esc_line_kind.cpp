// SPDX-License-Identifier: GPL-3.0-or-later
// docs/project-files.md
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "kinds/esc/line/esc_line_limits.h"
#include "kinds/esc/line/esc_line_outline.h"
#include "kinds/esc/line/esc_line_rows.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/plan/esc_line_plan_rules.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "project/bus_kind.h"
#include "project/project_keys.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <set>

namespace codewheel {
namespace {

constexpr NamedValue<SerialSettings::Parity> parities[] = {
    {"none", SerialSettings::Parity::none},
    {"even", SerialSettings::Parity::even},
    {"odd", SerialSettings::Parity::odd},
};

using namespace project_keys;
using std::chrono::milliseconds;

constexpr int largestUsbNumber = 0xFFFF;

// The file holds it in whole milliseconds.
Instant time(const JsonObject &json, const char *key, Instant otherwise, line_limits::Limits limits)
{
    const auto usual = std::chrono::duration_cast<milliseconds>(otherwise);
    return milliseconds(json.numberOr(key, static_cast<int>(usual.count()), limits.least, limits.most));
}

int number(const JsonObject &json, const char *key, int otherwise, line_limits::Limits limits)
{
    return json.numberOr(key, otherwise, limits.least, limits.most);
}

bool isAtMasterAddress(Place place)
{
    return EscLineAddress::of(place.node).isMaster();
}

void readEncoders(const JsonObject &json, std::vector<ProjectDevice> &encoders)
{
    std::set<QString> places;
    for (const JsonObject &row : json.array("devices",
                                            {"place", "device", "station", "group", "note", "label",
                                             "swapsWarningBytes", "wanted", "stored", "lastPosition"},
                                            EscLineAddress::last)) {
        ProjectDevice encoder;
        const QString told = row.text("place");
        const auto place = Place::parse(told);
        if (!place || !addressTyped(told) || place->toString() != told)
            row.report(
                "place",
                ProjectReader::tr("An address from \"esc:01\" to \"esc:1F\" is expected here, or \"esc:00\" "
                                  "for an encoder that is alone on its line."));
        else if (!places.insert(told).second)
            row.report("place", ProjectReader::tr("The address \"%1\" is already given above.").arg(told));
        else if (!encoders.empty() &&
                 (isAtMasterAddress(*place) ||
                  isAtMasterAddress(placeOnLine(EscLineAddress::of(encoders.front().participant.number)))))
            row.report(
                "place",
                ProjectReader::tr(
                    "Every encoder answers to \"esc:00\": one that is there must be alone on its line."));
        encoder.participant.number = place.value_or(placeOnLine({})).node;
        encoder.participant.deviceKey = row.text("device");
        encoder.set(EscEncoderSettings{.swapsWarningBytes = row.flagOr("swapsWarningBytes", false)});
        ProjectReader::readWhatIsKnown(row, encoder);
        encoders.push_back(std::move(encoder));
    }
    std::ranges::sort(encoders, {}, [](const ProjectDevice &encoder) { return encoder.place(); });
}

EscLineAdapter readAdapter(const JsonObject &json)
{
    const auto usbNumber = [&](const char *key) {
        const unsigned told = json.has(key) ? json.hexNumber(key) : 0;
        if (told > largestUsbNumber)
            json.report(key,
                        ProjectReader::tr("A number of USB has at most four digits, such as \"0403h\"."));
        return static_cast<int>(told);
    };
    EscLineAdapter adapter;
    adapter.vendor = usbNumber("vendor");
    adapter.product = usbNumber("product");
    adapter.serialNumber = json.freeText("serialNumber");
    adapter.usbPath = json.freeText("usbPath");
    return adapter;
}

std::int64_t wholeMilliseconds(Instant time)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
}

void writeAdapter(ProjectWriter &writer, const EscLineAdapter &adapter)
{
    writer.json().object("adapter", [&] {
        if (adapter.vendor != 0)
            writer.json().member("vendor", hexCode(static_cast<unsigned>(adapter.vendor), 4));
        if (adapter.product != 0)
            writer.json().member("product", hexCode(static_cast<unsigned>(adapter.product), 4));
        writer.writeText("serialNumber", adapter.serialNumber);
        writer.writeText("usbPath", adapter.usbPath);
    });
}

// A serial line in a project (line_plan.h).
class EscLineKind final : public BusKind
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineKind)
public:
    QString key() const override { return QString::fromLatin1(escKind); }
    QString title() const override { return tr("Serial line (ESC)"); }
    QString usualName() const override { return QStringLiteral("Line"); }
    QString nameOfNew() const override { return tr("Line", "name of a new bus"); }
    std::optional<BusId> trainingBus() const override { return firstLine; }
    KindData usual() const override { return KindData(EscLinePlan()); }
    QString linkText(const KindData &settings) const override;
    bool isTraining(const KindData &settings) const override
    {
        const auto *plan = settings.as<EscLinePlan>();
        return plan == nullptr || plan->settings.port.isEmpty();
    }
    std::unique_ptr<BusOutline> outline(const Project &project, BusId bus,
                                        const Catalog &catalog) const override;
    KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const override;
    void write(ProjectWriter &writer, const KindData &settings,
               std::span<const ProjectDevice> devices) const override;
    const PlanRules &planRules() const override { return m_planRules; }
    std::unique_ptr<RecordedRows> recordedRows(Profile profile) const override
    {
        return profile == profile::esc ? makeEscLineRows() : nullptr;
    }

private:
    EscLinePlanRules m_planRules;
};

QString EscLineKind::linkText(const KindData &settings) const
{
    const auto *plan = settings.as<EscLinePlan>();
    const EscLineSettings line = plan != nullptr ? plan->settings : EscLineSettings();
    QStringList parts{sentence(tr("%1 Bd"), {QString::number(line.serial.baudRate)}), line.serial.format()};
    parts.prepend(isTraining(settings) ? tr("training line (simulated)") : line.port);
    return parts.join(QStringLiteral(", "));
}

std::unique_ptr<BusOutline> EscLineKind::outline(const Project &project, BusId bus,
                                                 const Catalog &catalog) const
{
    const EscLinePlan *plan = linePlan(project, bus);
    std::vector<PlannedAskedOutline::Encoder> encoders;
    for (const ProjectDevice &encoder : devicesOn(project, bus)) {
        const DeviceDescription *device = catalog.find(encoder.participant.deviceKey);
        encoders.push_back(
            {encoder.place().node, device != nullptr ? device->fullName() : encoder.participant.deviceKey});
    }
    return std::make_unique<PlannedAskedOutline>(
        lineOutlineWords, plan != nullptr ? plan->settings.port : QString(), std::move(encoders));
}

KindData EscLineKind::read(const JsonObject &json, std::vector<ProjectDevice> &encoders) const
{
    json.allowOnly({"kind", "number", "name", "port", "adapter", "baudRate", "dataBits", "parity", "stopBits",
                    "lowLatency", "pollInterval", "timeOut", "retries", "quietAfterWrite", "fractionBits",
                    "topSpeed", "devices"});
    EscLinePlan line;
    EscLineSettings &wish = line.settings;
    wish.port = json.freeText("port");
    if (json.has("adapter"))
        line.adapter = readAdapter(json.object("adapter", {"vendor", "product", "serialNumber", "usbPath"}));
    wish.serial.baudRate = number(json, "baudRate", wish.serial.baudRate, line_limits::baudRate);
    wish.serial.dataBits = json.numberOr("dataBits", wish.serial.dataBits, 7, 8);
    if (json.has("parity"))
        wish.serial.parity = json.oneOf("parity", parities);
    wish.serial.stopBits = json.numberOr("stopBits", wish.serial.stopBits, 1, 2);
    wish.serial.lowLatency = json.flagOr("lowLatency", wish.serial.lowLatency);
    wish.pollInterval = time(json, "pollInterval", wish.pollInterval, line_limits::pollInterval);
    wish.timing.answerTimeOut = time(json, "timeOut", wish.timing.answerTimeOut, line_limits::timeOut);
    wish.timing.retries = number(json, "retries", wish.timing.retries, line_limits::retries);
    wish.timing.quietAfterWrite =
        time(json, "quietAfterWrite", wish.timing.quietAfterWrite, line_limits::quietAfterWrite);
    wish.fractionBits = number(json, "fractionBits", wish.fractionBits, line_limits::fractionBits);
    wish.topSpeed =
        json.decimalOr("topSpeed", wish.topSpeed, line_limits::topSpeed.least, line_limits::topSpeed.most);
    wish.timing.character = wish.serial.timeOf(1);
    readEncoders(json, encoders);
    return KindData(std::move(line));
}

void EscLineKind::write(ProjectWriter &writer, const KindData &settings,
                        std::span<const ProjectDevice> encoders) const
{
    const auto *plan = settings.as<EscLinePlan>();
    if (plan == nullptr)
        return;
    const EscLinePlan &line = *plan;
    JsonWriter &json = writer.json();
    std::vector<ProjectDevice> byAddress(encoders.begin(), encoders.end());
    std::ranges::stable_sort(byAddress, {}, &ProjectDevice::place);
    const EscLineSettings &wish = line.settings;
    writer.writeText("port", wish.port);
    if (line.adapter != EscLineAdapter())
        writeAdapter(writer, line.adapter);
    json.member("baudRate", wish.serial.baudRate);
    json.member("dataBits", wish.serial.dataBits);
    json.member("parity", nameOf(parities, wish.serial.parity));
    json.member("stopBits", wish.serial.stopBits);
    json.flag("lowLatency", wish.serial.lowLatency);
    json.member("pollInterval", wholeMilliseconds(wish.pollInterval));
    json.member("timeOut", wholeMilliseconds(wish.timing.answerTimeOut));
    json.member("retries", wish.timing.retries);
    json.member("quietAfterWrite", wholeMilliseconds(wish.timing.quietAfterWrite));
    json.member("fractionBits", wish.fractionBits);
    json.member("topSpeed", wish.topSpeed);
    json.list("devices", byAddress, [&](const ProjectDevice &encoder) {
        json.member("place", encoder.place().toString());
        writer.writeText("device", encoder.participant.deviceKey);
        writer.writeNames(encoder);
        if (encoder.its<EscEncoderSettings>().swapsWarningBytes)
            json.flag("swapsWarningBytes", true);
        writer.writeValues(encoder);
        writer.writeLastPosition(encoder);
    });
}

} // namespace

std::unique_ptr<const BusKind> makeLineKind()
{
    return std::make_unique<EscLineKind>();
}

} // namespace codewheel
