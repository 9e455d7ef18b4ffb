// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_settings_form.h"

#include "encoder/sentence.h"
#include "widgets/connect/port_field.h"
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
#include <QScrollArea>
#include <QSpinBox>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int widestForm = 160 * grid::unit; // in a wide window its fields stay near their labels

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
    field.setSuffix(LineSettingsForm::tr(" ms", "unit of a time"));
}

} // namespace

LineSettingsForm::LineSettingsForm(QWidget *parent)
    : Page(parent)
    , m_content(new QWidget(this))
    , m_port(new PortField(m_content))
    , m_rateTold(new InlineMessage(m_content))
    , m_problem(new InlineMessage(m_content))
    , m_keep(new QPushButton(lineIcon(Icon::save), tr("&Keep in project"), m_content))
    , m_connect(new QPushButton(lineIcon(Icon::start), tr("&Connect"), m_content))
{
    setAccessibleName(tr("Settings of the serial line"));
    m_content->setMaximumWidth(widestForm);
    auto *column = layOut<QVBoxLayout>(m_content, grid::margin, grid::margin);
    auto *form = new QFormLayout;
    form->setHorizontalSpacing(grid::groupGap);
    form->setVerticalSpacing(grid::unit);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    makePort(*form);
    makeCharacter(*form);
    makeTimes(*form);
    makeEncoder(*form);
    column->addLayout(form);
    column->addWidget(m_problem);
    m_connect->setToolTip(
        tr("Opens the line, and asks for positions from then on. Nothing is written (Alt+C)"));
    m_connect->setAutoDefault(false);
    m_keep->setToolTip(tr("Plans port and settings in the project. Nothing is opened (Alt+K)"));
    m_keep->setAutoDefault(false);
    connect(m_keep, &QPushButton::clicked, this, &LineSettingsForm::keep);
    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_keep);
    buttons->addWidget(m_connect);
    column->addLayout(buttons);
    column->addStretch(1);
    auto *area = new QScrollArea(this); // for low windows
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidgetResizable(true);
    area->setWidget(m_content);
    layOutColumn(this, {area}, {.margins = QMargins()});
    setFocusProxy(m_port);
    describe(m_baudRate->lineEdit(), m_baudRate->accessibleName(), m_baudRate->toolTip());
    connect(m_connect, &QPushButton::clicked, this, &LineSettingsForm::connectNow);
    setSettings({});
}

void LineSettingsForm::setAbout(const QString &line)
{
    m_about = line;
    Q_EMIT headChanged();
}

QString LineSettingsForm::effect() const
{
    return tr("Connect asks for positions from then on. Nothing is written to an encoder.");
}

void LineSettingsForm::setConnecting(bool on)
{
    m_connect->setEnabled(!on);
    m_connect->setText(on ? tr("Connecting…") : tr("&Connect"));
}

void LineSettingsForm::setCanKeep(bool can)
{
    m_keep->setEnabled(can);
}

QComboBox *LineSettingsForm::addChoice(QFormLayout &form, const QString &label, const QString &toolTip)
{
    auto *box = describe(new QComboBox(m_content), plainLabel(label), toolTip);
    form.addRow(label, box);
    return box;
}

QSpinBox *LineSettingsForm::addNumber(QFormLayout &form, const QString &label, const QString &toolTip,
                                      line_limits::Limits limits)
{
    auto *field = describe(new IntegerField(m_content), plainLabel(label), toolTip);
    field->setRange(limits.least, limits.most);
    form.addRow(label, field);
    return field;
}

void LineSettingsForm::makePort(QFormLayout &form)
{
    m_port->addTo(form, tr("&Port"));
    connect(m_port, &PortField::refreshWanted, this, &LineSettingsForm::refreshWanted);
    connect(m_port, &PortField::edited, m_problem, &InlineMessage::withdraw);
    connect(m_problem, &InlineMessage::actionTriggered, this, &LineSettingsForm::connectOther);
}

