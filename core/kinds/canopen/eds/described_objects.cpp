// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/standard_objects.h"
#include "kinds/canopen/protocol/canopen_reach.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

DataType typeInFile(ObjectType type)
{
    switch (type) {
    case ObjectType::u8:
        return DataType::u8;
    case ObjectType::u16:
        return DataType::u16;
    case ObjectType::i8:
        return DataType::i8;
    case ObjectType::i16:
        return DataType::i16;
    case ObjectType::i32:
        return DataType::i32;
    case ObjectType::text:
        return DataType::text;
    case ObjectType::u32:
        break;
    }
    return DataType::u32;
}

FileAccess accessOf(const ParameterDescription &parameter)
{
    if (!parameter.canBeWritten)
        return FileAccess::readOnly;
    return parameter.canBeRead ? FileAccess::readAndWrite : FileAccess::writeOnly;
}

FileObject objectOf(const ParameterDescription &parameter, const CanopenReach &reach)
{
    FileObject object{.object = reach.object,
                      .name = parameterName(parameter),
                      .type = typeInFile(reach.type),
                      .access = accessOf(parameter)};
    if (parameter.factory)
        object.factory = FileValue{*parameter.factory};
    if (!parameter.isText() && parameter.minimum < parameter.maximum) {
        object.minimum = FileValue{parameter.minimum};
        object.maximum = FileValue{parameter.maximum};
    }
    return object;
}

// The standards name their objects; how they are written, and with what, the make says.
void take(DeviceFile &file, FileObject object)
{
    const auto order = [](const FileObject &each) { return orderOf(each.object); };
    const auto at = std::ranges::lower_bound(file.objects, orderOf(object.object), {}, order);
    if (at == file.objects.end() || at->object != object.object) {
        file.objects.insert(at, std::move(object));
        return;
    }
    object.name = at->name;
    object.isMapped = at->isMapped;
    if (object.access == FileAccess::readOnly && at->canBeWritten())
        object.access = at->access; // a description tells what jobs write
    *at = std::move(object);
}

} // namespace

DeviceFile describedObjects(const DeviceDescription *device)
{
    DeviceFile file = standardObjects();
    for (FileObject &object : file.objects)
        object.name = standardObjectName(object.object);
    if (device == nullptr || device->isGeneric())
        return file;
    for (const ParameterDescription &parameter : device->parameters)
        if (const CanopenReach *reach = canopenReach(parameter); reach != nullptr && !reach->bit)
            take(file, objectOf(parameter, *reach));
    return file;
}

} // namespace codewheel::canopen
