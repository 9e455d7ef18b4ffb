// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/can_settings_form.h"

#include "can/can_state.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/connect/port_field.h"
#include "widgets/connect/setting_row.h"
#include "widgets/kinds/canopen/can_interface_field.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/label_text.h"
#include "widgets/look/layouts.h"

#include <QComboBox>
#include <QFormLayout>

namespace codewheel {
namespace {

const CanSetting &settingOfRate()
{
    return *canSetting(QString::fromLatin1(canRateKey));
}

const CanSetting &settingOfPort()
{
    return *canSetting(QString::fromLatin1(canBaudKey));
}

QString rateInKilobits(int rate)
{
    return sentence(CanSettingsForm::tr("%1 kBit/s"), {inKilobits(rate)});
}

} // namespace

CanSettingsForm::CanSettingsForm(Adapter adapter, QWidget *parent)
    : LinkForm(parent)
    , m_adapter(adapter)
{
    setAccessibleName(tr("Settings of the CAN bus"));
}

QString CanSettingsForm::title() const
{
    return isSerial() ? tr("Serial CAN adapter (SLCAN)") : tr("CAN interface");
}

QString CanSettingsForm::sentence() const
{
    return isSerial()
               ? tr("An adapter at a serial port that speaks SLCAN. From connecting on the bus is "
                    "listened to; nothing is sent before you switch to Operate.")
               : tr("An interface of the system (SocketCAN). From connecting on the bus is listened to; "
                    "nothing is sent before you switch to Operate.");
}

void CanSettingsForm::addFields()
{
    auto *form = makeForm(this, grid::margin);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    if (isSerial()) {
        m_port = new PortField(this);
        m_port->addTo(*form, tr("&Port"));
        setFocusProxy(m_port);
        connect(m_port, &PortField::refreshWanted, this, &CanSettingsForm::portsWanted);
        connect(m_port, &PortField::edited, this, &CanSettingsForm::edited);
    } else {
        m_interface = new CanInterfaceField(this);
        m_interface->addTo(*form, tr("&Interface"));
        setFocusProxy(m_interface);
        connect(m_interface, &CanInterfaceField::refreshWanted, this, &CanSettingsForm::portsWanted);
        connect(m_interface, &CanInterfaceField::edited, this, &CanSettingsForm::edited);
    }
    makeRate(*form);
    if (isSerial())
        makeBaudRate(*form);
    showSettings(m_given);
    if (m_interface != nullptr && m_interfaces)
        m_interface->setInterfaces(*m_interfaces);
    m_interfaces.reset();
}

// The rate of an interface is the system's, and cannot be set from here.
void CanSettingsForm::makeRate(QFormLayout &form)
{
    const CanSetting &its = settingOfRate();
    const QString what = isSerial() ? its.sentence()
                                    : tr("While the interface is on, that of the system counts. This one is "
                                         "in the command that switches it on");
    m_rate = describe(new QComboBox(this), "canRate", plainLabel(its.label()), what);
    for (const int rate : its.ofAdapters)
        m_rate->addItem(rateInKilobits(rate), rate);
    addSettingRow(form, its.label(), m_rate, m_rate, what);
    connect(m_rate, &QComboBox::currentIndexChanged, this, [this] {
        if (m_interface != nullptr)
            m_interface->setRate(m_rate->currentData().toInt());
        Q_EMIT edited();
    });
}

void CanSettingsForm::makeBaudRate(QFormLayout &form)
{
    const CanSetting &its = settingOfPort();
    m_baudRate = describe(new IntegerField(this), "canBaudRate", plainLabel(its.label()), its.sentence());
    m_baudRate->setRange(its.least, its.most);
    m_baudRate->setSuffix(tr(" Bd", "unit of a rate"));
    leaveSeparatorsOut(*m_baudRate);
    addSettingRow(form, its.label(), m_baudRate, m_baudRate, its.sentence());
    connect(m_baudRate, &QSpinBox::valueChanged, this, &CanSettingsForm::edited);
}

bool CanSettingsForm::showPlan(const KindData &plan)
{
    const auto *its = plan.as<CanopenPlan>();
    if (its == nullptr || its->settings.isSimulated())
        return false;
    const auto link = canLinkOf(its->settings);
    if (link ? link->isSerial != isSerial() : isSerial()) // what is not understood is shown as an interface
        return false;
    m_given = its->settings;
    if (hasFields())
        showSettings(m_given);
    return true;
}

void CanSettingsForm::showSettings(const CanopenSettings &settings)
{
    const auto link = canLinkOf(settings);
    const QString where = link ? link->where : settings.link.section(u':', 1);
    chooseRate(settings.rate);
    if (m_port != nullptr)
        m_port->setPort(where);
    if (m_interface != nullptr) {
        m_interface->setRate(settings.rate);
        m_interface->setInterface(where);
    }
    if (m_baudRate != nullptr)
        m_baudRate->setValue(link ? link->baudRate : settingOfPort().usual);
}

// An interface may have one that no serial adapter has.
void CanSettingsForm::chooseRate(int rate)
{
    if (m_rate->findData(rate) < 0)
        m_rate->addItem(rateInKilobits(rate), rate);
    m_rate->setCurrentIndex(m_rate->findData(rate));
}

void CanSettingsForm::setInterfaces(const CanInterfaceRows &interfaces)
{
    if (m_interface != nullptr)
        m_interface->setInterfaces(interfaces);
    else
        m_interfaces = interfaces;
}

void CanSettingsForm::showPorts(const std::vector<PortRow> &ports, const Trouble &trouble)
{
    if (m_port != nullptr)
        m_port->setPorts(ports, trouble);
}

QString CanSettingsForm::where() const
{
    return isSerial() ? m_port->port() : m_interface->interface();
}

CanopenSettings CanSettingsForm::settings() const
{
    if (!hasFields())
        return m_given;
    const CanLinkArgument link{.isSerial = isSerial(),
                               .where = where(),
                               .rate = m_rate->currentData().toInt(),
                               .baudRate = isSerial() ? m_baudRate->value() : CanLinkArgument::usualBaudRate};
    return canopenSettings(link, link.rate);
}

KindData CanSettingsForm::plan() const
{
    return KindData(CanopenPlan{settings()});
}

// A bus without a link is the simulated one, so it cannot be planned before anybody knows its adapter.
QString CanSettingsForm::wrong() const
{
    if (hasFields() && where().isEmpty())
        return isSerial() ? tr("Choose a serial port, or type the path of one.")
                          : tr("Choose a CAN interface, or type the name of one.");
    const auto link = canLinkOf(settings());
    return link ? QString() : refusalText(link.error());
}

} // namespace codewheel
