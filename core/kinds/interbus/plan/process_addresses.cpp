// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/process_addresses.h"

#include "kinds/interbus/plan/project_take_over.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr int bytesPerWord = 2;

int wordAligned(int byte)
{
    return (byte + bytesPerWord - 1) / bytesPerWord * bytesPerWord;
}

// The process image of one direction as it fills up.
class Image
{
public:
    Image(std::vector<AddressRange> byHand, int first)
        : m_byHand(std::move(byHand))
        , m_next(wordAligned(first))
    {
        std::ranges::sort(m_byHand, {}, &AddressRange::first);
    }

    AddressRange next(int bytes)
    {
        AddressRange range{.first = m_next, .bytes = bytes};
        for (const AddressRange &taken : m_byHand)
            if (taken.first <= range.last() && taken.last() >= range.first)
                range.first = wordAligned(taken.last() + 1);
        m_next = range.last() + 1;
        return range;
    }

private:
    std::vector<AddressRange> m_byHand;
    int m_next;
};

using Range = std::optional<AddressRange> DeviceAddresses::*;

void fill(const Project &project, BusId ring, std::vector<DeviceAddresses> &addresses, Range range,
          int RingDevice::*words, std::optional<int> GivenAddresses::*given)
{
    std::vector<AddressRange> byHand;
    const std::span<const ProjectDevice> devices = devicesOn(project, ring);
    const RingStructure structure = structureOf(project, ring);
    const auto typed = [given](const ProjectDevice &device) { return device.its<GivenAddresses>().*given; };
    for (std::size_t place = 0; place < devices.size(); ++place)
        if (const auto first = typed(devices[place]); first && structure[place].*words > 0)
            byHand.push_back({*first, structure[place].*words * bytesPerWord, true});
    Image image(byHand, ringPlan(project, ring).addresses.first);
    for (std::size_t place = 0; place < addresses.size(); ++place) {
        const int bytes = structure[place].*words * bytesPerWord;
        if (bytes == 0)
            continue;
        const auto first = typed(devices[place]);
        addresses[place].*range = first ? AddressRange{*first, bytes, true} : image.next(bytes);
    }
}

} // namespace

std::vector<DeviceAddresses> processAddresses(const Project &project, BusId ring)
{
    std::vector<DeviceAddresses> addresses(devicesOn(project, ring).size());
    fill(project, ring, addresses, &DeviceAddresses::in, &RingDevice::inWords, &GivenAddresses::in);
    fill(project, ring, addresses, &DeviceAddresses::out, &RingDevice::outWords, &GivenAddresses::out);
    return addresses;
}

QString addressText(int byte, AddressRules::Unit unit)
{
    if (unit == AddressRules::Unit::byte)
        return QString::number(byte);
    const QString word = QString::number(byte / bytesPerWord);
    return byte % bytesPerWord == 0 ? word : QStringLiteral("%1 + %2").arg(word).arg(byte % bytesPerWord);
}

std::optional<int> parseAddress(QStringView text, AddressRules::Unit unit)
{
    bool isNumber = false;
    const int number = text.trimmed().toInt(&isNumber);
    const int scale = unit == AddressRules::Unit::byte ? 1 : bytesPerWord;
    if (!isNumber || number < 0 || number > largestAddress / scale)
        return std::nullopt;
    return number * scale;
}

} // namespace codewheel
