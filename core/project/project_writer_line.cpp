// SPDX-License-Identifier: GPL-3.0-or-later
// The serial line of a project (docs/project-files.md).
#include "catalog/hex_code.h"
#include "project/project_keys.h"
#include "project/project_writer.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace project_keys;

std::int64_t wholeMilliseconds(Instant time)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
}

} // namespace

void ProjectWriter::writeLine(const LinePlan &line, std::span<const ProjectDevice> encoders)
{
    std::vector<ProjectDevice> byAddress(encoders.begin(), encoders.end());
    std::ranges::stable_sort(byAddress, {}, &ProjectDevice::place);
    const LineWish &wish = line.wish;
    writeText("port", wish.port);
    if (line.adapter != LineAdapter())
        writeAdapter(line.adapter);
    m_json.member("baudRate", wish.line.baudRate);
    m_json.member("dataBits", wish.line.dataBits);
    m_json.member("parity", nameOf(parities, wish.line.parity));
    m_json.member("stopBits", wish.line.stopBits);
    m_json.flag("lowLatency", wish.line.lowLatency);
    m_json.member("pollInterval", wholeMilliseconds(wish.pollInterval));
    m_json.member("timeOut", wholeMilliseconds(wish.timing.answerTimeOut));
    m_json.member("retries", wish.timing.retries);
    m_json.member("quietAfterWrite", wholeMilliseconds(wish.timing.quietAfterWrite));
    m_json.member("fractionBits", wish.fractionBits);
    m_json.member("topSpeed", wish.topSpeed);
    m_json.list("devices", byAddress, [&](const ProjectDevice &encoder) {
        m_json.member("place", encoder.place().toString());
        writeText("device", encoder.participant.deviceKey);
        writeNames(encoder);
        if (encoder.swapsWarningBytes)
            m_json.flag("swapsWarningBytes", true);
        writeValues(encoder);
        writeLastPosition(encoder);
    });
}

void ProjectWriter::writeAdapter(const LineAdapter &adapter)
{
    m_json.object("adapter", [&] {
        if (adapter.vendor != 0)
            m_json.member("vendor", hexCode(static_cast<unsigned>(adapter.vendor), 4));
        if (adapter.product != 0)
            m_json.member("product", hexCode(static_cast<unsigned>(adapter.product), 4));
        writeText("serialNumber", adapter.serialNumber);
        writeText("usbPath", adapter.usbPath);
    });
}

} // namespace codewheel
