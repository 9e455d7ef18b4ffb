// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/planned_objects_answer.h"

#include "catalog/catalog.h"
#include "cli/bus/places.h"
#include "cli/call/texts.h"
#include "cli/kinds/canopen/device_file_check.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "kinds/canopen/eds/standard_objects.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "vocabulary/sentence.h"

#include <QDir>
#include <QFileInfo>

namespace codewheel {
namespace {

// Where the project says, or else beside it. Empty: the project has none.
QString fileOfEncoder(const Call &call, Place place)
{
    const ProjectDevice *planned = call.project != nullptr ? findDevice(*call.project, place) : nullptr;
    const QString file = planned != nullptr ? planned->its<CanopenEncoderSettings>().file : QString();
    if (file.isEmpty() || QFileInfo::exists(file))
        return file;
    const QDir folder = QFileInfo(*call.arguments.value("--project")).dir();
    const QString beside = folder.filePath(QFileInfo(file).fileName());
    return QFileInfo::exists(beside) ? beside : file;
}

struct PlannedObjectsOfNode
{
    canopen::DeviceFile objects;
    QString from; // the sentence
};

PlannedObjectsOfNode describedObjectsOf(const DeviceDescription *device)
{
    const bool isMake = device != nullptr && !device->isGeneric();
    return {canopen::describedObjects(device),
            isMake
                ? sentence(CommandLine::tr(
                               "Objects and defaults are those that the description of %1 tells, and of "
                               "CiA 301 and CiA 406."),
                           {device->fullName()})
                : CommandLine::tr(
                      "Objects and defaults are those of CiA 301 and CiA 406, of which no device has all.")};
}

// A file that cannot be read is said, and the description takes its place.
PlannedObjectsOfNode objectsOfFile(const Call &call, const QString &path, const DeviceDescription *device)
{
    auto file = canopenDeviceFile(path);
    if (file)
        return {*std::move(file), sentence(CommandLine::tr("Objects and defaults are those of %1."), {path})};
    call.terminal.complain(file.error().text);
    return describedObjectsOf(device);
}

// What the number of the node is added to.
void resolveNode(canopen::DeviceFile &file, int node)
{
    for (canopen::FileObject &object : file.objects)
        for (auto *value : {&object.factory, &object.minimum, &object.maximum, &object.value})
            if (*value)
                *value = (*value)->at(node);
}

} // namespace

Checked<Answer> answerOfPlannedObjects(const Call &call, const NodeMeant &where)
{
    const auto key = deviceOnNode(call, where.place);
    if (!key)
        return tl::unexpected(key.error());
    const DeviceDescription *device = call.catalog.find(*key);
    const QString path = fileOfEncoder(call, where.place);
    PlannedObjectsOfNode planned =
        path.isEmpty() ? describedObjectsOf(device) : objectsOfFile(call, path, device);
    resolveNode(planned.objects, where.node());
    Answer answer{.json = {{QStringLiteral("objects"), fileObjectsJson(planned.objects)},
                           {QStringLiteral("isRead"), false},
                           {QStringLiteral("device"), key->isEmpty() ? QJsonValue() : QJsonValue(*key)}}};
    answer.text =
        sentence(CommandLine::tr("Node %1: nothing was read."), {CanopenAddress{where.node()}.shown()}) +
        u' ' + planned.from + QStringLiteral("\n\n") + fileObjectLines(planned.objects);
    return answer;
}

} // namespace codewheel
