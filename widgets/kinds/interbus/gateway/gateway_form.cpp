// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/gateway/gateway_form.h"

#include "kinds/interbus/plan/ring_plan.h"
#include "vocabulary/refusal_text.h"
#include "widgets/connect/port_field.h"
#include "widgets/connect/setting_row.h"
#include "widgets/input/number_fields.h"
#include "widgets/input/text_fields.h"
#include "widgets/kinds/interbus/gateway/gateway_presets.h"
#include "widgets/kinds/interbus/gateway/setting_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/label_text.h"
#include "widgets/look/layouts.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSignalBlocker>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

const QString noneSetting = QStringLiteral("none"); // as settings write it

// Where a field may be empty, it shows what that means.
QString textIn(const QLineEdit &field)
{
    const QString text = field.text().trimmed();
    const QString empty = field.placeholderText();
    return !empty.isEmpty() && (text.isEmpty() || text.compare(empty, Qt::CaseInsensitive) == 0) ? noneSetting
                                                                                                 : text;
}

constexpr int longestHost = 253; // RFC 1035

constexpr std::array registerSettings{"in-area", "in",      "out",        "write", "order",
                                      "status",  "run-bit", "fault-bits", "place", "control"};

const QString hostSetting = QStringLiteral("host");
const QString portSetting = QStringLiteral("port");

// With host or port; those that are not given have their defaults.
std::map<QString, QString> allTexts(GatewaySettings::Transport transport,
                                    const std::map<QString, QString> &given)
{
    std::map<QString, QString> all = allSettingTexts({.transport = transport});
    all[portSetting] = QString();
    if (transport == GatewaySettings::Transport::tcp)
        all[hostSetting] = QString();
    for (const auto &[name, text] : given)
        if (const auto its = all.find(name); its != all.end())
            its->second = text;
    return all;
}

// The settings that a preset decides; what it does not name is as usual.
std::map<QString, QString> registersOf(const GatewayPreset &preset, GatewaySettings::Transport transport)
{
    const std::map<QString, QString> usual = allSettingTexts({.transport = transport});
    std::map<QString, QString> registers = preset.registers;
    for (const char *name : registerSettings)
        registers.insert(*usual.find(QString::fromLatin1(name)));
    return registers;
}

} // namespace

GatewayForm::GatewayForm(GatewaySettings::Transport transport, QWidget *parent)
    : LinkForm(parent)
    , m_transport(transport)
    , m_given(allTexts(transport, {}))
{}

void GatewayForm::addFields()
{
    auto *form = makeForm(this, grid::margin);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    makeWhere(*form);
    makePresets(*form);
    for (const SettingField &field : settingFields(m_transport))
        addField(*form, field);
    showLast();
    showTexts(m_given);
}

QString GatewayForm::title() const
{
    return m_transport == GatewaySettings::Transport::tcp ? tr("Modbus/TCP gateway")
                                                          : tr("Modbus RTU gateway");
}

QString GatewayForm::sentence() const
{
    return tr(
        "A bus coupler or controller that shows the words of the ring as Modbus registers. It cannot say "
        "which devices there are: the bus structure of the project does.");
}

void GatewayForm::makeWhere(QFormLayout &form)
{
    if (m_transport == GatewaySettings::Transport::rtu) {
        m_port = new PortField(this);
        m_port->addTo(form, tr("Serial &port"));
        connect(m_port, &PortField::edited, this, &LinkForm::edited);
        connect(m_port, &PortField::refreshWanted, this, &LinkForm::portsWanted);
        return;
    }
    m_host = describe(new TextField(this), "host", tr("Host"),
                      tr("The name or address of the gateway in the network, such as 192.168.0.5"));
    m_host->setMaxLength(longestHost);
    m_host->setPlaceholderText(QStringLiteral("192.168.0.5"));
    addSettingRow(form, tr("Ho&st"), m_host, m_host, m_host->toolTip());
    m_tcpPort = describe(new IntegerField(this), "tcpPort", tr("Port"), tr("502 with nearly every gateway"));
    m_tcpPort->setRange(gateway_limits::tcpPort.least, gateway_limits::tcpPort.most);
    leaveSeparatorsOut(*m_tcpPort);
    addSettingRow(form, tr("&Port"), m_tcpPort, m_tcpPort, m_tcpPort->toolTip());
    connect(m_host, &QLineEdit::textEdited, this, &LinkForm::edited);
}

