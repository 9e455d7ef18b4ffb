// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/shaft_dial.h"

#include "catalog/device_description.h"
#include "catalog/position_format.h"
#include "drivers/position_scale.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/missing_values.h"
#include "widgets/dial/printed_dial.h"
#include "widgets/dial/state_note.h"
#include "widgets/models/age_text.h"
#include "widgets/models/age_timer.h"
#include "widgets/monitor/position_range.h"

#include <QVBoxLayout>

#include <array>
#include <cmath>

namespace codewheel {
namespace {

constexpr std::array shaftValues{Parameter::steps, Parameter::revolutions, Parameter::direction,
                                 Parameter::coding};

bool countsClockwise(const EncoderSession &encoder)
{
    for (const Parameter parameter : {Parameter::direction, Parameter::coding}) {
        if (const auto known = encoder.known(parameter))
            return countsClockwise(encoder.device(), {parameter, known->value});
    }
    return true;
}

// Its position and speed now are not known any more.
void makeOld(DialState &state, const EncoderSession &encoder)
{
    const StateNote note = noteOfAge(encoder);
    state.isLastKnown = true;
    state.age = ageText(encoder);
    state.velocity.reset();
    state.rpm.reset();
    state.note = note.sentence;
    state.role = note.role;
}

void makeRecorded(DialState &state, const EncoderSession &encoder)
{
    const StateNote note = noteOfRecording(encoder, {state.note, state.role});
    state.isLastKnown = true;
    state.age = ageText(encoder);
    state.note = note.sentence;
    state.role = note.role;
}

} // namespace

ShaftDial::ShaftDial(QWidget *parent)
    : QWidget(parent)
    , m_age(new AgeTimer(this))
    , m_disc(new CodeDisc(this))
    , m_missing(new MissingValues({shaftValues.begin(), shaftValues.end()}, this))
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_disc, 1);
    column->addWidget(m_missing);
    connect(m_missing, &MissingValues::changed, this, &ShaftDial::knownChanged);
    connect(m_age, &QTimer::timeout, this, &ShaftDial::draw);
}

void ShaftDial::setEncoder(EncoderSession *encoder)
{
    if (m_encoder != nullptr)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    if (encoder != nullptr) {
        m_disc->setPlace(encoder->place().shown());
        connect(encoder, &EncoderSession::latestChanged, this, &ShaftDial::draw);
        connect(encoder, &EncoderSession::freshnessChanged, this, &ShaftDial::draw);
    }
    m_missing->setEncoder(encoder);
}

std::optional<PrintedView> ShaftDial::printedView() const
{
    if (m_encoder == nullptr)
        return {};
    DialState state = m_disc->state();
    state.note.clear(); // stands among the values
    CodeDisc onPaper;
    onPaper.setForPaper();
    onPaper.setState(state);
    return printedDial(*m_encoder, drawnOnPaper(onPaper, onPaper.sizeHint()), m_disc->values(), shaftValues);
}

void ShaftDial::knownChanged()
{
    m_scale = scale();
    draw();
}

std::optional<ShaftDial::Scale> ShaftDial::scale() const
{
    if (onlyTellsPosition(m_encoder->device().profile))
        return physicalScale();
    const auto steps = m_encoder->known(Parameter::steps);
    const auto revolutions = m_encoder->known(Parameter::revolutions);
    if (!m_missing->isEmpty() || !steps || !revolutions)
        return std::nullopt;
    // An encoder on a serial line gives its steps per turn.
    const std::int64_t turns = !m_encoder->device().hasWords() ? 1 : revolutions->value;
    return Scale{.stepsPerTurn = static_cast<double>(steps->value) / static_cast<double>(turns),
                 .clockwise = countsClockwise(*m_encoder)};
}

// The position of a K1 or K2 is the place on its code disc.
std::optional<ShaftDial::Scale> ShaftDial::physicalScale() const
{
    const DeviceDescription &device = m_encoder->device();
    if (!positionRange(*m_encoder))
        return std::nullopt;
    return Scale{.stepsPerTurn = static_cast<double>(device.physicalStepsPerTurn),
                 .countsTurns = device.physicalTurns > 1};
}

void ShaftDial::draw()
{
    if (m_encoder == nullptr)
        return;
    m_age->follow(*m_encoder);
    DialState state = stateOf(m_encoder->latest());
    if (m_encoder->freshness().isOfRecording())
        makeRecorded(state, *m_encoder);
    else if (m_encoder->freshness().isOld())
        makeOld(state, *m_encoder);
    m_disc->setState(state);
}

// A serial encoder that is silent, or whose line was lost, shows its last position.
DialState ShaftDial::stateOf(const Reading &reading) const
{
    const bool wasSeen = reading.state == EncoderState::notSeen && reading.position;
    if (reading.state == EncoderState::operation || reading.state == EncoderState::silent || wasSeen)
        return running(reading);
    const StateNote note = noteOfState(m_encoder->device(), reading);
    return {.note = note.sentence, .role = note.role};
}

DialState ShaftDial::running(const Reading &reading) const
{
    if (reading.velocity)
        return turning(*reading.velocity);
    if (!reading.position)
        return {.note = whyNoPosition(*m_encoder), .role = Role::attention};
    DialState state{.position = *reading.position,
                    .note = note(reading),
                    .role = m_missing->isEmpty() ? Role::running : Role::attention};
    if (!m_scale)
        return state;
    const double turns = static_cast<double>(*reading.position) / m_scale->stepsPerTurn;
    state.turnFraction = partOfTurn(turns, m_scale->clockwise);
    if (m_scale->countsTurns)
        state.turn = static_cast<qint64>(std::floor(turns));
    if (reading.stepsPerSecond)
        state.rpm = *reading.stepsPerSecond / m_scale->stepsPerTurn * 60 * (m_scale->clockwise ? 1 : -1);
    return state;
}

// The sense of rotation follows from the counting direction.
DialState ShaftDial::turning(std::int64_t velocity) const
{
    DialState state{.velocity = velocity, .note = whyNoPosition(*m_encoder), .role = Role::running};
    if (m_encoder->known(Parameter::direction))
        state.rpm = static_cast<double>(countsClockwise(*m_encoder) ? velocity : -velocity);
    return state;
}

// What is missing, or that the position is not plain binary.
QString ShaftDial::note(const Reading &reading) const
{
    if (!m_missing->isEmpty())
        return tr("Not known: %1. The disc needs it to turn.").arg(m_missing->names());
    if (!m_scale && onlyTellsPosition(m_encoder->device().profile))
        return tr("The steps per turn of this encoder are not described: the disc cannot turn.");
    if (reading.coding == PositionCoding::gray)
        return tr("The position comes in Gray code.");
    if (reading.coding == PositionCoding::signedBinary)
        return tr("The position is signed.");
    if (m_scale && reading.mayMissTurns)
        return tr("No speed: positions come so seldom that the shaft may make a whole turn between two.");
    return {};
}

} // namespace codewheel