void LineSettingsForm::makeCharacter(QFormLayout &form)
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
    connect(m_rateTold, &InlineMessage::actionTriggered, this, &LineSettingsForm::takeRate);
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
    m_lowLatency = new QCheckBox(tr("&Low latency"), m_content);
    m_lowLatency->setToolTip(
        tr("Asks the adapter to hand over bytes at once. Many collect them for up to 16 ms (Alt+L)"));
    form.addRow(QString(), m_lowLatency);
}

void LineSettingsForm::makeTimes(QFormLayout &form)
{
    m_pollInterval =
        addNumber(form, tr("Poll &interval"),
                  tr("Between position requests of one encoder; 10 ms is the shortest of the manual"),
                  line_limits::pollInterval);
    m_timeOut =
        addNumber(form, tr("&Time-out"), tr("From the end of a request to the beginning of its answer"),
                  line_limits::timeOut);
    m_retries = addNumber(form, tr("&Number of retries"),
                          tr("How often a read is sent again. A write never is"), line_limits::retries);
    m_quiet = addNumber(form, tr("&Quiet time after a write"),
                        tr("How long nothing is sent after a write: the encoder stores it"),
                        line_limits::quietAfterWrite);
    for (QSpinBox *field : {m_pollInterval, m_timeOut, m_quiet})
        setPeriod(*field);
}

void LineSettingsForm::makeEncoder(QFormLayout &form)
{
    makeFractionBits(form);
    m_topSpeed = describe(new DecimalField(m_content), tr("Top speed"),
                          tr("A position that jumps further than this speed allows is marked suspect "
                             "and asked for again"));
    m_topSpeed->setRange(line_limits::topSpeed.least, line_limits::topSpeed.most);
    m_topSpeed->setDecimals(0);
    m_topSpeed->setSingleStep(100.0);
    m_topSpeed->setSuffix(tr(" rpm", "revolutions per minute"));
    form.addRow(tr("T&op speed"), m_topSpeed);
}

void LineSettingsForm::makeFractionBits(QFormLayout &form)
{
    m_fractionBits = describe(new IntegerField(m_content), tr("Fraction bits of the scaling factor"),
                              tr("29 fits the example of the manual; it can be determined from a device"));
    m_fractionBits->setRange(line_limits::fractionBits.least, line_limits::fractionBits.most);
    m_determine = new QPushButton(tr("Deter&mine"), m_content);
    m_determine->setAutoDefault(false);
    m_determine->setToolTip(
        tr("Reads scaling factor, steps per turn and measuring range of the chosen encoder of the line, or "
           "else of the first that answers, and keeps the format that fits. Nothing is written (Alt+M)"));
    m_determine->setEnabled(false); // before the line is open
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::unit);
    row->addWidget(m_fractionBits, 1);
    row->addWidget(m_determine);
    form.addRow(tr("Fraction bits of the scalin&g factor"), row);
    qobject_cast<QLabel *>(form.labelForField(row))->setBuddy(m_fractionBits);
    connect(m_determine, &QPushButton::clicked, this, &LineSettingsForm::fractionBitsWanted);
}

void LineSettingsForm::setCanDetermine(bool can)
{
    m_determine->setEnabled(can);
}

void LineSettingsForm::setFractionBits(int bits)
{
    m_fractionBits->setValue(bits);
}

void LineSettingsForm::setPorts(const std::vector<PortRow> &ports, const QString &trouble)
{
    m_port->setPorts(ports, trouble);
}

LineSettings LineSettingsForm::settings() const
{
    using std::chrono::milliseconds;
    LineSettings settings;
    settings.port = m_port->port();
    settings.timing = m_timing;
    settings.serial.baudRate = m_baudRate->currentText().toInt();
    settings.serial.dataBits = m_dataBits->currentData().toInt();
    settings.serial.parity = static_cast<SerialSettings::Parity>(m_parity->currentData().toInt());
    settings.serial.stopBits = m_stopBits->currentData().toInt();
    settings.serial.lowLatency = m_lowLatency->isChecked();
    if (settings.serial.baudRate > 0)
        settings.timing.character = settings.serial.timeOf(1);
    settings.timing.answerTimeOut = milliseconds(m_timeOut->value());
    settings.timing.retries = m_retries->value();
    settings.timing.quietAfterWrite = milliseconds(m_quiet->value());
    settings.pollInterval = milliseconds(m_pollInterval->value());
    settings.fractionBits = m_fractionBits->value();
    settings.topSpeed = m_topSpeed->value();
    return settings;
}

