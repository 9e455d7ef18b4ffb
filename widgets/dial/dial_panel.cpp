// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/dial_panel.h"

#include "catalog/device_description.h"
#include "encoder/hex.h"
#include "encoder/refusal_text.h"
#include "widgets/dial/code_disc.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/monitor/position_range.h"

#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

// Codings of the profile with an even number count counter-clockwise (Baumer manual 5); direction 4 is CCW
// (FRABA 5.3).
bool countsClockwise(const EncoderSession &encoder)
{
    for (const Parameter parameter : {Parameter::direction, Parameter::coding})
        if (const auto known = encoder.known(parameter))
            return known->value % 2 != 0;
    return true;
}

double partOfTurn(double turns, bool clockwise)
{
    const double part = turns - std::floor(turns);
    return clockwise || part == 0 ? part : 1 - part;
}

} // namespace

DialPanel::DialPanel(QWidget *parent)
    : QWidget(parent)
    , m_pages(new QStackedWidget(this))
    , m_disc(new CodeDisc(this))
    , m_read(new QPushButton(lineIcon(Icon::read), tr("&Read what is missing"), this))
    , m_message(new InlineMessage(this))
{
    auto *dial = new QWidget(this);
    auto *column = new QVBoxLayout(dial);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_disc, 1);
    column->addWidget(m_read, 0, Qt::AlignHCenter);
    m_pages->addWidget(new EmptyState(Icon::encoder, tr("No encoder is chosen."),
                                      tr("Choose one in the bus structure."), this));
    m_pages->addWidget(dial);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(grid::margin, grid::margin, grid::margin, grid::margin);
    layout->addWidget(m_message);
    layout->addWidget(m_pages, 1);

    m_read->setToolTip(
        tr("Reads what the dial needs from the encoder. That sends words, and takes the position away for "
           "some cycles."));
    m_read->setAccessibleName(tr("Read what the dial needs"));
    m_read->setObjectName(QStringLiteral("readMissing"));
    m_read->hide();
    connect(m_read, &QPushButton::clicked, this, &DialPanel::read);
}

void DialPanel::setEncoder(EncoderSession *encoder)
{
    if (m_encoder != nullptr)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    m_message->withdraw();
    m_pages->setCurrentIndex(encoder == nullptr ? 0 : 1);
    if (encoder == nullptr)
        return;
    m_disc->setPlace(encoder->number().toString());
    connect(encoder, &EncoderSession::latestChanged, this, &DialPanel::draw);
    connect(encoder, &EncoderSession::knownChanged, this, &DialPanel::knownChanged);
    connect(encoder, &EncoderSession::jobStarted, this, [this] { m_read->setEnabled(false); });
    connect(encoder, &EncoderSession::finished, this, [this](const Outcome &outcome) {
        m_read->setEnabled(true);
        if (outcome.result)
            m_message->withdraw();
    });
    connect(encoder, &EncoderSession::permissionChanged, m_message, &InlineMessage::withdraw);
    m_read->setEnabled(!encoder->runningJob());
    knownChanged();
}

void DialPanel::knownChanged()
{
    m_missing = missing();
    m_scale = scale();
    m_motion.reset();
    m_read->setVisible(!m_missing.empty() && m_encoder->can().reads);
    draw();
}

void DialPanel::read()
{
    if (m_encoder == nullptr)
        return;
    const auto started = m_encoder->start(ReadParameters{m_missing});
    if (!started)
        m_message->showMessage(Role::attention, refusalText(started.error()));
}

// Of what the disc needs, what this kind of encoder has and is not known.
std::vector<Parameter> DialPanel::missing() const
{
    std::vector<Parameter> missing;
    for (const Parameter parameter :
         {Parameter::steps, Parameter::revolutions, Parameter::direction, Parameter::coding})
        if (m_encoder->device().find(parameter) != nullptr && !m_encoder->known(parameter))
            missing.push_back(parameter);
    return missing;
}

std::optional<DialPanel::Scale> DialPanel::scale() const
{
    const auto steps = m_encoder->known(Parameter::steps);
    const auto revolutions = m_encoder->known(Parameter::revolutions);
    if (!m_missing.empty() || !steps || !revolutions)
        return std::nullopt;
    Scale scale{.stepsPerTurn = static_cast<double>(steps->value) / static_cast<double>(revolutions->value),
                .clockwise = countsClockwise(*m_encoder),
                .total = {}};
    if (const auto range = positionRange(*m_encoder))
        scale.total = range->last - range->first + 1;
    return scale;
}

void DialPanel::draw()
{
    if (m_encoder == nullptr)
        return;
    const Reading &reading = m_encoder->latest();
    DialState state;
    switch (reading.state) {
    case EncoderState::operation:
        state = running(reading);
        break;
    case EncoderState::parameterization:
        state = {.note = tr("In parameterization: there is no position."), .role = Role::attention};
        break;
    case EncoderState::readOut:
        state = {.note = tr("A read-out value stands in IN: there is no position."), .role = Role::attention};
        break;
    case EncoderState::service:
        state = {.note = tr("In service mode: there is no position."), .role = Role::attention};
        break;
    case EncoderState::error:
        state = {.note =
                     reading.errorNumber.value_or(0) == 0
                         ? tr("The encoder has no valid position.")
                         : tr("The encoder shows error %1: there is no position.").arg(*reading.errorNumber),
                 .role = Role::fault};
        break;
    case EncoderState::unknown:
        state = {.note = tr("IN %1 is in no manual: there is no position.").arg(hexWord(reading.in)),
                 .role = Role::attention};
        break;
    case EncoderState::notSeen:
        state = {.note = tr("Nothing came from the encoder yet.")};
        break;
    }
    if (!state.position)
        m_motion.reset();
    m_disc->setState(state);
}

DialState DialPanel::running(const Reading &reading)
{
    if (!reading.position)
        return {.note = rawNote(reading), .role = Role::attention};
    DialState state{.position = *reading.position,
                    .note = missingNote(),
                    .role = m_missing.empty() ? Role::running : Role::attention};
    if (!m_scale)
        return state;
    const double turns = static_cast<double>(*reading.position) / m_scale->stepsPerTurn;
    state.turnFraction = partOfTurn(turns, m_scale->clockwise);
    state.turn = static_cast<qint64>(std::floor(turns));
    m_motion.observe(reading.at, *reading.position, m_scale->total);
    if (const auto speed = m_motion.stepsPerSecond())
        state.rpm = *speed / m_scale->stepsPerTurn * 60 * (m_scale->clockwise ? 1 : -1);
    return state;
}

QString DialPanel::rawNote(const Reading &reading) const
{
    const QString raw = hexWord(k3::data(reading.in));
    if (m_encoder->device().quirks.hasModes && reading.mode != Mode::position) {
        if (!reading.mode)
            return tr("Raw word %1. The mode is not known: tell the start-up mode under Parameters.")
                .arg(raw);
        return *reading.mode == Mode::velocity
                   ? tr("Raw word %1, in velocity mode: there is no position.").arg(raw)
                   : tr("Raw word %1, in cam mode: there is no position.").arg(raw);
    }
    return tr("Raw word %1. The coding is not known: write it, or tell it under Parameters.").arg(raw);
}

QString DialPanel::missingNote() const
{
    if (m_missing.empty())
        return {};
    QStringList names;
    for (const Parameter parameter : m_missing)
        names.append(parameterName(parameter));
    return tr("Not known: %1. The disc needs it to turn.").arg(names.join(QStringLiteral(", ")));
}

} // namespace codewheel
