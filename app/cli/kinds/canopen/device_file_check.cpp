// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/device_file_check.h"

#include "catalog/catalog.h"
#include "cli/call/json.h"
#include "cli/call/terminal.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "kinds/canopen/eds/device_file_reader.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>

namespace codewheel {
namespace {

using canopen::DeviceFile;
using canopen::EdsNote;
using canopen::FileObject;

constexpr qint64 mostMegabytes = 16; // far larger than any EDS
constexpr qint64 bytesInMegabyte = 1 << 20;

QJsonValue keyJson(const std::optional<canopen::DataType> &type)
{
    return type ? QJsonValue(canopen::dataTypeKey(*type)) : QJsonValue();
}

QString accessText(const std::optional<canopen::FileAccess> &access)
{
    return access ? canopen::fileAccessKey(*access) : QString();
}

QString indexText(const FileObject &object)
{
    return QStringLiteral("%1").arg(object.object.index, 4, 16, QLatin1Char('0')).toUpper();
}

QJsonObject fileObjectJson(const FileObject &object)
{
    const auto value = [&](const std::optional<canopen::FileValue> &its) {
        return fileValueJson(its, object.type);
    };
    return {{QStringLiteral("index"), indexText(object)},
            {QStringLiteral("sub"), object.object.sub},
            {QStringLiteral("name"), object.name},
            {QStringLiteral("type"), keyJson(object.type)},
            {QStringLiteral("access"), textJson(accessText(object.access))},
            {QStringLiteral("default"), value(object.factory)},
            {QStringLiteral("minimum"), value(object.minimum)},
            {QStringLiteral("maximum"), value(object.maximum)},
            {QStringLiteral("mapped"), object.isMapped},
            {QStringLiteral("value"), value(object.value)}};
}

QJsonArray notesJson(const std::vector<EdsNote> &notes)
{
    QJsonArray array;
    for (const EdsNote &note : notes)
        array.append(QJsonObject{{QStringLiteral("line"), knownJson(note.line)},
                                 {QStringLiteral("key"), textJson(note.key)},
                                 {QStringLiteral("reason"), note.text()}});
    return array;
}

QJsonValue unsignedJson(const std::optional<std::uint32_t> &number)
{
    return number ? QJsonValue(static_cast<qint64>(*number)) : QJsonValue();
}

QJsonObject deviceFileJson(const DeviceFile &file)
{
    const canopen::FileIdentity &identity = file.identity;
    const auto intJson = [](std::optional<int> number) {
        return number ? QJsonValue(*number) : QJsonValue();
    };
    return {{QStringLiteral("name"), textJson(identity.productName)},
            {QStringLiteral("vendor"), textJson(identity.vendorName)},
            {QStringLiteral("vendorNumber"), unsignedJson(identity.vendor)},
            {QStringLiteral("productNumber"), unsignedJson(identity.product)},
            {QStringLiteral("revisionNumber"), unsignedJson(identity.revision)},
            {QStringLiteral("objects"), fileObjectsJson(file)},
            {QStringLiteral("commissioning"),
             QJsonObject{{QStringLiteral("node"), intJson(file.commissioning.node)},
                         {QStringLiteral("rate"), intJson(file.commissioning.rate)}}},
            {QStringLiteral("notes"), notesJson(file.notes.kept())},
            {QStringLiteral("moreNotes"), static_cast<qint64>(file.notes.left())}};
}

QString commissioningText(const canopen::Commissioning &its)
{
    QStringList parts;
    if (its.node)
        parts << sentence(CommandLine::tr("Node: %1"), {QString::number(*its.node)});
    if (its.rate)
        parts << sentence(CommandLine::tr("Rate: %1 Bd"), {QString::number(*its.rate)});
    return parts.isEmpty() ? QString() : parts.join(QStringLiteral(", ")) + u'\n';
}

QString deviceFileText(const QString &path, const DeviceFile &file)
{
    const canopen::FileIdentity &identity = file.identity;
    const QString who = (identity.vendorName + u' ' + identity.productName).trimmed();
    QString text = sentence(CommandLine::tr("%1 is read: %2, objects: %3"),
                            {path, who.isEmpty() ? CommandLine::tr("device without a name") : who,
                             numberText(static_cast<std::int64_t>(file.objects.size()))});
    text += u'\n' + commissioningText(file.commissioning) + u'\n';
    return text + fileObjectLines(file);
}

Complaint fileComplaint(RefusalId id, std::vector<RefusalArgument> arguments)
{
    return complaintAbout({RefusalKind::badInput, id, std::move(arguments)});
}

Checked<QByteArray> bytesOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(fileComplaint(RefusalId::fileNotReadable, {path, file.errorString()}));
    const QByteArray bytes = file.read(mostMegabytes * bytesInMegabyte + 1);
    if (bytes.size() > mostMegabytes * bytesInMegabyte)
        return tl::unexpected(fileComplaint(
            RefusalId::fileTooLarge, {path, std::int64_t{file.size() / bytesInMegabyte}, mostMegabytes}));
    if (bytes.isEmpty() && file.error() != QFileDevice::NoError) // a folder
        return tl::unexpected(fileComplaint(RefusalId::fileNotReadable, {path, file.errorString()}));
    return bytes;
}

QJsonObject refusedJson(const QString &path, const EdsNote &why)
{
    return {{QStringLiteral("file"), path},
            {QStringLiteral("line"), knownJson(why.line)},
            {QStringLiteral("faultKey"), why.key},
            {QStringLiteral("reason"), why.text()}};
}

} // namespace

