// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/compare_files.h"

namespace codewheel::canopen {
namespace {

using DifferenceKind = ObjectDifference::Kind;

// With the number of the node where it is known.
std::optional<FileValue> comparedValue(const FileObject &object, std::optional<int> node)
{
    const auto &value = object.valueOrFactory();
    if (!value)
        return std::nullopt;
    const auto resolved = value->at(node);
    return resolved ? resolved : value;
}

std::optional<double> realOf(const FileValue &value)
{
    if (const auto *real = std::get_if<double>(&value.value))
        return *real;
    return value.number() != nullptr && !value.addsNode ? std::optional(static_cast<double>(*value.number()))
                                                        : std::nullopt;
}

ObjectDifference differenceIn(DifferenceKind kind, const FileObject &object)
{
    return {.kind = kind, .object = object.object, .name = object.name, .type = object.type};
}

} // namespace

bool isSameValue(const FileValue &one, const FileValue &other)
{
    if (one == other)
        return true;
    const bool hasReal =
        std::holds_alternative<double>(one.value) || std::holds_alternative<double>(other.value);
    return hasReal && realOf(one) && realOf(one) == realOf(other);
}

std::vector<ObjectDifference> compareFiles(const DeviceFile &file, const DeviceFile &other)
{
    std::vector<ObjectDifference> differences;
    const auto itsNode = file.commissioning.node ? file.commissioning.node : other.commissioning.node;
    const auto othersNode = other.commissioning.node ? other.commissioning.node : itsNode;
    auto one = file.objects.begin();
    auto two = other.objects.begin();
    while (one != file.objects.end() || two != other.objects.end()) {
        const bool isEnd = one == file.objects.end();
        const bool isOthersEnd = two == other.objects.end();
        if (isOthersEnd || (!isEnd && orderOf(one->object) < orderOf(two->object))) {
            auto difference = differenceIn(DifferenceKind::missing, *one);
            difference.value = comparedValue(*one++, itsNode);
            differences.push_back(std::move(difference));
        } else if (isEnd || orderOf(two->object) < orderOf(one->object)) {
            auto difference = differenceIn(DifferenceKind::additional, *two);
            difference.other = comparedValue(*two++, othersNode);
            differences.push_back(std::move(difference));
        } else {
            auto difference = differenceIn(DifferenceKind::differs, *one);
            difference.value = comparedValue(*one++, itsNode);
            difference.other = comparedValue(*two++, othersNode);
            if (difference.value && difference.other && !isSameValue(*difference.value, *difference.other))
                differences.push_back(std::move(difference));
        }
    }
    return differences;
}

} // namespace codewheel::canopen
