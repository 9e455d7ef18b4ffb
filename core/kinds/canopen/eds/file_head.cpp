// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/file_head.h"

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

constexpr std::uint64_t largestNode = 127;
constexpr std::array<std::uint64_t, 9> ratesInKbd{10, 20, 50, 100, 125, 250, 500, 800, 1000};
constexpr int bdOfKbd = 1'000;

constexpr std::array fileInfoKeys{"FileName",    "FileVersion",  "FileRevision",     "EDSVersion",
                                  "Description", "CreationTime", "CreationDate",     "CreatedBy",
                                  "ModifiedBy",  "LastEDS",      "ModificationTime", "ModificationDate"};
constexpr std::array deviceInfoKeys{
    "VendorName",
    "VendorNumber",
    "ProductName",
    "ProductNumber",
    "RevisionNumber",
    "OrderCode",
    "BaudRate_10",
    "BaudRate_20",
    "BaudRate_50",
    "BaudRate_100",
    "BaudRate_125",
    "BaudRate_250",
    "BaudRate_500",
    "BaudRate_800",
    "BaudRate_1000",
    "SimpleBootUpMaster",
    "Granularity",
    "SimpleBootUpSlave",
    "GroupMessaging",
    "DynamicChannelsSupported",
    "NrOfRXPDO",
    "NrOfTXPDO",
    "LSS_Supported",
    "CompactPDO",
    "ProductVersion",
    "LSS_Type",
    "NG_Slave",
    "NG_Master",
    "ExtendedBootUpMaster",
};
constexpr std::array commissioningKeys{"NodeID",   "NodeName",       "NodeRefd",
                                       "Baudrate", "NetNumber",      "NetworkName",
                                       "NetRefd",  "CANopenManager", "LSS_SerialNumber"};

// 0 says nothing.
std::optional<std::uint32_t> identityNumber(const SectionReader &info, std::string_view key)
{
    constexpr std::uint64_t largest = 0xFFFF'FFFF;
    const auto number = info.number(key);
    return number && *number != 0 && *number <= largest ? std::optional(static_cast<std::uint32_t>(*number))
                                                        : std::nullopt;
}

void readIdentity(const SectionReader &info, FileIdentity &identity)
{
    info.checkKeys(deviceInfoKeys);
    identity = {.vendorName = info.text("VendorName"),
                .productName = info.text("ProductName"),
                .orderCode = info.text("OrderCode"),
                .vendor = identityNumber(info, "VendorNumber"),
                .product = identityNumber(info, "ProductNumber"),
                .revision = identityNumber(info, "RevisionNumber")};
}

bool isRate(std::uint64_t rate)
{
    return std::ranges::find(ratesInKbd, rate) != ratesInKbd.end();
}

bool isNode(std::uint64_t node)
{
    return node >= 1 && node <= largestNode;
}

// Of node or rate, where it is one; otherwise it is refused.
std::optional<int> allowed(const SectionReader &section, const char *key, bool (*isAllowed)(std::uint64_t),
                           EdsFault fault, std::vector<EdsNote> &refused)
{
    const IniEntry *entry = section.section().find(key);
    if (entry == nullptr || entry->value.empty())
        return std::nullopt;
    if (const auto number = section.number(key); number && isAllowed(*number))
        return static_cast<int>(*number);
    refused.push_back({entry->line, textOf(entry->key), fault, {textOf(entry->value)}});
    return std::nullopt;
}

Commissioning commissioningIn(const SectionReader &section, std::vector<EdsNote> &refused)
{
    section.checkKeys(commissioningKeys);
    const auto rate = allowed(section, "Baudrate", isRate, EdsFault::badRate, refused);
    return {.node = allowed(section, "NodeID", isNode, EdsFault::badNode, refused),
            .rate = rate ? std::optional(*rate * bdOfKbd) : std::nullopt,
            .nodeName = section.text("NodeName")};
}

template <typename T>
bool differ(const std::optional<T> &one, const std::optional<T> &other)
{
    return one && other && *one != *other;
}

// The names with one m and with two are both in use.
void readCommissioning(const FileLayout &layout, DeviceFile &file)
{
    Commissioning &all = file.commissioning;
    for (const IniSection *section : layout.commissioning) {
        const SectionReader reader(*section, file.notes);
        const Commissioning its = commissioningIn(reader, file.refused);
        if (differ(all.node, its.node) || differ(all.rate, its.rate))
            reader.noteSection(EdsFault::otherCommissioning);
        all.node = all.node ? all.node : its.node;
        all.rate = all.rate ? all.rate : its.rate;
        all.nodeName = all.nodeName.isEmpty() ? its.nodeName : all.nodeName;
    }
}

std::optional<std::uint32_t> factoryNumber(const DeviceFile &file, std::uint8_t sub)
{
    constexpr std::uint16_t identityIndex = 0x1018;
    const FileObject *object = file.find({identityIndex, sub});
    const auto *number =
        object != nullptr && object->valueOrFactory() ? object->valueOrFactory()->number() : nullptr;
    return number != nullptr && *number > 0 && *number <= 0xFFFF'FFFFLL
               ? std::optional(static_cast<std::uint32_t>(*number))
               : std::nullopt;
}

} // namespace

void readHead(const FileLayout &layout, DeviceFile &file)
{
    if (layout.fileInfo != nullptr) {
        const SectionReader info(*layout.fileInfo, file.notes);
        info.checkKeys(fileInfoKeys);
        file.fileVersion = info.text("FileVersion");
        file.fileRevision = info.text("FileRevision");
    }
    if (layout.deviceInfo != nullptr) {
        readIdentity(SectionReader(*layout.deviceInfo, file.notes), file.identity);
        for (const IniEntry &entry : layout.deviceInfo->entries)
            file.deviceInfo.emplace_back(textOf(entry.key), textOf(entry.value));
    }
    readCommissioning(layout, file);
}

void completeIdentity(DeviceFile &file)
{
    std::uint8_t sub = 0;
    for (auto *number : {&file.identity.vendor, &file.identity.product, &file.identity.revision})
        if (const auto told = factoryNumber(file, ++sub); !*number)
            *number = told;
}

} // namespace codewheel::canopen