void GatewayForm::makePresets(QFormLayout &form)
{
    m_preset = describe(new QComboBox(this), "preset", tr("Register map"),
                        tr("Sets the registers below as they are with usual gateways"));
    m_presetSentence = addSettingRow(form, tr("Register m&ap"), m_preset, m_preset, {});
    for (const GatewayPreset &preset : gatewayPresets())
        m_preset->addItem(preset.title);
    m_preset->addItem(tr("As set below"));
    connect(m_preset, &QComboBox::activated, this, &GatewayForm::usePreset);
}

void GatewayForm::addField(QFormLayout &form, const SettingField &field)
{
    const QString name = plainLabel(field.label);
    QWidget *editor = nullptr;
    if (field.isText) {
        auto *text = describe(new TextField(this), name, field.sentence);
        text->setPlaceholderText(field.none);
        connect(text, &QLineEdit::textEdited, this, &GatewayForm::showPreset);
        m_texts[field.name] = text;
        editor = text;
    } else if (!field.choices.empty()) {
        auto *box = describe(new QComboBox(this), name, field.sentence);
        for (const SettingField::Choice &choice : field.choices)
            box->addItem(choice.text, choice.value);
        connect(box, &QComboBox::currentIndexChanged, this, &GatewayForm::showPreset);
        m_choices[field.name] = box;
        editor = box;
    } else {
        auto *number = describe(new IntegerField(this), name, field.sentence);
        number->setRange(field.limits.least - (field.none.isEmpty() ? 0 : 1), field.limits.most);
        number->setSpecialValueText(field.none);
        number->setSuffix(field.unit);
        if (field.unit.isEmpty())
            leaveSeparatorsOut(*number);
        connect(number, &QSpinBox::valueChanged, this, &GatewayForm::showPreset);
        m_numbers[field.name] = number;
        editor = number;
    }
    editor->setObjectName(field.name);
    addSettingRow(form, field.label, editor, editor, field.sentence);
}

GatewayForm::Texts GatewayForm::texts() const
{
    if (!hasFields())
        return m_given;
    Texts texts;
    for (const auto &[name, box] : m_choices)
        texts[name] = box->currentData().toString();
    for (const auto &[name, text] : m_texts)
        texts[name] = textIn(*text);
    for (const auto &[name, number] : m_numbers) {
        const bool isNone = !number->specialValueText().isEmpty() && number->value() == number->minimum();
        texts[name] = isNone ? noneSetting : QString::number(number->value());
    }
    if (m_host != nullptr)
        texts[hostSetting] = m_host->text().trimmed();
    texts[portSetting] = m_port != nullptr ? m_port->port() : QString::number(m_tcpPort->value());
    return texts;
}

// Those that are not given get their defaults.
void GatewayForm::setTexts(const Texts &texts)
{
    const Texts all = allTexts(m_transport, texts);
    if (hasFields())
        showTexts(all);
    else
        m_given = all;
}

void GatewayForm::showTexts(const Texts &texts)
{
    const QScopedValueRollback setting(m_isSetting, true);
    for (const auto &[name, box] : m_choices)
        box->setCurrentIndex(std::max(0, box->findData(texts.at(name))));
    for (const auto &[name, text] : m_texts)
        text->setText(texts.at(name) == noneSetting ? QString() : texts.at(name));
    for (const auto &[name, number] : m_numbers) {
        bool isNumber = false;
        const int value = texts.at(name).toInt(&isNumber);
        number->setValue(isNumber ? value : number->minimum());
    }
    const QString &port = texts.at(portSetting);
    if (m_port != nullptr)
        m_port->setPort(port);
    if (m_host != nullptr)
        m_host->setText(texts.at(hostSetting));
    if (m_tcpPort != nullptr)
        m_tcpPort->setValue(port.isEmpty() ? modbus_limit::tcpPort : port.toInt());
    m_isSetting = false;
    showPreset();
}

