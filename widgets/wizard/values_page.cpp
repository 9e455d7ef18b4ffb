// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/values_page.h"

#include "catalog/value_text.h"
#include "encoder/refusal_text.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/parameters/value_field.h"
#include "widgets/wizard/gear_panel.h"
#include "widgets/wizard/known_text.h"
#include "widgets/wizard/scale_preview.h"
#include "widgets/wizard/wanted_scale.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>

namespace codewheel {
namespace {

constexpr std::int64_t largestTotalRange = 33'554'432; // 25 bit

QString number(std::int64_t value)
{
    return QLocale().toString(qlonglong{value});
}

} // namespace

ValuesPage::ValuesPage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("Values"), parent)
    , m_form(new QWidget(this))
    , m_initialise(new QCheckBox(tr("&Set the position to the preset now"), this))
    , m_scaleText(new QLabel(this))
    , m_badInput(new InlineMessage(this))
    , m_warning(new InlineMessage(this))
    , m_gear(new GearPanel(this))
    , m_preview(new ScalePreview(this))
{
    m_initialise->setObjectName(QStringLiteral("initialisePreset"));
    m_initialise->setToolTip(
        tr("After run, 40000000 makes the place where the shaft stands the preset value."));
    m_scaleText->setObjectName(QStringLiteral("scaleText"));
    m_scaleText->setWordWrap(true);
    m_badInput->setObjectName(QStringLiteral("badInput"));
    m_warning->setObjectName(QStringLiteral("scaleWarning"));

    auto *aids = new QHBoxLayout;
    aids->setSpacing(grid::margin);
    aids->addWidget(m_gear, 1, Qt::AlignTop);
    aids->addWidget(m_preview, 0, Qt::AlignTop);
    auto *layout = new QVBoxLayout(this);
    layout->setSpacing(grid::margin);
    layout->addWidget(m_form);
    layout->addWidget(m_initialise);
    layout->addWidget(m_badInput);
    layout->addWidget(m_scaleText);
    layout->addWidget(m_warning);
    layout->addLayout(aids);
    layout->addStretch();

    connect(m_initialise, &QCheckBox::clicked, this, [this](bool on) {
        m_setup.wish.initialisePreset = on;
        readFields();
    });
    connect(m_gear, &GearPanel::chosen, this, [this](qint64 steps, qint64 revolutions) {
        m_rows.at(Parameter::steps).field->setValue(steps);
        m_rows.at(Parameter::revolutions).field->setValue(revolutions);
        readFields();
    });
}

void ValuesPage::enter()
{
    if (m_rowsOf != m_setup.encoder->device().key)
        makeRows();
    for (const auto &[parameter, row] : m_rows)
        row.field->setValue(valueOf(m_setup.wish.wanted, parameter));
    m_initialise->setVisible(m_setup.encoder->can().presets);
    m_initialise->setChecked(m_setup.wish.initialisePreset);
    showKnown();
    readFields();
}

void ValuesPage::makeRows()
{
    m_rowsOf = m_setup.encoder->device().key;
    m_rows.clear();
    delete m_form->layout();
    qDeleteAll(m_form->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly));
    auto *form = new QGridLayout(m_form);
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(grid::unit);
    QWidget *before = nullptr;
    for (const ParameterDescription &parameter : m_setup.encoder->device().parameters) {
        if (!parameter.number)
            continue;
        auto *field = new ValueField(parameter, tr("as it is"), m_form);
        auto *name = new QLabel(parameterName(parameter.parameter), m_form);
        name->setBuddy(field->focusProxy());
        Row row{field, new QLabel(m_form)};
        const int at = form->rowCount();
        form->addWidget(name, at, 0);
        form->addWidget(field, at, 1);
        form->addWidget(new QLabel(unitText(parameter.unit), m_form), at, 2);
        form->addWidget(row.now, at, 3);
        m_rows[parameter.parameter] = row;
        connect(field, &ValueField::edited, this, [this, changed = parameter.parameter] {
            if (changed == Parameter::preset) { // who gives a preset wants it to hold
                const auto value = m_rows.at(Parameter::preset).field->value();
                m_setup.wish.initialisePreset = value && *value && m_setup.encoder->can().presets;
                m_initialise->setChecked(m_setup.wish.initialisePreset);
            }
            readFields();
        });
        field->show(); // at once, to take the focus
        if (before == nullptr)
            setFocusProxy(field);
        else
            setTabOrder(before, field->focusProxy());
        before = field->focusProxy();
    }
    setTabOrder(before, m_initialise);
    form->setColumnStretch(1, 1);
    form->setColumnStretch(3, 1);
}

