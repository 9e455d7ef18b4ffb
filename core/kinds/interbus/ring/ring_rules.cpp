// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_rules.h"

#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_tree.h"
#include "kinds/interbus/words/device_number.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr int pointsPerWord = 16;

bool isTerminal(const RingDevice &participant)
{
    return participant.idCode() == busTerminalIdCode;
}

// A limit on something that accumulates along the ring.
struct Limit
{
    RingRule rule;
    int limit;
    int (*amount)(const RingDevice &);
};
constexpr std::array limits{
    Limit{RingRule::devices, ring_limit::devices, [](const RingDevice &) { return 1; }},
    Limit{RingRule::remoteDevices, ring_limit::remoteDevices,
          [](const RingDevice &device) { return isOnLocalBus(device) ? 0 : 1; }},
    Limit{RingRule::inPoints, ring_limit::points,
          [](const RingDevice &device) { return device.inWords * pointsPerWord; }},
    Limit{RingRule::outPoints, ring_limit::points,
          [](const RingDevice &device) { return device.outWords * pointsPerWord; }},
    Limit{RingRule::pcpDevices, ring_limit::pcpDevices,
          [](const RingDevice &device) { return isPcp(device.idCode()) ? 1 : 0; }},
};

void checkLimit(const RingStructure &structure, const Limit &limit, std::vector<RingFinding> &findings)
{
    RingFinding finding{.rule = limit.rule, .device = 0, .count = 0, .limit = limit.limit};
    for (std::size_t place = 0; place < structure.size(); ++place) {
        const int before = finding.count;
        finding.count += limit.amount(structure[place]);
        if (before <= limit.limit && finding.count > limit.limit)
            finding.device = place;
    }
    if (finding.count > limit.limit)
        findings.push_back(finding);
}

void checkLevels(const RingStructure &structure, std::vector<RingFinding> &findings)
{
    const int levels = countRing(structure).levels;
    const auto deep = std::ranges::find_if(
        structure, [](const RingDevice &device) { return device.level >= ring_limit::levels; });
    if (deep != structure.end())
        findings.push_back({.rule = RingRule::levels,
                            .device = static_cast<std::size_t>(deep - structure.begin()),
                            .count = levels,
                            .limit = ring_limit::levels});
}

void checkLocalBuses(const RingTree &tree, std::vector<RingFinding> &findings)
{
    for (const RingTree::Node &node : tree.nodes)
        if (std::ssize(node.localBus) > ring_limit::localDevices)
            findings.push_back({.rule = RingRule::localDevices,
                                .device = node.localBus[ring_limit::localDevices],
                                .count = static_cast<int>(node.localBus.size()),
                                .limit = ring_limit::localDevices});
}

void checkPlaces(const RingStructure &structure, const RingTree &tree, std::vector<RingFinding> &findings)
{
    const auto count = [&](RingRule rule, auto breaks) {
        RingFinding finding{.rule = rule};
        for (std::size_t place = structure.size(); place-- > 0;)
            if (breaks(structure[place], tree.nodes[place])) {
                finding.device = place;
                ++finding.count;
            }
        if (finding.count > 0)
            findings.push_back(finding);
    };
    const auto hangsAtTerminal = [&](const RingTree::Node &node) {
        return node.parent && isTerminal(structure[*node.parent]);
    };
    count(RingRule::localBusNeedsTerminal, [&](const RingDevice &, const RingTree::Node &node) {
        return node.isLocal && !hangsAtTerminal(node);
    });
    count(RingRule::branchNeedsTerminal, [&](const RingDevice &device, const RingTree::Node &node) {
        return !node.isLocal && device.level > 0 && !hangsAtTerminal(node);
    });
    count(RingRule::terminalOnLocalBus, [&](const RingDevice &device, const RingTree::Node &node) {
        return node.isLocal && isTerminal(device);
    });
}

// The translation context of these texts.
struct RingRules
{
    Q_DECLARE_TR_FUNCTIONS(RingRules)
};

QString limitText(const RingFinding &finding, const QString &segment)
{
    const QString limit = numberText(finding.limit);
    const QString count = numberText(finding.count);
    switch (finding.rule) {
    case RingRule::devices:
        return RingRules::tr("A ring has at most %1 devices; these are %2.").arg(limit, count);
    case RingRule::remoteDevices:
        return RingRules::tr("The remote bus has at most %1 devices; these are %2.").arg(limit, count);
    case RingRule::levels:
        return RingRules::tr("The remote bus has at most %1 levels; these are %2.").arg(limit, count);
    case RingRule::inPoints:
        return RingRules::tr("A ring has at most %1 inputs; these are %2.").arg(limit, count);
    case RingRule::outPoints:
        return RingRules::tr("A ring has at most %1 outputs; these are %2.").arg(limit, count);
    case RingRule::pcpDevices:
        return RingRules::tr("A ring has at most %1 PCP devices; these are %2.").arg(limit, count);
    default:
        return RingRules::tr("A local bus has at most %1 devices; that of segment %3 has %2.")
            .arg(limit, count, segment);
    }
}

} // namespace

RingCounts countRing(const RingStructure &structure)
{
    RingCounts counts;
    for (const RingDevice &device : structure) {
        ++counts.devices;
        counts.remoteDevices += isOnLocalBus(device) ? 0 : 1;
        counts.levels = std::max(counts.levels, device.level + 1);
        counts.inPoints += device.inWords * pointsPerWord;
        counts.outPoints += device.outWords * pointsPerWord;
        counts.longestLocalBus = std::max(counts.longestLocalBus, DeviceNumber::of(device.number).position);
        counts.pcpDevices += isPcp(device.idCode()) ? 1 : 0;
    }
    return counts;
}

std::vector<RingFinding> checkRing(const RingStructure &structure)
{
    std::vector<RingFinding> findings;
    for (const Limit &limit : limits)
        checkLimit(structure, limit, findings);
    checkLevels(structure, findings);
    const RingTree tree = ringTree(structure);
    checkLocalBuses(tree, findings);
    checkPlaces(structure, tree, findings);
    return findings;
}

QString ringFindingText(const RingFinding &finding, const RingStructure &structure)
{
    const DeviceNumber number = DeviceNumber::of(structure[finding.device].number);
    switch (finding.rule) {
    case RingRule::localBusNeedsTerminal:
        return RingRules::tr("%1 is on a local bus, which needs a bus terminal.").arg(number.toString());
    case RingRule::branchNeedsTerminal:
        return RingRules::tr("%1 is in a branch, which needs a bus terminal.").arg(number.toString());
    case RingRule::terminalOnLocalBus:
        return RingRules::tr("%1 is a bus terminal; it belongs on the remote bus.").arg(number.toString());
    default:
        return limitText(finding, QString::number(number.segment));
    }
}

} // namespace codewheel
