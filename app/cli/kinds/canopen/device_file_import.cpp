// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/parameter_arguments.h"
#include "cli/kinds/canopen/device_file_check.h"
#include "kinds/canopen/eds/device_description_json.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "kinds/canopen/protocol/device_of_type.h"
#include "project/file_access.h"
#include "user_devices.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>

namespace codewheel {
namespace {

// The description of CiA 406 that the device is one of.
Checked<QString> genericDeviceFor(const Call &call, const canopen::DeviceFile &file)
{
    if (const auto typed = call.arguments.value("--as")) {
        const auto device = deviceNamed(call.catalog, *typed);
        if (!device)
            return tl::unexpected(device.error());
        if ((*device)->profile == profile::cia406 && (*device)->isGeneric())
            return *typed;
        return badInput("notOfCia406",
                        CommandLine::tr("%1 is no form of encoder. Write canopen-406-single-turn, "
                                        "canopen-406-multi-turn or canopen-406-linear."),
                        {*typed});
    }
    const auto type = canopen::deviceTypeIn(file);
    if (!type)
        return badInput(
            "formNotTold",
            CommandLine::tr("The file does not say whether the device is an encoder (1000h). If it "
                            "is one, say of which form, as --as canopen-406-multi-turn."));
    const QString key = deviceOfType(*type);
    if (key.isEmpty())
        return badInput("noEncoder",
                        CommandLine::tr("This is no encoder of CiA 406: its device type (1000h) is %1h."),
                        {hexWord(*type)});
    return key;
}

QByteArray descriptionBytes(const canopen::DeviceFile &file, const QString &generic, const QString &key,
                            const QString &from)
{
    QFile resource(QStringLiteral(":/devices/%1.json").arg(generic));
    if (!resource.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(resource.fileName()));
    const QJsonObject json = QJsonDocument::fromJson(resource.readAll()).object();
    return QJsonDocument(canopen::descriptionOf(file, json, key, from)).toJson();
}

Checked<DeviceDescription> checkedDescription(const QByteArray &bytes, const QString &path)
{
    Catalog catalog = Catalog::builtIn();
    addUserDevices(catalog, userDeviceFolder(), path);
    const std::size_t before = catalog.devices().size();
    if (const auto added = catalog.add(bytes, path); !added)
        return tl::unexpected(complaintAbout({RefusalKind::badInput,
                                              RefusalId::deviceFileBroken,
                                              {added.error().place(), added.error().reason}}));
    return catalog.devices()[before];
}

} // namespace

Checked<Answer> importDeviceFile(const Call &call, const QString &path, const canopen::DeviceFile &file)
{
    const auto generic = genericDeviceFor(call, file);
    if (!generic)
        return tl::unexpected(generic.error());
    const QString key = call.arguments.value("--name").value_or(canopen::descriptionKeyOf(file.identity));
    const QString target = userDeviceFolder() + u'/' + QFileInfo(key).fileName() + QStringLiteral(".json");
    const QByteArray bytes = descriptionBytes(file, *generic, key, QFileInfo(path).fileName());
    const auto device = checkedDescription(bytes, target);
    if (!device)
        return tl::unexpected(device.error());
    QDir().mkpath(userDeviceFolder());
    if (const auto can = checkTargetFile(call.arguments, target); !can)
        return tl::unexpected(can.error());
    if (const auto saved = replaceFile(target, bytes, OldFile::goes); !saved)
        return tl::unexpected(complaintAbout(saved.error()));
    Answer answer;
    answer.text = sentence(CommandLine::tr("%1 is described as %2, with %3 parameters: %4"),
                           {device->fullName(), key,
                            numberText(static_cast<std::int64_t>(device->parameters.size())), target}) +
                  u'\n';
    answer.json = {{QStringLiteral("file"), path},
                   {QStringLiteral("saved"), target},
                   {QStringLiteral("name"), key},
                   {QStringLiteral("parameters"), static_cast<qint64>(device->parameters.size())}};
    return answer;
}

} // namespace codewheel