bool GatewayForm::showPlan(const KindData &plan)
{
    const auto *link = plan.as<ProjectLink>();
    const bool isOurs = link != nullptr && link->kind == linkKindOf({.transport = m_transport});
    if (isOurs)
        setTexts(link->settings);
    return isOurs;
}

KindData GatewayForm::plan() const
{
    const QString kind = linkKindOf({.transport = m_transport});
    const auto its = settings(); // if they are refused, wrong() says so
    return KindData(ProjectLink{kind, its ? linkTexts(*its) : texts()});
}

Result<GatewaySettings> GatewayForm::settings() const
{
    return gatewaySettings(linkKindOf({.transport = m_transport}), texts());
}

QString GatewayForm::wrong() const
{
    const auto its = settings();
    return its ? QString() : refusalText(its.error());
}

QString GatewayForm::complaint() const
{
    const bool isTcp = m_transport == GatewaySettings::Transport::tcp;
    if (!texts().at(isTcp ? hostSetting : portSetting).isEmpty())
        return {};
    return isTcp ? tr("Enter the name or address of the gateway.")
                 : tr("Choose a serial port, or type the path of one.");
}

void GatewayForm::showPorts(const std::vector<PortRow> &ports, const Trouble &trouble)
{
    if (m_port != nullptr)
        m_port->setPorts(ports, trouble);
}

void GatewayForm::setLast(const Texts &texts)
{
    m_last = texts;
    if (hasFields())
        showLast();
}

void GatewayForm::showLast()
{
    const int behind = static_cast<int>(gatewayPresets().size()) + 1;
    if (m_preset->count() > behind)
        m_preset->removeItem(behind);
    if (!m_last.empty())
        m_preset->addItem(tr("As used last: %1").arg(m_last[m_host != nullptr ? hostSetting : portSetting]));
}

GatewayForm::Texts GatewayForm::withRegistersOf(const GatewayPreset &preset) const
{
    Texts wanted = texts();
    const Texts usual = allSettingTexts({.transport = m_transport});
    for (const char *name : registerSettings)
        wanted[QString::fromLatin1(name)] = usual.at(QString::fromLatin1(name));
    for (const auto &[name, text] : preset.registers)
        wanted[name] = text;
    return wanted;
}

// The test that found them stays valid.
void GatewayForm::propose(const Texts &texts)
{
    const QSignalBlocker blocker(this);
    Texts wanted = this->texts();
    for (const auto &[name, text] : texts)
        wanted[name] = text;
    setTexts(wanted);
}

// Of a preset only the registers; what was used last is all of it.
void GatewayForm::usePreset(int index)
{
    const auto presets = gatewayPresets();
    const auto i = static_cast<std::size_t>(index);
    if (i > presets.size())
        setTexts(m_last);
    else if (i < presets.size())
        setTexts(withRegistersOf(presets[i]));
    Q_EMIT edited();
}

// The one whose registers are set.
void GatewayForm::showPreset()
{
    if (m_isSetting)
        return;
    const auto presets = gatewayPresets();
    const Texts set = texts();
    const auto isSet = [&](const GatewayPreset &preset) {
        return std::ranges::all_of(registersOf(preset, m_transport),
                                   [&](const auto &its) { return set.at(its.first) == its.second; });
    };
    const auto chosen = static_cast<std::size_t>(std::ranges::find_if(presets, isSet) - presets.begin());
    m_preset->setCurrentIndex(static_cast<int>(chosen));
    m_presetSentence->setText(chosen < presets.size()
                                  ? presets[chosen].sentence
                                  : tr("The settings below are those of no usual gateway."));
    Q_EMIT edited();
}

} // namespace codewheel
