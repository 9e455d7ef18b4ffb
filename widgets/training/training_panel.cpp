// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/training_panel.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/training/hand_wheel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>

namespace codewheel {

namespace {

// A turn by hand is told of once, when the shaft was left alone for half a second.
constexpr int picturesOfRest = 15;
constexpr int usualHeight = 260; // the rest is scrolled to

QLabel *numberLabel(const QString &name, QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setFont(numberFont());
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setAccessibleName(name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

void setNumber(QLabel *label, qint64 number)
{
    label->setText(QLocale().toString(number));
}

QPushButton *command(Icon icon, const QString &text, const QString &toolTip, QWidget *parent)
{
    auto *button = new QPushButton(lineIcon(icon), text, parent);
    button->setAutoDefault(false);
    button->setToolTip(toolTip);
    button->setAccessibleDescription(toolTip);
    return button;
}

// Beside a field.
QToolButton *fieldButton(Icon icon, const QString &name, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setIcon(lineIcon(icon));
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolTip(name);
    button->setAccessibleName(name);
    return button;
}

// As narrow as the dock wants, showing what is there room for.
void prepareField(QAbstractSpinBox *field, int digits)
{
    field->setFont(numberFont());
    field->setAlignment(Qt::AlignRight);
    field->setKeyboardTracking(false);
    field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    field->setMinimumWidth(QFontMetrics(numberFont()).averageCharWidth() * digits + 2 * grid::margin);
}

void captionOf(QGridLayout *grid, int row, const QString &text, QWidget *field)
{
    auto *caption = new QLabel(text, field->parentWidget());
    caption->setBuddy(field);
    grid->addWidget(caption, row, 0);
}

} // namespace

TrainingPanel::TrainingPanel(TrainingControls &controls, QWidget *parent)
    : QScrollArea(parent)
    , m_controls(controls)
    , m_content(new QWidget(this))
    , m_device(new QComboBox(m_content))
    , m_wheel(new HandWheel(m_content))
    , m_raw(numberLabel(tr("Raw position"), m_content))
    , m_turn(numberLabel(tr("Turn"), m_content))
    , m_writes(numberLabel(tr("EEPROM writes"), m_content))
    , m_target(new QSpinBox(m_content))
    , m_speed(new QDoubleSpinBox(m_content))
{
    setAccessibleName(tr("Training"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    auto *column = new QVBoxLayout(m_content);
    column->setContentsMargins(grid::unit, grid::unit, grid::unit, grid::unit);
    column->setSpacing(grid::unit);
    makeShaft(column);
    makeTroubles(column);
    column->addStretch(1);
    setWidget(m_content);

    listDevices(m_controls.shafts());
    connect(m_device, &QComboBox::currentIndexChanged, this, &TrainingPanel::choose);
    choose();
}

void TrainingPanel::makeShaft(QVBoxLayout *column)
{
    m_device->setAccessibleName(tr("Encoder to train with"));
    m_device->setToolTip(tr("The simulated encoder that is turned, switched and disturbed here"));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(grid::groupGap);
    grid->setVerticalSpacing(grid::unit);
    grid->setColumnStretch(1, 1);
    captionOf(grid, 0, tr("Encoder"), m_device);
    grid->addWidget(m_device, 0, 1, 1, 2);
    column->addLayout(grid);

    connect(m_wheel, &HandWheel::turned, this, &TrainingPanel::turnBy);
    column->addWidget(m_wheel);

    auto *numbers = new QGridLayout;
    numbers->setVerticalSpacing(grid::unit / 2);
    numbers->setColumnStretch(1, 1);
    captionOf(numbers, 0, tr("Raw position"), m_raw);
    numbers->addWidget(m_raw, 0, 1);
    captionOf(numbers, 1, tr("Turn"), m_turn);
    numbers->addWidget(m_turn, 1, 1);
    captionOf(numbers, 2, tr("EEPROM writes"), m_writes);
    numbers->addWidget(m_writes, 2, 1);
    column->addLayout(numbers);

    auto *fields = new QGridLayout;
    fields->setHorizontalSpacing(grid::unit);
    fields->setVerticalSpacing(grid::unit);
    fields->setColumnStretch(1, 1);
    makePosition(fields);
    makeSpeed(fields);
    column->addLayout(fields);
}

void TrainingPanel::makePosition(QGridLayout *grid)
{
    prepareField(m_target, 8);
    m_target->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_target->setAccessibleName(tr("Raw position to turn to"));
    m_target->setToolTip(tr("Raw position, in the encoder's own steps; Enter turns the shaft to it"));
    auto *go = fieldButton(Icon::shaft, tr("Turn to the raw position"), m_content);
    captionOf(grid, 0, tr("Turn to"), m_target);
    grid->addWidget(m_target, 0, 1);
    grid->addWidget(go, 0, 2);
    connect(go, &QToolButton::clicked, this, &TrainingPanel::turnTo);
    connect(m_target->findChild<QLineEdit *>(), &QLineEdit::returnPressed, this, &TrainingPanel::turnTo);
}

void TrainingPanel::makeSpeed(QGridLayout *grid)
{
    m_speed->setRange(-TrainingControls::fastest, TrainingControls::fastest);
    m_speed->setDecimals(1);
    m_speed->setSingleStep(10);
    prepareField(m_speed, 8);
    m_speed->setAccessibleName(tr("Speed in revolutions per minute"));
    m_speed->setToolTip(tr("Revolutions per minute; positive is clockwise, looking at the shaft"));
    auto *stop = fieldButton(Icon::stop, tr("Stop the shaft"), m_content);
    captionOf(grid, 1, tr("Speed, rpm"), m_speed);
    grid->addWidget(m_speed, 1, 1);
    grid->addWidget(stop, 1, 2);
    connect(m_speed, &QDoubleSpinBox::valueChanged, this, &TrainingPanel::setSpeed);
    connect(stop, &QToolButton::clicked, this, [this] { m_speed->setValue(0); });
}

QCheckBox *TrainingPanel::addBox(QVBoxLayout *column, const QString &text, const QString &toolTip)
{
    auto *box = new QCheckBox(text, m_content);
    box->setToolTip(toolTip);
    box->setAccessibleDescription(toolTip);
    column->addWidget(box);
    return box;
}

void TrainingPanel::makeTroubles(QVBoxLayout *column)
{
    m_power = addBox(column, tr("Power on"), tr("Supply of the encoder. It forgets what was not activated."));
    connect(m_power, &QCheckBox::clicked, this, &TrainingPanel::setPower);
    m_slow = addBox(column, tr("Slow confirmation"),
                    tr("The encoder takes 50 times as long to confirm a parameter"));
    connect(m_slow, &QCheckBox::clicked, this, [this](bool slow) {
        m_controls.setSlow(m_shown->number, slow);
        act(slow ? tr("Slow confirmation on.") : tr("Slow confirmation off."));
    });
    m_battery = addBox(column, tr("Battery low"), tr("The encoder tests its battery when it is switched on"));
    connect(m_battery, &QCheckBox::clicked, this, [this](bool low) {
        m_controls.setBatteryLow(m_shown->number, low);
        act(low ? tr("Battery low; the encoder finds it when it is switched on.")
                : tr("Battery full; the encoder finds it when it is switched on."));
    });
    auto *cycle = command(Icon::power, tr("Power off and on"),
                          tr("Switch the encoder off and on again after 50 ms"), m_content);
    column->addWidget(cycle);
    connect(cycle, &QPushButton::clicked, this, [this] {
        m_controls.powerCycle(m_shown->number);
        act(tr("Power off and on."));
    });
    auto *lose =
        command(Icon::fault, tr("Lose parameters"),
                tr("The EEPROM content is destroyed: error 3, until it is parameterized again"), m_content);
    column->addWidget(lose);
    connect(lose, &QPushButton::clicked, this, [this] {
        m_controls.loseParameters(m_shown->number);
        act(tr("Parameters lost."));
    });
}

void TrainingPanel::listDevices(const std::vector<Shaft> &shafts)
{
    for (const Shaft &shaft : shafts)
        m_device->addItem(shaft.number.toString());
    m_content->setEnabled(!shafts.empty());
}

void TrainingPanel::setDevice(DeviceNumber number)
{
    const int index = m_device->findText(number.toString());
    if (index >= 0)
        m_device->setCurrentIndex(index);
}

void TrainingPanel::choose()
{
    if (m_picturesToRest > 0)
        tellOfTurning();
    m_shown.reset();
    refresh();
}

void TrainingPanel::refresh()
{
    const std::vector<Shaft> shafts = m_controls.shafts();
    const int chosen = m_device->currentIndex();
    if (chosen < 0 || chosen >= static_cast<int>(shafts.size()))
        return;
    showShaft(shafts.at(static_cast<std::size_t>(chosen)));
    if (m_picturesToRest > 0 && --m_picturesToRest == 0)
        tellOfTurning();
}

// A field is changed only when the encoder changed: what the user has just typed or ticked is not undone
// before the bus has come round.
void TrainingPanel::showShaft(const Shaft &shaft)
{
    const bool isNew = !m_shown;
    const Shaft before = std::exchange(m_shown, shaft).value_or(Shaft{});
    if (isNew) {
        const std::int64_t last = std::int64_t{shaft.stepsPerTurn} * shaft.turns - 1;
        m_target->setRange(0,
                           static_cast<int>(std::min<std::int64_t>(last, std::numeric_limits<int>::max())));
        m_target->setValue(static_cast<int>(shaft.raw));
        m_wheel->setStepsPerTurn(shaft.stepsPerTurn);
        m_battery->setVisible(shaft.hasBattery);
    }
    if (isNew || shaft.raw != before.raw)
        showPosition(shaft);
    if (isNew || shaft.eepromWrites != before.eepromWrites)
        setNumber(m_writes, shaft.eepromWrites);
    if (isNew || shaft.revolutionsPerMinute != before.revolutionsPerMinute) {
        const QSignalBlocker silent(m_speed);
        m_speed->setValue(shaft.revolutionsPerMinute);
    }
    if (isNew || shaft.powered != before.powered)
        m_power->setChecked(shaft.powered);
    if (isNew || shaft.slow != before.slow)
        m_slow->setChecked(shaft.slow);
    if (isNew || shaft.batteryLow != before.batteryLow)
        m_battery->setChecked(shaft.batteryLow);
}

void TrainingPanel::showPosition(const Shaft &shaft)
{
    setNumber(m_raw, shaft.raw);
    setNumber(m_turn, shaft.raw / shaft.stepsPerTurn);
    m_wheel->showRaw(shaft.raw);
}

void TrainingPanel::turnBy(qint64 steps)
{
    m_controls.turnBy(m_shown->number, steps);
    m_picturesToRest = picturesOfRest;
}

void TrainingPanel::turnTo()
{
    m_target->interpretText();
    m_controls.turnTo(m_shown->number, m_target->value());
    m_picturesToRest = 0;
    act(tr("Shaft turned to raw position %1.").arg(QLocale().toString(m_target->value())));
}

void TrainingPanel::setSpeed(double rpm)
{
    m_controls.setSpeed(m_shown->number, rpm);
    act(rpm == 0 ? tr("Shaft stopped.")
                 : tr("Shaft turns at %1 rpm.").arg(QLocale().toString(rpm, 'f', m_speed->decimals())));
}

void TrainingPanel::setPower(bool on)
{
    m_controls.setPower(m_shown->number, on);
    act(on ? tr("Power on.") : tr("Power off."));
}

void TrainingPanel::tellOfTurning()
{
    m_picturesToRest = 0;
    act(tr("Shaft turned by hand to raw position %1.").arg(QLocale().toString(qint64{m_shown->raw})));
}

void TrainingPanel::act(const QString &what)
{
    Q_EMIT acted(m_shown->number, what);
}

QSize TrainingPanel::sizeHint() const
{
    const QSize content = m_content->sizeHint();
    return {content.width() + verticalScrollBar()->sizeHint().width(),
            std::min(content.height(), usualHeight)};
}

} // namespace codewheel