QString fileObjectLines(const DeviceFile &file)
{
    using enum TextTable::Align;
    TextTable table({left, left, left, left, right, right, right, left, right});
    table.add({CommandLine::tr("object"), CommandLine::tr("name"), CommandLine::tr("type"),
               CommandLine::tr("access"), CommandLine::tr("default"), CommandLine::tr("minimum"),
               CommandLine::tr("maximum"), CommandLine::tr("mapped"), CommandLine::tr("value")});
    for (const FileObject &object : file.objects) {
        const auto value = [&](const std::optional<canopen::FileValue> &its) {
            return orDash(fileValueText(its, object.type));
        };
        table.add({canopen::objectName(object.object), object.name,
                   object.type ? canopen::dataTypeKey(*object.type) : QStringLiteral("-"),
                   orDash(accessText(object.access)), value(object.factory), value(object.minimum),
                   value(object.maximum), object.isMapped ? CommandLine::tr("yes") : CommandLine::tr("no"),
                   value(object.value)});
    }
    return table.toString();
}

QJsonArray fileObjectsJson(const DeviceFile &file)
{
    QJsonArray objects;
    for (const FileObject &object : file.objects)
        objects.append(fileObjectJson(object));
    return objects;
}

bool isCanopenDeviceFile(const QString &path)
{
    return path.endsWith(QStringLiteral(".eds"), Qt::CaseInsensitive) ||
           path.endsWith(QStringLiteral(".dcf"), Qt::CaseInsensitive);
}

Complaint complaintAboutDeviceFile(const QString &path, const EdsNote &why)
{
    const QString place = Catalog::Fault{path, static_cast<int>(why.line), why.key, {}}.place();
    return {ExitCode::badInput,
            refusalKey(RefusalId::deviceFileBroken),
            QStringLiteral("%1: %2").arg(place, why.text()),
            {place, why.text()}};
}

QJsonValue fileValueJson(const std::optional<canopen::FileValue> &value,
                         std::optional<canopen::DataType> type)
{
    if (!value)
        return {};
    if (const auto *real = std::get_if<double>(&value->value))
        return *real;
    const auto *number = value->number();
    const bool isPlain = number != nullptr && !value->addsNode;
    const bool isBeyond = isPlain && type == canopen::DataType::u64 && *number < 0;
    return isPlain && !isBeyond ? QJsonValue(static_cast<qint64>(*number)) : QJsonValue(value->text(type));
}

QString fileValueText(const std::optional<canopen::FileValue> &value, std::optional<canopen::DataType> type)
{
    return value ? value->text(type) : QString();
}

void complainOfNotes(const Terminal &terminal, const canopen::EdsNotes &notes)
{
    constexpr std::size_t mostShown = 20;
    const std::size_t shown = std::min(mostShown, notes.kept().size());
    for (const EdsNote &note : std::span(notes.kept()).first(shown)) {
        const QString text = note.key.isEmpty() ? note.text() : note.key + QStringLiteral(": ") + note.text();
        terminal.complain(note.line == 0
                              ? text
                              : sentence(CommandLine::tr("Line %1: %2"), {QString::number(note.line), text}));
    }
    if (const std::size_t left = notes.kept().size() - shown + notes.left(); left > 0)
        terminal.complain(sentence(CommandLine::tr("Further notes: %1. All of them with --json."),
                                   {numberText(static_cast<std::int64_t>(left))}));
}

Checked<DeviceFile> canopenDeviceFile(const QString &path)
{
    return bytesOf(path).and_then([&](const QByteArray &bytes) -> Checked<DeviceFile> {
        return canopen::readDeviceFile(bytes).map_error(
            [&](const EdsNote &why) { return complaintAboutDeviceFile(path, why); });
    });
}

Answer checkOfDeviceFile(const Call &call, const QString &path)
{
    const auto bytes = bytesOf(path);
    if (!bytes)
        return {.complaint = bytes.error()};
    const auto file = canopen::readDeviceFile(*bytes);
    if (!file)
        return {.json = refusedJson(path, file.error()),
                .complaint = complaintAboutDeviceFile(path, file.error())};
    Answer answer{.json = deviceFileJson(*file)};
    merge(answer.json, {{QStringLiteral("file"), path}});
    if (!call.arguments.has("--json"))
        complainOfNotes(call.terminal, file->notes);
    if (file->refused.empty()) {
        answer.text = deviceFileText(path, *file);
        return answer;
    }
    merge(answer.json, refusedJson(path, file->refused.front()));
    answer.complaint = complaintAboutDeviceFile(path, file->refused.front());
    return answer;
}

} // namespace codewheel
