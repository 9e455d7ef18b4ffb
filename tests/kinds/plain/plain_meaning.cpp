// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/plain_meaning.h"

#include "catalog/value_text.h"
#include "tests/kinds/plain/plain_protocol.h"

namespace codewheel::test {
namespace {

const ParameterDescription *describedBy(const DeviceDescription &device, const QByteArray &key)
{
    const auto parameter = parameterFromKey(QString::fromLatin1(key));
    return parameter ? device.find(*parameter) : nullptr;
}

QString valuesIn(const DeviceDescription &device, const QByteArray &values, const QString &sign)
{
    QStringList texts;
    for (const QByteArray &one : values.split(' ')) {
        const QByteArray key = one.left(one.indexOf('='));
        const ParameterDescription *its = describedBy(device, key);
        if (its == nullptr || key.size() == one.size())
            return {};
        texts << parameterName(its->parameter) + sign +
                     valueText(*its, plainValue(*its, one.mid(key.size() + 1)));
    }
    return texts.join(QStringLiteral(", "));
}

class PlainRows final : public RecordedRows
{
public:
    std::span<const TrafficColumn> columns() const override { return plainColumns; }
    TrafficRow explained(TrafficRow row, const EncoderAt &encoder) override
    {
        const EncoderSession *its = row.place ? encoder(*row.place) : nullptr;
        if (its != nullptr)
            row.meaning = [device = its->device(), line = row.bytes] { return plainMeaning(device, line); };
        return row;
    }
    void restart() override {}
};

} // namespace

QString plainMeaning(const DeviceDescription &device, const QByteArray &line)
{
    static const std::map<QByteArray, QString> words{{"go", QStringLiteral("what was given is in force")},
                                                     {"keep", QStringLiteral("what is in force is stored")},
                                                     {"ok", QStringLiteral("done")},
                                                     {"at", QStringLiteral("position?")},
                                                     {"none", QStringLiteral("it has no values yet")}};
    if (const auto word = words.find(line); word != words.end())
        return word->second;
    if (line.startsWith("to ") || line.startsWith("at "))
        return QStringLiteral("the position is ") + QString::fromLatin1(line.mid(3));
    if (line.startsWith("get ")) {
        const ParameterDescription *its = describedBy(device, line.mid(4));
        return its != nullptr ? parameterName(its->parameter) + u'?' : QString();
    }
    const bool gives = line.startsWith("set ") || line.startsWith("all ");
    return gives ? valuesIn(device, line.mid(4), QStringLiteral(" := "))
                 : valuesIn(device, line, QStringLiteral(" = "));
}

std::unique_ptr<RecordedRows> makePlainRows()
{
    return std::make_unique<PlainRows>();
}

} // namespace codewheel::test