void ValuesPage::showKnown()
{
    for (const auto &[parameter, row] : m_rows)
        row.now->setText(
            tr("now %1").arg(knownText(m_setup.encoder->device(), m_setup.encoder->known(parameter))));
    showConsequences();
}

void ValuesPage::showLatest()
{
    showConsequences();
}

void ValuesPage::readFields()
{
    m_inputIsGood = true;
    m_badInput->withdraw();
    for (const auto &[parameter, row] : m_rows) {
        const auto value = row.field->value();
        if (value)
            m_setup.want(parameter, *value);
        else if (std::exchange(m_inputIsGood, false))
            m_badInput->showMessage(Role::attention, refusalText(value.error()));
    }
    m_hasAny = !m_setup.wish.wanted.empty() || m_setup.wish.initialisePreset;
    GearLimits limits{.physicalStepsPerTurn = m_setup.encoder->device().physicalStepsPerTurn};
    if (const int turns = m_setup.encoder->device().physicalTurns)
        limits.turns = m_setup.valueAfter(Parameter::measuringRange).value_or(turns);
    m_gear->setLimits(limits);
    showConsequences();
    Q_EMIT changed();
}

void ValuesPage::showConsequences()
{
    const auto then = scaleAfter(m_setup);
    m_scaleText->setText(
        then ? scaleText(*then)
             : tr("Resolution and range can be told once steps, revolutions and direction are "
                  "known or wanted."));
    const QString warning = then ? warningFor(*then) : QString();
    if (warning.isEmpty())
        m_warning->withdraw();
    else if (warning != m_warning->sentence())
        m_warning->showMessage(Role::attention, warning);
    const auto start = positionAfterHandshake(m_setup);
    m_preview->setScale(
        then, start ? std::optional(start->position) : std::nullopt,
        tr("What it will read here cannot be told: the zero offset or the scale is not known."));
}

QString ValuesPage::scaleText(const PositionScale &scale) const
{
    return tr("Resolution %1 steps per turn, total range %2 steps over %3 turns.")
        .arg(QLocale().toString(scale.resolution(), 'f', scale.steps % scale.revolutions == 0 ? 0 : 3),
             number(scale.total()), number(scale.turns));
}

QString ValuesPage::warningFor(const PositionScale &scale) const
{
    const std::int64_t most = scale.physicalStepsPerTurn * scale.revolutions;
    if (most > 0 && scale.steps > most)
        return refusalText({RefusalKind::badInput,
                            RefusalId::tooManyStepsPerTurn,
                            {scale.steps, scale.revolutions, scale.physicalStepsPerTurn}});
    if (scale.total() > largestTotalRange)
        return refusalText(
            {RefusalKind::badInput, RefusalId::totalRangeTooLarge, {scale.total(), largestTotalRange}});
    for (const Parameter parameter : {Parameter::preset, Parameter::offset})
        if (const auto value = m_setup.valueAfter(parameter); value && *value >= scale.total())
            return refusalText({RefusalKind::badInput,
                                RefusalId::valueAboveTotalRange,
                                {parameter, *value, scale.total() - 1}});
    switch (wrapJump(scale)) {
    case WrapJump::none:
        return {};
    case WrapJump::rangeDoesNotDivideTurns:
        return tr("The position will jump: the measuring range of %1 turns does not divide the %2 turns of "
                  "the "
                  "encoder. Where those are used up, it goes from %3 to 0.")
            .arg(number(scale.turns), number(scale.physicalTurns), number(lastPositionBeforeWrap(scale)));
    case WrapJump::totalIsNotWhole:
        return tr("The position will jump a little: %1 steps in %2 revolutions give no whole number of steps "
                  "over "
                  "%3 turns. A fraction of a step is lost each time they are used up.")
            .arg(number(scale.steps), number(scale.revolutions), number(scale.turns));
    }
    return {};
}

} // namespace codewheel
