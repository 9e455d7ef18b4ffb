// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/now_and_then.h"

#include "catalog/device_description.h"
#include "catalog/protocol_rules.h"
#include "jobs/preset_position.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/missing_values.h"
#include "widgets/dial/rod_reading.h"
#include "widgets/dial/rod_view.h"
#include "widgets/look/layouts.h"
#include "widgets/models/age_timer.h"

namespace codewheel {
namespace {

bool hasRod(const EncoderSession &encoder)
{
    return isRod(encoder.device());
}

// Why the future is not known comes first: what the dial says of now stands in its panel, too.
template <class State>
void tellWhyNot(State &state, const QString &whyNot)
{
    if (whyNot.isEmpty())
        return;
    state.note = state.note.isEmpty() ? whyNot : whyNot + u' ' + state.note;
    if (state.role == Role::running)
        state.role = Role::attention;
}

} // namespace

NowAndThen::NowAndThen(QWidget *parent)
    : QWidget(parent)
    , m_age(new AgeTimer(this))
    , m_disc(new CodeDisc(this))
    , m_rod(new RodView(this))
{
    m_rod->hide();
    layOutColumn(this, {{m_disc, 1}, {m_rod, 1}}, {.margins = QMargins()});
    connect(m_age, &QTimer::timeout, this, &NowAndThen::draw);
}

void NowAndThen::setEncoder(EncoderSession &encoder)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = &encoder;
    m_disc->setVisible(!hasRod(encoder));
    m_rod->setVisible(hasRod(encoder));
    m_disc->setPlace(encoder.place().shown());
    m_rod->setPlace(encoder.place().shown());
    connect(&encoder, &EncoderSession::latestChanged, this, &NowAndThen::draw);
    connect(&encoder, &EncoderSession::freshnessChanged, this, &NowAndThen::draw);
    connect(&encoder, &EncoderSession::knownChanged, this, &NowAndThen::knownChanged);
    knownChanged();
}

void NowAndThen::setThen(std::optional<std::int64_t> position, const QString &whyNot,
                         const ValueOf &valueThen)
{
    m_then = position;
    m_whyNot = position ? QString() : whyNot;
    m_valueThen = valueThen;
    draw();
}

void NowAndThen::setThenByPreset(const ValueOf &valueThen)
{
    if (!m_encoder)
        return;
    const DeviceDescription &device = m_encoder->device();
    std::vector<Parameter> unknown;
    for (const Parameter parameter : {Parameter::preset, Parameter::offset, Parameter::coding})
        if (device.find(parameter) != nullptr && !valueThen(parameter))
            unknown.push_back(parameter);
    const auto then = presetPosition(device, valueThen, m_encoder->latest().coding);
    setThen(then ? std::optional(then->position) : std::nullopt,
            unknown.empty() ? tr("What it will show then is not known.")
                            : tr("What it will show then is not known. Missing: %1.").arg(namesOf(unknown)),
            valueThen);
}

void NowAndThen::knownChanged()
{
    if (hasRod(*m_encoder)) {
        m_known = knownOfRod(*m_encoder);
        m_missing = namesOf(missingOf(*m_encoder, rodValues));
    } else {
        m_scale = shaftScale(*m_encoder);
        m_missing = namesOf(missingOf(*m_encoder, shaftValues));
    }
    draw();
}

void NowAndThen::draw()
{
    if (!m_encoder)
        return;
    m_age->follow(*m_encoder);
    if (hasRod(*m_encoder))
        drawRod();
    else
        drawShaft();
}

void NowAndThen::drawRod()
{
    RodState state = rodReading(*m_encoder, m_known, m_missing);
    state.then = rodThen();
    tellWhyNot(state, m_whyNot);
    m_rod->setState(state);
}

RodState::Then NowAndThen::rodThen() const
{
    const RodState rod = m_valueThen ? rodWith(m_encoder->device(), m_valueThen) : m_known;
    return {m_then, rod.length, rod.scale, rod.countsUpToTheEnd};
}

std::optional<ShaftScale> NowAndThen::shaftThen() const
{
    if (!m_valueThen)
        return m_scale;
    const auto then = scaleOf(m_encoder->device(), m_valueThen);
    return then ? std::optional(ShaftScale{then->resolution(), then->clockwise}) : std::nullopt;
}

void NowAndThen::drawShaft()
{
    DialState state = shaftState(*m_encoder, m_scale, m_missing);
    const auto scale = shaftThen();
    state.then =
        DialState::Then{m_then, m_then && scale ? std::optional(scale->turnFraction(*m_then)) : std::nullopt};
    tellWhyNot(state, m_whyNot);
    m_disc->setState(state);
}

} // namespace codewheel
