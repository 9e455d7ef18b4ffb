// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/direction_page.h"

#include "catalog/device_description.h"
#include "catalog/protocol_rules.h"
#include "catalog/word_form.h"
#include "jobs/position_scale.h"
#include "vocabulary/hex.h"
#include "widgets/dial/state_note.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/role_label.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/models/age_text.h"
#include "widgets/models/age_timer.h"
#include "widgets/models/device_traits.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>

#include <array>
#include <utility>

namespace codewheel {
namespace {

// "unsigned-cw" and "unsigned-ccw", "increasing" and "decreasing"; empty if it gives no direction.
QString turnedRound(const QString &key)
{
    static const std::array<std::pair<QString, QString>, 2> pairs{
        {{QStringLiteral("ccw"), QStringLiteral("cw")},
         {QStringLiteral("increasing"), QStringLiteral("decreasing")}}};
    for (const auto &[one, other] : pairs) {
        if (key.endsWith(one))
            return key.chopped(one.size()) + other;
        if (key.endsWith(other))
            return key.chopped(other.size()) + one;
    }
    return {};
}

} // namespace

std::optional<ParameterValue> otherDirection(const EncoderSession &encoder)
{
    for (const Parameter parameter : {Parameter::direction, Parameter::coding}) {
        const ParameterDescription *description = encoder.device().find(parameter);
        const auto known = encoder.known(parameter);
        const Choice *now = description && known ? description->findChoice(known->value) : nullptr;
        if (now == nullptr)
            continue;
        const QString key = turnedRound(now->key);
        if (const Choice *other = description->findChoice(QStringView(key)))
            return ParameterValue{parameter, other->value};
    }
    return std::nullopt;
}

DirectionPage::DirectionPage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("Direction"), parent)
    , m_age(new AgeTimer(this))
    , m_what(wrappedLabel(this))
    , m_position(named(new QLabel(this), "directionPosition"))
    , m_verdict(named(new RoleLabel(this), "verdict"))
    , m_moved(new QLabel(this))
    , m_again(new QPushButton(lineIcon(Icon::refresh), tr("Check &again"), this))
    , m_asNow(new QRadioButton(tr("Count as it does no&w"), this))
    , m_otherWay(new QRadioButton(tr("Count the &other way round"), this))
    , m_problem(named(new InlineMessage(this), "directionProblem"))
{
    m_position->setFont(numberFont(TextSize::large));
    m_position->setAccessibleName(tr("Position"));
    describe(m_otherWay, "otherWay", tr("The other direction is added to the wanted values."));
    describe(m_again, "checkAgain", tr("Forget the movements seen so far."));
    m_asNow->setToolTip(tr("The direction of the encoder is kept."));
    auto *question = new QLabel(tr("When moved this way, the position should:"), this);

    auto *verdict = new QHBoxLayout;
    verdict->addWidget(m_verdict);
    verdict->addWidget(m_moved);
    verdict->addStretch();
    verdict->addWidget(m_again);
    auto *layout = new QVBoxLayout(this);
    layout->setSpacing(grid::margin);
    layout->addWidget(m_what);
    layout->addWidget(m_position);
    layout->addLayout(verdict);
    layout->addSpacing(grid::margin);
    layout->addWidget(question);
    layout->addWidget(m_asNow);
    layout->addWidget(m_otherWay);
    layout->addWidget(m_problem);
    layout->addStretch();

    setFocusProxy(m_asNow);
    connect(m_age, &QTimer::timeout, this, &DirectionPage::showLatest);
    connect(m_again, &QPushButton::clicked, this, &DirectionPage::begin);
    connect(m_asNow, &QRadioButton::clicked, this, &DirectionPage::choose);
    connect(m_otherWay, &QRadioButton::clicked, this, &DirectionPage::choose);
}

void DirectionPage::enter()
{
    m_what->setText(isRod(m_setup.encoder->device())
                        ? tr("Move the magnet a little, the way the machine moves forward. Nothing is sent.")
                        : tr("Turn the shaft a little, the way the machine moves forward. Nothing is sent."));
    const auto other = otherDirection(*m_setup.encoder);
    const bool wantsOther = other && valueOf(m_setup.wish.wanted, other->parameter) == other->value;
    m_asNow->setChecked(!wantsOther);
    m_otherWay->setChecked(wantsOther);
    m_otherWay->setEnabled(other.has_value());
    m_otherWay->setToolTip(
        other ? tr("The other direction is added to the wanted values.")
              : tr("The direction the encoder has now is not known: read it, or choose it on "
                   "the page of the values."));
    begin();
}

