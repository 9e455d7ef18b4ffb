// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/values_page.h"

#include "catalog/device_description.h"
#include "catalog/value_text.h"
#include "vocabulary/known_words.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/parameters/position_to_set.h"
#include "widgets/parameters/value_field.h"
#include "widgets/wizard/consequences.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace codewheel {
namespace {

constexpr int widestField = 240; // px: a number far from its name is hard to find

// Without its unit, which is beside the field.
QString nowText(const DeviceDescription &device, Parameter parameter, const std::optional<Known> &known)
{
    return known ? QStringLiteral("%1 (%2)").arg(valueText(*device.find(parameter), known->value),
                                                 known_words::word(known))
                 : known_words::word(known);
}

} // namespace

ValuesPage::ValuesPage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("Values"), parent)
    , m_form(new QWidget(this))
    , m_initialise(named(new QCheckBox(tr("&Set the position to the preset now"), this), "initialisePreset"))
    , m_setting(new QHBoxLayout)
    , m_badInput(named(new InlineMessage(this), "badInput"))
    , m_layout(new QVBoxLayout(this))
{
    m_initialise->hide(); // until it is known how this encoder sets its position

    m_setting->addWidget(m_initialise);
    m_setting->addStretch();
    m_layout->setSpacing(grid::margin);
    m_layout->addWidget(m_form);
    m_layout->addLayout(m_setting);
    m_layout->addWidget(m_badInput);

    connect(&m_setup.wanted, &WantedValues::changed, this, &ValuesPage::showWanted);
    connect(m_initialise, &QCheckBox::clicked, this, [this](bool on) {
        const bool needsValue = m_setup.encoder->can().presetNeedsValue;
        m_setup.wish.initialisePreset = on && !needsValue;
        m_setup.hasChosenPosition = true;
        takeFields();
        if (on && needsValue)
            m_position->setFocus();
    });
}

void ValuesPage::enter()
{
    if (m_rowsOf != m_setup.encoder->device().key)
        makeRows();
    for (const auto &[parameter, row] : m_rows)
        row.field->setValue(findValue(m_setup.wish.wanted, parameter));
    showSetting();
    showKnown();
    takeFields();
}

void ValuesPage::leave()
{
    for (const auto &[parameter, row] : m_rows)
        row.field->takeTyped();
    if (m_position != nullptr)
        m_position->takeTyped();
    takeFields();
}

// Either the programmed preset, or a position given with the command.
void ValuesPage::showSetting()
{
    const Capabilities &can = m_setup.encoder->can();
    m_initialise->setVisible(can.presets);
    m_initialise->setText(can.presetNeedsValue ? tr("&Set the position now to")
                                               : tr("&Set the position to the preset now"));
    m_initialise->setToolTip(
        can.presetNeedsValue
            ? !m_setup.encoder->device().hasWords()
                  ? tr("After the values, GP makes the place where the shaft stands this position.")
                  : tr("After the values, service 6 makes the place where the magnet stands this position.")
            : tr("After run, 40000000 makes the place where the shaft stands the preset value."));
    m_initialise->setChecked(m_setup.wish.initialisePreset || m_setup.wish.setPositionTo);
    makePositionField();
    m_position->setVisible(can.presetNeedsValue);
    m_position->setValue(m_setup.wish.setPositionTo);
}

// Its range is that of the encoder, and follows what becomes known of it.
void ValuesPage::makePositionField()
{
    delete m_position;
    m_position = new ValueField(positionToSet(*m_setup.encoder), tr("position"), this);
    describe(m_position->focusProxy(), "positionToSet", tr("Position to set now"),
             positionToSetText(*m_setup.encoder));
    m_setting->insertWidget(1, m_position);
    connect(m_position, &ValueField::typed, this, &ValuesPage::checkFields);
    connect(m_position, &ValueField::edited, this, &ValuesPage::takeFields);
    setTabOrder(m_initialise, m_position->focusProxy());
}

