// SPDX-License-Identifier: GPL-3.0-or-later
// docs/project-files.md
#include "project/line_kind.h"

#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "encoder/line_address.h"
#include "encoder/sentence.h"
#include "esc_line/line_limits.h"
#include "esc_line/line_outline.h"
#include "project/line_plan.h"
#include "project/project_keys.h"
#include "project/project_reader.h"
#include "project/project_writer.h"

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

// Of which the file has whole milliseconds.
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
    return LineAddress::of(place.node).isMaster();
}

void readEncoders(const JsonObject &json, std::vector<ProjectDevice> &encoders)
{
    std::set<QString> places;
    for (const JsonObject &row : json.array("devices",
                                            {"place", "device", "station", "group", "note", "label",
                                             "swapsWarningBytes", "wanted", "stored", "lastPosition"},
                                            LineAddress::last)) {
        ProjectDevice encoder;
        const QString told = row.text("place");
        const auto place = Place::parse(told);
        if (!place || !place->isOnLine() || place->toString() != told)
            row.report(
                "place",
                ProjectReader::tr("An address from \"esc:01\" to \"esc:1F\" is expected here, or \"esc:00\" "
                                  "for an encoder that is alone on its line."));
        else if (!places.insert(told).second)
            row.report("place", ProjectReader::tr("The address \"%1\" stands above already.").arg(told));
        else if (!encoders.empty() &&
                 (isAtMasterAddress(*place) ||
                  isAtMasterAddress(placeOnLine(LineAddress::of(encoders.front().participant.number)))))
            row.report("place",
                       ProjectReader::tr(
                           "Every encoder answers to \"esc:00\": one that stands there must be alone on its "
                           "line."));
        encoder.participant.number = place.value_or(placeOnLine({})).node;
        encoder.participant.deviceKey = row.text("device");
        encoder.swapsWarningBytes = row.flagOr("swapsWarningBytes", false);
        ProjectReader::readWhatIsKnown(row, encoder);
        encoders.push_back(std::move(encoder));
    }
    std::ranges::sort(encoders, {}, [](const ProjectDevice &encoder) { return encoder.place(); });
}

LineAdapter readAdapter(const JsonObject &json)
{
    const auto usbNumber = [&](const char *key) {
        const unsigned told = json.has(key) ? json.hexNumber(key) : 0;
        if (told > largestUsbNumber)
            json.report(key,
                        ProjectReader::tr("A number of USB has at most four digits, such as \"0403h\"."));
        return static_cast<int>(told);
    };
    LineAdapter adapter;
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

void writeAdapter(ProjectWriter &writer, const LineAdapter &adapter)
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

} // namespace

QString LineKind::key() const
{
    return QString::fromLatin1(escKind);
}

QString LineKind::title() const
{
    return tr("Serial line (ESC)");
}

QString LineKind::usualName() const
{
    return QStringLiteral("Line");
}

KindData LineKind::usual() const
{
    return KindData(LinePlan());
}

QString LineKind::linkText(const KindData &settings) const
{
    const auto *plan = settings.as<LinePlan>();
    const LineSettings wish = plan != nullptr ? plan->wish : LineSettings();
    const QLatin1Char parity(QLatin1String("NEO").at(static_cast<qsizetype>(wish.line.parity)));
    const QString form = QStringLiteral("%1%2%3").arg(wish.line.dataBits).arg(parity).arg(wish.line.stopBits);
    QStringList parts{sentence(tr("%1 Bd"), {QString::number(wish.line.baudRate)}), form};
    if (!wish.port.isEmpty())
        parts.prepend(wish.port);
    return parts.join(QStringLiteral(", "));
}

std::unique_ptr<BusOutline> LineKind::outline(const Project &project, BusId bus, const Catalog &catalog) const
{
    const LinePlan *plan = linePlan(project, bus);
    std::vector<PlannedLineOutline::Encoder> encoders;
    for (const ProjectDevice &encoder : devicesOn(project, bus)) {
        const DeviceDescription *device = catalog.find(encoder.participant.deviceKey);
        encoders.push_back(
            {encoder.place().node, device != nullptr ? device->fullName() : encoder.participant.deviceKey});
    }
    return std::make_unique<PlannedLineOutline>(plan != nullptr ? plan->wish.port : QString(),
                                                std::move(encoders));
}

KindData LineKind::read(const JsonObject &json, std::vector<ProjectDevice> &encoders) const
{
    json.allowOnly({"kind", "number", "name", "port", "adapter", "baudRate", "dataBits", "parity", "stopBits",
                    "lowLatency", "pollInterval", "timeOut", "retries", "quietAfterWrite", "fractionBits",
                    "topSpeed", "devices"});
    LinePlan line;
    LineSettings &wish = line.wish;
    wish.port = json.freeText("port");
    if (json.has("adapter"))
        line.adapter = readAdapter(json.object("adapter", {"vendor", "product", "serialNumber", "usbPath"}));
    wish.line.baudRate = number(json, "baudRate", wish.line.baudRate, line_limits::baudRate);
    wish.line.dataBits = json.numberOr("dataBits", wish.line.dataBits, 7, 8);
    if (json.has("parity"))
        wish.line.parity = json.oneOf("parity", parities);
    wish.line.stopBits = json.numberOr("stopBits", wish.line.stopBits, 1, 2);
    wish.line.lowLatency = json.flagOr("lowLatency", wish.line.lowLatency);
    wish.pollInterval = time(json, "pollInterval", wish.pollInterval, line_limits::pollInterval);
    wish.timing.answerTimeOut = time(json, "timeOut", wish.timing.answerTimeOut, line_limits::timeOut);
    wish.timing.retries = number(json, "retries", wish.timing.retries, line_limits::retries);
    wish.timing.quietAfterWrite =
        time(json, "quietAfterWrite", wish.timing.quietAfterWrite, line_limits::quietAfterWrite);
    wish.fractionBits = number(json, "fractionBits", wish.fractionBits, line_limits::fractionBits);
    wish.topSpeed =
        json.decimalOr("topSpeed", wish.topSpeed, line_limits::topSpeed.least, line_limits::topSpeed.most);
    wish.timing.character = wish.line.timeOf(1);
    readEncoders(json, encoders);
    return KindData(std::move(line));
}

void LineKind::write(ProjectWriter &writer, const KindData &settings,
                     std::span<const ProjectDevice> encoders) const
{
    const auto *plan = settings.as<LinePlan>();
    if (plan == nullptr)
        return;
    const LinePlan &line = *plan;
    JsonWriter &json = writer.json();
    std::vector<ProjectDevice> byAddress(encoders.begin(), encoders.end());
    std::ranges::stable_sort(byAddress, {}, &ProjectDevice::place);
    const LineSettings &wish = line.wish;
    writer.writeText("port", wish.port);
    if (line.adapter != LineAdapter())
        writeAdapter(writer, line.adapter);
    json.member("baudRate", wish.line.baudRate);
    json.member("dataBits", wish.line.dataBits);
    json.member("parity", nameOf(parities, wish.line.parity));
    json.member("stopBits", wish.line.stopBits);
    json.flag("lowLatency", wish.line.lowLatency);
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
        if (encoder.swapsWarningBytes)
            json.flag("swapsWarningBytes", true);
        writer.writeValues(encoder);
        writer.writeLastPosition(encoder);
    });
}

} // namespace codewheel