void DirectionPage::begin()
{
    const DeviceDescription &device = m_setup.encoder->device();
    const auto scale = scaleOf(device, [this](Parameter p) { return m_setup.valueNow(p); });
    m_usesRawWord = !m_setup.encoder->latest().position.has_value();
    m_check.begin(scale && !m_usesRawWord ? scale->total()
                                          : protocolRules(device.profile).largestTotalRange(device));
    showLatest();
}

// Old positions say nothing about the sense of rotation, and the next one may be anywhere.
void DirectionPage::showLatest()
{
    m_age->follow(*m_setup.encoder);
    const bool isOld = m_setup.encoder->freshness().isOld();
    m_position->setForegroundRole(isOld ? QPalette::PlaceholderText : QPalette::WindowText);
    if (std::exchange(m_wasOld, isOld) && !isOld)
        begin();
    else if (isOld)
        showOld();
    else
        showNow();
}

void DirectionPage::showOld()
{
    const auto &last = m_setup.encoder->latest().position;
    m_position->setText(last ? QLocale().toString(qlonglong{*last}) : QString(QChar(0x2013)));
    m_problem->showMessage(Role::attention, ageSentence(*m_setup.encoder));
    m_moved->clear();
    m_verdict->setState(Role::inactive, tr("Not up to date"));
}

void DirectionPage::showNow()
{
    const Reading &reading = m_setup.encoder->latest();
    if (m_usesRawWord && reading.position) { // what was missing has become known
        begin();
        return;
    }
    if (reading.state != EncoderState::operation && !m_setup.encoder->device().hasWords()) {
        m_position->setText(reading.position ? QLocale().toString(qlonglong{*reading.position})
                                             : QStringLiteral("\u2013"));
        m_problem->showMessage(Role::attention, noteOfState(m_setup.encoder->device(), reading).sentence);
    } else if (reading.state != EncoderState::operation) {
        m_position->setText(hexWord(reading.in));
        m_problem->showMessage(Role::attention,
                               reading.position
                                   ? noteOfState(m_setup.encoder->device(), reading).sentence
                                   : tr("The encoder shows no position now (IN %1). Bring it back to "
                                        "operation first.")
                                         .arg(hexWord(reading.in)));
    } else if (!reading.position) {
        m_usesRawWord = true;
        m_position->setText(hexWord(reading.in));
        m_problem->showMessage(Role::attention,
                               tr("The position is not known, since mode or coding of the encoder is not. "
                                  "The raw word is watched instead; trust it only for slow, small moves."));
        m_check.take(dataOf(m_setup.encoder->device(), reading.in));
    } else {
        m_problem->withdraw();
        m_position->setText(QLocale().toString(qlonglong{*reading.position}));
        m_check.take(*reading.position);
    }
    showVerdict();
}

void DirectionPage::showVerdict()
{
    m_moved->setText(m_check.moved() == 0
                         ? QString()
                         : tr("%1 steps so far").arg(QLocale().toString(qlonglong{m_check.moved()})));
    switch (m_check.verdict()) {
    case TurnCheck::Verdict::doesNotMove:
        m_verdict->setState(Role::inactive, tr("Does not move yet"));
        break;
    case TurnCheck::Verdict::countsUp:
        m_verdict->setState(Role::running, tr("Counts up"));
        break;
    case TurnCheck::Verdict::countsDown:
        m_verdict->setState(Role::running, tr("Counts down"));
        break;
    case TurnCheck::Verdict::goesBothWays:
        m_verdict->setState(Role::attention, tr("Goes both ways: move it one way only"));
        break;
    }
}

void DirectionPage::choose()
{
    const auto other = otherDirection(*m_setup.encoder);
    if (!other)
        return;
    if (m_otherWay->isChecked())
        m_setup.want(other->parameter, other->value);
    else
        m_setup.want(other->parameter, m_setup.valueNow(other->parameter));
}

} // namespace codewheel