void ValuesPage::makeRows()
{
    m_rowsOf = m_setup.encoder->device().key;
    delete m_consequences;
    m_consequences = Consequences::make(m_setup, this);
    m_layout->insertWidget(m_layout->indexOf(m_badInput) + 1, m_consequences, 1);
    m_consequences->show(); // at once, like the fields
    connect(m_consequences, &Consequences::chosen, this, [this](const ParameterValues &values) {
        for (const ParameterValue &value : values)
            m_rows.at(value.parameter).field->setValue(value.value);
        takeFields();
    });
    m_rows.clear();
    delete m_form->layout();
    qDeleteAll(m_form->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly));
    auto *form = new QGridLayout(m_form);
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(grid::unit);
    QWidget *before = nullptr;
    for (const ParameterDescription &parameter : m_setup.encoder->device().parameters) {
        if (!parameter.canBeWritten)
            continue;
        auto *field = new ValueField(parameter, tr("unchanged"), m_form);
        field->setMaximumWidth(widestField);
        auto *name = new QLabel(parameterName(parameter), m_form);
        name->setBuddy(field->focusProxy());
        Row row{field, wrappedLabel(m_form)};
        const int at = form->rowCount();
        form->addWidget(name, at, 0);
        const QString unit = unitText(parameter.unit);
        form->addWidget(field, at, 1, 1, unit.isEmpty() ? 2 : 1); // a choice has no unit, and long texts
        if (!unit.isEmpty())
            form->addWidget(new QLabel(unit, m_form), at, 2);
        form->addWidget(row.now, at, 3);
        m_rows[parameter.parameter] = row;
        if (parameter.parameter == Parameter::preset)
            connect(field, &ValueField::typed, this, &ValuesPage::followPreset);
        connect(field, &ValueField::typed, this, &ValuesPage::checkFields);
        connect(field, &ValueField::edited, this, &ValuesPage::takeFields);
        field->show(); // at once, to take the focus
        if (before == nullptr)
            setFocusProxy(field);
        else
            setTabOrder(before, field->focusProxy());
        before = field->focusProxy();
    }
    setTabOrder(before, m_initialise);
    form->setColumnStretch(1, 2);
    form->setColumnStretch(3, 3);
}

// Entering a preset means wanting it in effect, unless the user has said.
void ValuesPage::followPreset()
{
    if (!m_setup.encoder || m_setup.hasChosenPosition)
        return;
    const auto value = m_rows.at(Parameter::preset).field->value();
    m_setup.wish.initialisePreset = value && *value && m_setup.encoder->can().presets;
    m_initialise->setChecked(m_setup.wish.initialisePreset);
}

void ValuesPage::showKnown()
{
    for (const auto &[parameter, row] : m_rows)
        row.now->setText(tr("now %1").arg(
            nowText(m_setup.encoder->device(), parameter, m_setup.encoder->known(parameter))));
    m_consequences->refresh();
}

// They were changed elsewhere, or a change was undone.
void ValuesPage::showWanted()
{
    if (!m_setup.encoder || m_rowsOf != m_setup.encoder->device().key)
        return;
    const ParameterValues wanted = m_setup.wanted.values(m_setup.encoder->place());
    for (const auto &[parameter, row] : m_rows) {
        const auto shown = row.field->value();
        if (!row.field->isBeingTyped() && shown && *shown != findValue(wanted, parameter))
            row.field->setValue(findValue(wanted, parameter));
    }
    checkFields();
}

void ValuesPage::showLatest()
{
    m_consequences->refresh();
}

// Checks the fields, also while typing. Nothing of it is wanted yet.
void ValuesPage::checkFields()
{
    m_inputIsGood = true;
    m_badInput->withdraw();
    bool hasValue = false;
    for (const auto &[parameter, row] : m_rows) {
        const auto value = row.field->value();
        hasValue = hasValue || (value && *value);
        if (!value && std::exchange(m_inputIsGood, false))
            m_badInput->showMessage(Role::attention, refusalText(value.error()));
    }
    readPosition();
    m_hasAny = hasValue || m_setup.wish.initialisePreset || m_setup.wish.setPositionTo;
    Q_EMIT changed();
}

void ValuesPage::takeFields()
{
    if (!m_setup.encoder) // gone, while a field was being typed in
        return;
    Setup::Wishes wishes;
    for (const auto &[parameter, row] : m_rows)
        if (const auto value = row.field->value())
            wishes[parameter] = *value;
    m_setup.want(wishes);
    checkFields();
    m_consequences->refresh();
}

void ValuesPage::readPosition()
{
    m_setup.wish.setPositionTo.reset();
    const bool isAsked = m_setup.encoder->can().presetNeedsValue && m_initialise->isChecked();
    m_position->setEnabled(isAsked);
    if (!isAsked)
        return;
    const auto position = m_position->value();
    if (position && *position) {
        m_setup.wish.setPositionTo = (*position)->number();
        return;
    }
    if (std::exchange(m_inputIsGood, false))
        m_badInput->showMessage(Role::attention, position
                                                     ? refusalText({RefusalKind::badInput,
                                                                    RefusalId::presetNeedsValue,
                                                                    {m_setup.encoder->device().fullName()}})
                                                     : refusalText(position.error()));
}

} // namespace codewheel
