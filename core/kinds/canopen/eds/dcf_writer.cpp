// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/dcf_writer.h"

#include "kinds/canopen/protocol/canopen_reach.h"

#include <QLocale>

#include <algorithm>
#include <set>

namespace codewheel::canopen {
namespace {

constexpr int dcfVariable = 7;
constexpr int dcfArray = 8;
constexpr int dcfRecord = 9;
constexpr int bdInKbd = 1'000;

// What would end the line, or the file.
QString inOneLine(QString text)
{
    for (QChar &letter : text)
        if (letter.category() == QChar::Other_Control)
            letter = u' ';
    return text;
}

class DcfText
{
public:
    void section(const QString &name) { m_text += QStringLiteral("\r\n[%1]\r\n").arg(name); }
    void line(const char *key, const QString &value)
    {
        m_text += QLatin1String(key) + u'=' + inOneLine(value) + QStringLiteral("\r\n");
    }
    void line(const QString &key, const QString &value)
    {
        m_text += inOneLine(key) + u'=' + inOneLine(value) + QStringLiteral("\r\n");
    }
    void number(const char *key, std::int64_t value) { line(key, QString::number(value)); }
    QByteArray bytes() const { return m_text.sliced(2).toUtf8(); }

private:
    QString m_text;
};

QString dcfHex(std::uint32_t value, int digits)
{
    return QStringLiteral("0x%1").arg(value, digits, 16, QLatin1Char('0'));
}

// With quotes where blanks or quotes of its own would be lost when it is read again.
QString writtenText(const QString &text)
{
    const bool isQuoted = text.size() > 1 && text.startsWith(u'"') && text.endsWith(u'"');
    return isQuoted || text != text.trimmed() ? u'"' + text + u'"' : text;
}

// A text that is empty, or of an unknown type, would be taken for nothing or for a number without quotes.
QString writtenValue(const FileValue &value, std::optional<DataType> type)
{
    const QString text = value.text(type);
    if (!std::holds_alternative<QString>(value.value))
        return text;
    return !type || text.isEmpty() ? u'"' + text + u'"' : writtenText(text);
}

void writeValue(DcfText &dcf, const char *key, const std::optional<FileValue> &value,
                std::optional<DataType> type)
{
    if (value)
        dcf.line(key, writtenValue(*value, type));
}

bool isExported(const FileObject &object)
{
    return object.access != FileAccess::writeOnly && !isNoValue(object.object) &&
           (!object.lacksNode || (object.value && object.value != object.factory));
}

void writeObject(DcfText &dcf, const QString &section, const FileObject &object)
{
    constexpr int digitsOfType = 4;
    dcf.section(section);
    dcf.line("ParameterName", writtenText(object.name));
    dcf.line("ObjectType", dcfHex(dcfVariable, 1));
    if (object.type)
        dcf.line("DataType", dcfHex(static_cast<std::uint32_t>(*object.type), digitsOfType));
    if (object.access)
        dcf.line("AccessType", fileAccessKey(*object.access));
    writeValue(dcf, "DefaultValue", object.factory, object.type);
    writeValue(dcf, "LowLimit", object.minimum, object.type);
    writeValue(dcf, "HighLimit", object.maximum, object.type);
    dcf.line("PDOMapping", object.isMapped ? QStringLiteral("1") : QStringLiteral("0"));
    if (isExported(object))
        writeValue(dcf, "ParameterValue", object.value, object.type);
}

QString dcfIndex(std::uint16_t index)
{
    return QStringLiteral("%1").arg(index, 4, 16, QLatin1Char('0')).toUpper();
}

using ObjectsOfIndex = std::span<const FileObject>;

void writeIndex(DcfText &dcf, const DeviceFile &file, ObjectsOfIndex objects)
{
    const std::uint16_t index = objects.front().object.index;
    const auto group = file.groups.find(index);
    const bool isVariable = objects.size() == 1 && objects.front().object.sub == 0 &&
                            (group == file.groups.end() ||
                             (group->second.objectType != dcfArray && group->second.objectType != dcfRecord));
    if (isVariable)
        return writeObject(dcf, dcfIndex(index), objects.front());
    const bool hasType = group != file.groups.end() && group->second.objectType == dcfArray;
    dcf.section(dcfIndex(index));
    dcf.line("ParameterName",
             group != file.groups.end() ? writtenText(group->second.name) : objectName({index, 0}));
    dcf.line("ObjectType", dcfHex(hasType ? dcfArray : dcfRecord, 1));
    dcf.number("SubNumber", static_cast<std::int64_t>(objects.size()));
    for (const FileObject &object : objects)
        writeObject(
            dcf, dcfIndex(index) + QStringLiteral("sub") + QString::number(object.object.sub, 16).toUpper(),
            object);
}

void writeList(DcfText &dcf, const char *name, const std::vector<std::uint16_t> &indices)
{
    dcf.section(QLatin1String(name));
    dcf.number("SupportedObjects", static_cast<std::int64_t>(indices.size()));
    int row = 0;
    for (const std::uint16_t index : indices)
        dcf.line(QString::number(++row), QStringLiteral("0x") + dcfIndex(index));
}

void writeLists(DcfText &dcf, const DeviceFile &file)
{
    std::set<std::uint16_t> all;
    for (const FileObject &object : file.objects)
        all.insert(object.object.index);
    std::vector<std::uint16_t> mandatory;
    std::vector<std::uint16_t> makers;
    std::vector<std::uint16_t> others;
    for (const std::uint16_t index : all)
        (isMakers({index, 0})                                    ? makers
         : index == 0x1000 || index == 0x1001 || index == 0x1018 ? mandatory
                                                                 : others)
            .push_back(index);
    writeList(dcf, "MandatoryObjects", mandatory);
    writeList(dcf, "OptionalObjects", others);
    writeList(dcf, "ManufacturerObjects", makers);
}

void writeFileInfo(DcfText &dcf, const DeviceFile &file, const DcfHead &head)
{
    const QLocale english = QLocale::c();
    const QString time = english.toString(head.now.time(), QStringLiteral("hh:mmAP"));
    const QString date = english.toString(head.now.date(), QStringLiteral("MM-dd-yyyy"));
    dcf.section(QStringLiteral("FileInfo"));
    dcf.line("FileName", head.fileName);
    dcf.line("FileVersion", file.fileVersion.isEmpty() ? QStringLiteral("1") : file.fileVersion);
    dcf.line("FileRevision", file.fileRevision.isEmpty() ? QStringLiteral("1") : file.fileRevision);
    dcf.line("EDSVersion", QStringLiteral("4.0"));
    dcf.line("CreationTime", time);
    dcf.line("CreationDate", date);
    dcf.line("CreatedBy", QStringLiteral("Codewheel"));
    if (!head.ofFile.isEmpty())
        dcf.line("LastEDS", head.ofFile);
}

// Anything else might be read as a section or a comment.
bool isPlainKey(const QString &key)
{
    return std::ranges::all_of(
        key, [](QChar letter) { return letter.isLetterOrNumber() || letter == u'_' || letter == u' '; });
}

void writeDeviceInfo(DcfText &dcf, const DeviceFile &file)
{
    constexpr int digitsOfIdentity = 8;
    dcf.section(QStringLiteral("DeviceInfo"));
    for (const auto &[key, value] : file.deviceInfo)
        if (isPlainKey(key))
            dcf.line(key, value);
    if (!file.deviceInfo.empty())
        return;
    const FileIdentity &its = file.identity;
    dcf.line("VendorName", its.vendorName);
    dcf.line("VendorNumber", dcfHex(its.vendor.value_or(0), digitsOfIdentity));
    dcf.line("ProductName", its.productName);
    dcf.line("ProductNumber", dcfHex(its.product.value_or(0), digitsOfIdentity));
    dcf.line("RevisionNumber", dcfHex(its.revision.value_or(0), digitsOfIdentity));
}

// The name of the section has one m, as it is in CiA 306.
void writeCommissioning(DcfText &dcf, const Commissioning &its)
{
    dcf.section(QStringLiteral("DeviceComissioning"));
    dcf.line("NodeID", its.node ? QString::number(*its.node) : QString());
    dcf.line("NodeName", writtenText(its.nodeName));
    dcf.line("Baudrate", its.rate ? QString::number(*its.rate / bdInKbd) : QString());
    dcf.number("NetNumber", 0);
    dcf.number("CANopenManager", 0);
}

} // namespace

QByteArray dcfOf(const DeviceFile &file, const DcfHead &head)
{
    DcfText dcf;
    writeFileInfo(dcf, file, head);
    writeDeviceInfo(dcf, file);
    writeCommissioning(dcf, file.commissioning);
    writeLists(dcf, file);
    for (auto first = file.objects.begin(); first != file.objects.end();) {
        const auto last = std::find_if(first, file.objects.end(), [&](const FileObject &object) {
            return object.object.index != first->object.index;
        });
        writeIndex(dcf, file, ObjectsOfIndex(first, last));
        first = last;
    }
    return dcf.bytes();
}

} // namespace codewheel::canopen
