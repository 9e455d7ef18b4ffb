// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/object_rows.h"

#include "kinds/canopen/eds/standard_objects.h"

#include <algorithm>

namespace codewheel {
namespace {

auto orderOfRow(const ObjectRow &row)
{
    return canopen::orderOf(row.object.object);
}

// The file of the node does not say whether it can be written.
canopen::FileObject objectOnlyWanted(canopen::SdoObject object)
{
    canopen::FileObject made{.object = object, .name = canopen::standardObjectName(object)};
    if (made.name.isEmpty())
        made.name = canopen::objectName(object);
    return made;
}

std::optional<canopen::FileValue> valueAt(const std::optional<canopen::FileValue> &value,
                                          std::optional<int> node)
{
    return value ? value->at(node) : std::nullopt;
}

} // namespace

bool ObjectRow::differsFromDefault(std::optional<int> node) const
{
    const auto its = valueAt(object.factory, node);
    return shown() && its && *shown() != *its;
}

bool ObjectRow::differsFromFile(std::optional<int> node) const
{
    const auto its = source == Source::file ? valueAt(object.value, node) : std::nullopt;
    return shown() && its && !canopen::isSameValue(*shown(), *its);
}

std::vector<ObjectRow> objectRows(const canopen::DeviceFile &file, const canopen::DeviceFile *compared,
                                  const std::vector<canopen::WantedObject> &wanted)
{
    std::vector<ObjectRow> rows;
    rows.reserve(file.objects.size());
    for (const canopen::FileObject &each : file.objects)
        rows.push_back({.object = each});
    if (compared != nullptr)
        for (const canopen::FileObject &each : compared->objects)
            if (file.find(each.object) == nullptr)
                rows.push_back({.object = each, .source = ObjectRow::Source::compared});
    for (const canopen::WantedObject &each : wanted)
        if (file.find(each.object) == nullptr &&
            (compared == nullptr || compared->find(each.object) == nullptr))
            rows.push_back({.object = objectOnlyWanted(each.object), .source = ObjectRow::Source::project});
    std::ranges::stable_sort(rows, {}, orderOfRow);
    return rows;
}

void takeAnswers(std::vector<ObjectRow> &rows, const std::vector<ObjectRow> &before)
{
    auto from = before.begin();
    for (ObjectRow &row : rows) {
        from = std::ranges::lower_bound(from, before.end(), orderOfRow(row), {}, orderOfRow);
        const bool isSame = from != before.end() && from->object.object == row.object.object &&
                            from->object.type == row.object.type; // which decides what its octets mean
        if (!isSame)
            continue;
        row.now = from->now;
        row.refused = from->refused;
        row.at = from->at;
        row.heard = from->heard;
        row.heardAt = from->heardAt;
    }
}

} // namespace codewheel
