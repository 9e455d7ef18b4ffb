// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/esc_line_settings_form.h"

#include "kinds/esc/plan/esc_line_plan.h"
#include "vocabulary/sentence.h"
#include "widgets/connect/port_field.h"
#include "widgets/connect/setting_row.h"
#include "widgets/input/number_fields.h"
#include "widgets/input/text_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/look/layouts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QIntValidator>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>

namespace codewheel {
namespace {

int wholeMilliseconds(Instant time)
{
    return static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
}

void choose(QComboBox &box, int value)
{
    box.setCurrentIndex(std::max(0, box.findData(value)));
}

void setPeriod(QSpinBox &field)
{
    field.setSuffix(EscLineSettingsForm::tr(" ms", "unit of a time"));
}

} // namespace

EscLineSettingsForm::EscLineSettingsForm(QWidget *parent)
    : LinkForm(parent)
{
    setAccessibleName(tr("Settings of the serial line"));
}

void EscLineSettingsForm::addFields()
{
    m_port = new PortField(this);
    m_rateTold = new InlineMessage(this);
    auto *form = makeForm(this, grid::margin);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    makePort(*form);
    makeCharacter(*form);
    makeTimes(*form);
    makeEncoder(*form);
    setFocusProxy(m_port);
    describe(m_baudRate->lineEdit(), m_baudRate->accessibleName(), m_baudRate->toolTip());
    showSettings(m_given);
}

QString EscLineSettingsForm::sentence() const
{
    return tr("Encoders at a serial adapter. From connecting on they are asked for positions.");
}

bool EscLineSettingsForm::showPlan(const KindData &plan)
{
    const auto *line = plan.as<EscLinePlan>();
    if (line != nullptr)
        setSettings(line->settings);
    return line != nullptr && !line->settings.port.isEmpty(); // without a port, it is the training line
}

KindData EscLineSettingsForm::plan() const
{
    return KindData(EscLinePlan{settings(), {}});
}

QComboBox *EscLineSettingsForm::addChoice(QFormLayout &form, const QString &label, const QString &toolTip)
{
    auto *box = describe(new QComboBox(this), plainLabel(label), toolTip);
    addSettingRow(form, label, box, box, toolTip);
    connect(box, &QComboBox::currentTextChanged, this, &EscLineSettingsForm::edited);
    return box;
}

IntegerField *EscLineSettingsForm::addNumber(QFormLayout &form, const QString &label, const QString &toolTip,
                                             line_limits::Limits limits)
{
    auto *field = describe(new IntegerField(this), plainLabel(label), toolTip);
    field->setRange(limits.least, limits.most);
    addSettingRow(form, label, field, field, toolTip);
    connect(field, &QSpinBox::valueChanged, this, &EscLineSettingsForm::edited);
    return field;
}

void EscLineSettingsForm::makePort(QFormLayout &form)
{
    m_port->addTo(form, tr("&Port"));
    connect(m_port, &PortField::refreshWanted, this, &EscLineSettingsForm::portsWanted);
    connect(m_port, &PortField::edited, this, &EscLineSettingsForm::edited);
}

void EscLineSettingsForm::makeCharacter(QFormLayout &form)
{
    m_baudRate = addChoice(form, tr("Ba&ud rate"),
                           tr("19200, 9600 or 4800; any other may be typed. 19200 is that of the factory"));
    m_baudRate->setEditable(true);
    m_baudRate->setLineEdit(new TextField(m_baudRate));
    m_baudRate->setInsertPolicy(QComboBox::NoInsert);
    for (const int rate : {19'200, 9'600, 4'800})
        m_baudRate->addItem(QString::number(rate), rate);
    m_baudRate->lineEdit()->setValidator(
        new QIntValidator(line_limits::baudRate.least, line_limits::baudRate.most, this));
    form.addRow(m_rateTold);
    connect(m_rateTold, &InlineMessage::actionTriggered, this, &EscLineSettingsForm::takeRate);
    m_dataBits = addChoice(form, tr("Dat&a bits"), tr("8 for these encoders"));
    m_parity = addChoice(form, tr("Parit&y"), tr("None for these encoders"));
    m_stopBits = addChoice(form, tr("&Stop bits"), tr("2 for these encoders"));
    for (const int bits : {8, 7})
        m_dataBits->addItem(QString::number(bits), bits);
    m_parity->addItem(tr("none", "parity"), static_cast<int>(SerialSettings::Parity::none));
    m_parity->addItem(tr("even", "parity"), static_cast<int>(SerialSettings::Parity::even));
    m_parity->addItem(tr("odd", "parity"), static_cast<int>(SerialSettings::Parity::odd));
    for (const int bits : {2, 1})
        m_stopBits->addItem(QString::number(bits), bits);
    m_lowLatency = new QCheckBox(tr("Lo&w latency"), this);
    m_lowLatency->setToolTip(
        tr("Asks the adapter to hand over bytes at once. Many collect them for up to 16 ms (Alt+W)"));
    addSettingRow(form, QString(), m_lowLatency, m_lowLatency,
                  tr("Without it many adapters collect bytes for up to 16 ms"));
}

void EscLineSettingsForm::makeTimes(QFormLayout &form)
{
    m_pollInterval =
        addNumber(form, tr("Poll &interval"),
                  tr("Between position requests of one encoder; 10 ms is the shortest of the manual"),
                  line_limits::pollInterval);
    m_timeOut =
        addNumber(form, tr("Time-&out"), tr("From the end of a request to the beginning of its answer"),
                  line_limits::timeOut);
    m_retries = addNumber(form, tr("&Number of retries"),
                          tr("How often a read is sent again. A write never is"), line_limits::retries);
    m_quiet = addNumber(form, tr("&Quiet time after a write"),
                        tr("How long nothing is sent after a write: the encoder stores it"),
                        line_limits::quietAfterWrite);
    for (QSpinBox *field : {m_pollInterval, m_timeOut, m_quiet})
        setPeriod(*field);
}

void EscLineSettingsForm::makeEncoder(QFormLayout &form)
{
    makeFractionBits(form);
    m_topSpeed = describe(new DecimalField(this), tr("Maximum speed"),
                          tr("A position that jumps further than this speed allows is marked suspect "
                             "and asked for again"));
    m_topSpeed->setRange(line_limits::topSpeed.least, line_limits::topSpeed.most);
    m_topSpeed->setDecimals(0);
    m_topSpeed->setSingleStep(100.0);
    m_topSpeed->setSuffix(tr(" rpm", "revolutions per minute"));
    addSettingRow(form, tr("Ma&ximum speed"), m_topSpeed, m_topSpeed, m_topSpeed->toolTip());
}

void EscLineSettingsForm::makeFractionBits(QFormLayout &form)
{
    m_fractionBits = describe(new IntegerField(this), tr("Fraction bits of the scaling factor"),
                              tr("29 fits the example of the manual; it can be determined from a device"));
    m_fractionBits->setRange(line_limits::fractionBits.least, line_limits::fractionBits.most);
    m_determine = new QPushButton(tr("Deter&mine"), this);
    m_determine->setAutoDefault(false);
    m_determine->setToolTip(
        tr("Reads scaling factor, steps per turn and measuring range of the chosen encoder of the line, or "
           "else of the first that answers, and keeps the format that fits. Nothing is written (Alt+M)"));
    m_determine->setEnabled(m_canDetermine);
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::unit);
    row->addWidget(m_fractionBits, 1);
    row->addWidget(m_determine);
    addSettingRow(form, tr("Fraction bits of the scalin&g factor"), row, m_fractionBits,
                  m_fractionBits->toolTip());
    connect(m_determine, &QPushButton::clicked, this, &EscLineSettingsForm::fractionBitsWanted);
}

void EscLineSettingsForm::setCanDetermine(bool can)
{
    m_canDetermine = can;
    if (hasFields())
        m_determine->setEnabled(can);
}

void EscLineSettingsForm::setFractionBits(int bits)
{
    m_given.fractionBits = bits;
    if (hasFields())
        m_fractionBits->setValue(bits);
}

void EscLineSettingsForm::showPorts(const std::vector<PortRow> &ports, const Trouble &trouble)
{
    m_port->setPorts(ports, trouble);
}

// With what the form does not show.
EscLineSettings EscLineSettingsForm::settings() const
{
    EscLineSettings settings = m_given;
    if (hasFields())
        readFields(settings);
    if (settings.serial.baudRate > 0)
        settings.timing.character = settings.serial.timeOf(1);
    return settings;
}

void EscLineSettingsForm::readFields(EscLineSettings &settings) const
{
    using std::chrono::milliseconds;
    settings.port = m_port->port();
    settings.serial.baudRate = m_baudRate->currentText().toInt();
    settings.serial.dataBits = m_dataBits->currentData().toInt();
    settings.serial.parity = static_cast<SerialSettings::Parity>(m_parity->currentData().toInt());
    settings.serial.stopBits = m_stopBits->currentData().toInt();
    settings.serial.lowLatency = m_lowLatency->isChecked();
    settings.timing.answerTimeOut = milliseconds(m_timeOut->value());
    settings.timing.retries = m_retries->value();
    settings.timing.quietAfterWrite = milliseconds(m_quiet->value());
    settings.pollInterval = milliseconds(m_pollInterval->value());
    settings.fractionBits = m_fractionBits->value();
    settings.topSpeed = m_topSpeed->value();
}

void EscLineSettingsForm::setPort(const QString &port)
{
    m_given.port = port;
    if (hasFields())
        m_port->setPort(port);
}

void EscLineSettingsForm::setSettings(const EscLineSettings &settings)
{
    m_given = settings;
    if (hasFields())
        showSettings(settings);
}

void EscLineSettingsForm::showSettings(const EscLineSettings &settings)
{
    m_port->setPort(settings.port);
    m_baudRate->setEditText(QString::number(settings.serial.baudRate));
    choose(*m_dataBits, settings.serial.dataBits);
    choose(*m_parity, static_cast<int>(settings.serial.parity));
    choose(*m_stopBits, settings.serial.stopBits);
    m_lowLatency->setChecked(settings.serial.lowLatency);
    m_pollInterval->setValue(wholeMilliseconds(settings.pollInterval));
    m_timeOut->setValue(wholeMilliseconds(settings.timing.answerTimeOut));
    m_retries->setValue(settings.timing.retries);
    m_quiet->setValue(wholeMilliseconds(settings.timing.quietAfterWrite));
    m_fractionBits->setValue(settings.fractionBits);
    m_topSpeed->setValue(settings.topSpeed);
}

void EscLineSettingsForm::tellBaudRate(const QString &sentence, std::optional<int> wanted)
{
    if (sentence.isEmpty() && !hasFields())
        return; // nothing was told
    makeFields();
    m_rateWanted = wanted;
    m_rateTold->showMessage(Role::attention, sentence,
                            wanted ? tr("Set the line to %1 Bd").arg(QLocale().toString(*wanted))
                                   : QString());
}

void EscLineSettingsForm::takeRate()
{
    if (!m_rateWanted)
        return;
    m_rateTold->withdraw();
    m_baudRate->setEditText(QString::number(*m_rateWanted));
    Q_EMIT baudRateWanted(*m_rateWanted);
}

QString EscLineSettingsForm::wrong() const
{
    if (line_limits::baudRate.hold(settings().serial.baudRate))
        return {};
    return tr("The baud rate is a number from %1 to %2.")
        .arg(QString::number(line_limits::baudRate.least), QString::number(line_limits::baudRate.most));
}

// A line may be planned before anybody knows its port.
QString EscLineSettingsForm::complaint() const
{
    return settings().port.isEmpty() ? tr("Choose a serial port, or type the path of one.") : QString();
}

bool EscLineSettingsForm::isPicked() const
{
    return hasFields() && m_port->isPicked();
}

} // namespace codewheel