void LineSettingsForm::setPort(const QString &port)
{
    m_port->setPort(port);
}

void LineSettingsForm::setSettings(const LineSettings &settings)
{
    setPort(settings.port);
    m_baudRate->setEditText(QString::number(settings.serial.baudRate));
    choose(*m_dataBits, settings.serial.dataBits);
    choose(*m_parity, static_cast<int>(settings.serial.parity));
    choose(*m_stopBits, settings.serial.stopBits);
    m_lowLatency->setChecked(settings.serial.lowLatency);
    m_timing = settings.timing;
    m_pollInterval->setValue(wholeMilliseconds(settings.pollInterval));
    m_timeOut->setValue(wholeMilliseconds(settings.timing.answerTimeOut));
    m_retries->setValue(settings.timing.retries);
    m_quiet->setValue(wholeMilliseconds(settings.timing.quietAfterWrite));
    m_fractionBits->setValue(settings.fractionBits);
    m_topSpeed->setValue(settings.topSpeed);
}

void LineSettingsForm::setProblem(const QString &sentence)
{
    if (sentence.isEmpty())
        m_problem->withdraw();
    else
        m_problem->showMessage(Role::fault, sentence);
}

void LineSettingsForm::askForOtherAdapter(const QString &sentence)
{
    m_problem->showMessage(Role::attention, sentence, tr("Use this adapter"));
}

void LineSettingsForm::tellBaudRate(const QString &sentence, std::optional<int> wanted)
{
    m_rateWanted = wanted;
    if (sentence.isEmpty())
        m_rateTold->withdraw();
    else
        m_rateTold->showMessage(Role::attention, sentence,
                                wanted ? tr("Set the line to %1 Bd").arg(QLocale().toString(*wanted))
                                       : QString());
}

void LineSettingsForm::takeRate()
{
    if (!m_rateWanted)
        return;
    m_rateTold->withdraw();
    m_baudRate->setEditText(QString::number(*m_rateWanted));
    Q_EMIT baudRateWanted(*m_rateWanted);
}

bool LineSettingsForm::isComplete(const LineSettings &settings)
{
    if (settings.port.isEmpty())
        m_problem->showMessage(Role::attention, tr("Choose a serial port, or type the path of one."));
    else if (hasRate(settings)) {
        m_problem->withdraw();
        return true;
    }
    return false;
}

bool LineSettingsForm::hasRate(const LineSettings &settings)
{
    const bool has = line_limits::baudRate.hold(settings.serial.baudRate);
    if (!has)
        m_problem->showMessage(Role::attention, tr("The baud rate is a number from %1 to %2.")
                                                    .arg(line_limits::baudRate.least)
                                                    .arg(line_limits::baudRate.most));
    return has;
}

// Half-typed values are not yet the form's: they are taken first, or nothing is done.
bool LineSettingsForm::takeTyped()
{
    const QString wrong = takeFields(*m_content);
    if (!wrong.isEmpty())
        m_problem->showMessage(Role::attention, wrong);
    return wrong.isEmpty();
}

void LineSettingsForm::connectNow()
{
    if (!takeTyped())
        return;
    if (const LineSettings wanted = settings(); isComplete(wanted))
        Q_EMIT connectWanted(wanted, m_port->isPicked());
}

// A line may be planned before anybody knows its port.
void LineSettingsForm::keep()
{
    if (!takeTyped())
        return;
    if (const LineSettings wanted = settings(); hasRate(wanted)) {
        Q_EMIT keepWanted(wanted, m_port->isPicked());
        m_problem->showMessage(Role::running, tr("Port and settings are in the project."));
    }
}

void LineSettingsForm::connectOther()
{
    if (!takeTyped())
        return;
    if (const LineSettings wanted = settings(); isComplete(wanted))
        Q_EMIT otherAdapterWanted(wanted);
}

} // namespace codewheel
