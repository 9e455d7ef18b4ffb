// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/device/device_html.h"

#include "catalog/hex_code.h"
#include "catalog/protocol_rules.h"
#include "catalog/value_text.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace codewheel {
namespace {

class DeviceHtml
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DeviceHtml)

public:
    explicit DeviceHtml(const DeviceDescription &device)
        : m_device(device)
    {}
    QString page();

private:
    void addHeading(const QString &name, const LocalText &chapter = {});
    void addTable(const QStringList &header, const QList<QStringList> &rows);
    void addIdentity();
    void addConnectors();
    void addLeds();
    void addLimits();
    void addOrderingKey();
    void addParameters();
    void addErrors();

    const DeviceDescription &m_device;
    QString m_html;
};

QString rangeText(const ParameterDescription &parameter)
{
    if (parameter.form != nullptr && parameter.form->rangeText != nullptr)
        return parameter.form->rangeText();
    if (parameter.choices.empty())
        return QStringLiteral("%1 ... %2")
            .arg(valueText(parameter, parameter.minimum), valueText(parameter, parameter.maximum));
    QStringList choices;
    for (const Choice &choice : parameter.choices)
        choices << valueText(parameter, choice.value);
    return choices.join(QStringLiteral(", "));
}

void DeviceHtml::addHeading(const QString &name, const LocalText &chapter)
{
    m_html += QStringLiteral("<h4>%1</h4>").arg(name.toHtmlEscaped());
    if (!chapter.isEmpty())
        m_html += QStringLiteral("<p><small>%1</small></p>")
                      .arg(tr("Manual: %1", "chapter").arg(chapter.toString()).toHtmlEscaped());
}

void DeviceHtml::addTable(const QStringList &header, const QList<QStringList> &rows)
{
    const auto line = [](const QStringList &cells, const char *tag) {
        QString html = QStringLiteral("<tr>");
        for (const QString &cell : cells)
            html +=
                QStringLiteral("<%1 align=\"left\">%2</%1>").arg(QLatin1String(tag), cell.toHtmlEscaped());
        return html + QStringLiteral("</tr>");
    };
    m_html +=
        QStringLiteral("<table cellspacing=\"0\" cellpadding=\"2\" width=\"100%\">") + line(header, "th");
    for (const QStringList &row : rows)
        m_html += line(row, "td");
    m_html += QStringLiteral("</table>");
}

void DeviceHtml::addIdentity()
{
    QList<QStringList> rows{{tr("Manual"), m_device.manual}, {tr("Profile"), profileName(m_device.profile)}};
    if (m_device.hasWords()) {
        rows += {tr("Device code"), hexCode(m_device.deviceCode, 4)};
        rows +=
            {tr("Words IN / OUT"), QStringLiteral("%1 / %2").arg(m_device.inWords).arg(m_device.outWords)};
    }
    if (m_device.physicalStepsPerTurn > 0)
        rows += {tr("Steps per turn"), QLocale().toString(m_device.physicalStepsPerTurn)};
    if (m_device.physicalTurns > 0)
        rows += {tr("Turns"), QLocale().toString(m_device.physicalTurns)};
    if (!m_device.supply.value.isEmpty())
        rows +=
            {tr("Supply"),
             tr("%1 (manual: %2)").arg(m_device.supply.value.toString(), m_device.supply.chapter.toString())};
    addTable({tr("Device"), m_device.fullName()}, rows);
    if (!m_device.notes.isEmpty()) {
        addHeading(tr("Notes and assumptions"));
        m_html += QStringLiteral("<p>%1</p>").arg(m_device.notesText().toHtmlEscaped());
    }
}

void DeviceHtml::addConnectors()
{
    for (const Connector &connector : m_device.connectors) {
        addHeading(connector.name.toString(), connector.chapter);
        QList<QStringList> rows;
        for (const Pin &pin : connector.pins)
            rows += {pin.pin, pin.signal.toString(), pin.remark.toString()};
        addTable({tr("Pin"), tr("Signal"), tr("Remark")}, rows);
    }
}

void DeviceHtml::addLeds()
{
    if (!m_device.leds)
        return;
    addHeading(tr("LEDs"), m_device.leds->chapter);
    QList<QStringList> rows;
    for (const Led &lamp : m_device.leds->lamps)
        rows += {lamp.name, lamp.colour.toString(), lamp.meaning.toString()};
    addTable({tr("LED"), tr("Colour"), tr("Meaning")}, rows);
    if (m_device.leds->states.empty())
        return;
    rows.clear();
    for (const LedState &state : m_device.leds->states) {
        QStringList lamps = state.on;
        for (const QString &name : state.blinking)
            lamps << tr("%1 blinking").arg(name);
        rows += {lamps.join(QStringLiteral(" + ")), state.meaning.toString()};
    }
    addTable({tr("On"), tr("State")}, rows);
}

void DeviceHtml::addLimits()
{
    for (const LimitTable &table : m_device.limits) {
        addHeading(table.name.toString(), table.chapter);
        QList<QStringList> rows;
        for (const LimitTable::Row &row : table.rows)
            rows += {row.name.toString(), row.value.toString()};
        addTable({tr("What"), tr("Value")}, rows);
    }
}

void DeviceHtml::addOrderingKey()
{
    if (!m_device.orderingKey)
        return;
    const OrderingKey &key = *m_device.orderingKey;
    addHeading(tr("Key on the label, e.g. %1").arg(key.example), key.chapter);
    QList<QStringList> rows;
    for (const OrderingKey::Part &part : key.parts) {
        QString name = part.name.toString();
        if (part.any > 0)
            rows += {name, QString(part.any, u'_'), part.optional ? tr("any, may be missing") : tr("any")};
        for (const OrderingKey::Code &code : part.codes) {
            rows += {name, code.code, code.meaning.toString()};
            name.clear();
        }
    }
    addTable({tr("Part"), tr("Code"), tr("Meaning")}, rows);
}

void DeviceHtml::addParameters()
{
    if (m_device.parameters.empty())
        return;
    addHeading(tr("Parameters"));
    QList<QStringList> rows;
    for (const ParameterDescription &parameter : m_device.parameters) {
        const QString number =
            m_device.hasWords() ? protocolRules(m_device.profile).reachText(parameter).write : QString();
        rows += {parameterName(parameter), number.isEmpty() ? QString(QChar(0x2013)) : number,
                 rangeText(parameter), unitText(parameter.unit), parameter.chapter.toString()};
    }
    addTable({tr("Name"), tr("No."), tr("Values"), tr("Unit"), tr("Manual")}, rows);
}

void DeviceHtml::addErrors()
{
    if (m_device.errors.empty())
        return;
    addHeading(tr("Errors"));
    QList<QStringList> rows;
    for (const DeviceError &error : m_device.errors)
        rows += {QString::number(error.number),
                 error.text.isEmpty() ? deviceErrorName(error.meaning) : error.text.toString()};
    addTable({tr("No."), tr("Meaning")}, rows);
}

QString DeviceHtml::page()
{
    addIdentity();
    addConnectors();
    addLeds();
    addLimits();
    addOrderingKey();
    addParameters();
    addErrors();
    return m_html;
}

} // namespace

QString deviceHtml(const DeviceDescription &device)
{
    return DeviceHtml(device).page();
}

} // namespace codewheel
