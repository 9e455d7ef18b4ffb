// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_line.h"

#include "catalog/explain_word.h"
#include "vocabulary/freshness_text.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/models/age_text.h"
#include "widgets/monitor/meaning_line.h"
#include "widgets/monitor/number_fields.h"
#include "widgets/monitor/word_format.h"
#include "widgets/monitor/word_sender.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

namespace codewheel {

QString caption(WordDirection direction)
{
    return direction == WordDirection::out ? QStringLiteral("OUT") : QStringLiteral("IN");
}

QString wordName(WordDirection direction, Place place)
{
    return caption(direction) + QLatin1Char(' ') + place.shown();
}

WordLine::WordLine(WordDirection direction, const Device &device, const WordForm &form, QWidget *parent)
    : QWidget(parent)
    , m_direction(direction)
    , m_channel(device.channel)
    , m_encoder(device.encoder)
    , m_description(device.description)
    , m_form(form)
    , m_name(wordName(direction, device.channel->place()))
    , m_rows(new QGridLayout(this))
    , m_caption(new QLabel(caption(direction), this))
    , m_numbers(new NumberFields(m_name, form, isOut(), this))
    , m_meaning(new MeaningLine(this))
{
    m_caption->setFont(textFont(TextSize::small));
    if (isOut())
        m_sender = new WordSender(*m_channel, m_name, form, this);
    arrange();
}

// The meaning of OUT has a line of its own, since Write is beside the numbers.
void WordLine::arrange()
{
    m_rows->setContentsMargins({});
    m_rows->setHorizontalSpacing(grid::unit);
    m_rows->setVerticalSpacing(0);
    m_rows->setColumnStretch(2, 1);
    m_rows->addWidget(m_caption, 0, 0);
    m_rows->addWidget(m_numbers, 0, 1);
    if (m_sender != nullptr) {
        m_rows->addWidget(m_sender, 0, 2, Qt::AlignRight);
        m_rows->addLayout(layOutRow({{m_meaning, 1}, m_sender->atOnce()}), 1, 1, 1, 2);
    } else {
        m_rows->addWidget(m_meaning, 0, 2);
    }
    m_rows->addWidget(m_numbers->more(), 2, 1, 1, 2);
}

void WordLine::setCaptionWidth(int width)
{
    m_caption->setFixedWidth(width - m_rows->horizontalSpacing());
}

Word WordLine::shown() const
{
    return m_channel == nullptr ? 0 : isOut() ? m_channel->shownOut() : m_channel->in();
}

Word WordLine::onBus() const
{
    return m_channel == nullptr ? 0 : isOut() ? m_channel->out() : m_channel->in();
}

Word WordLine::edges() const
{
    return m_channel == nullptr ? 0 : isOut() ? m_channel->outEdges() : m_channel->inEdges();
}

// OUT is not old while the bus is reached: it goes out when it runs again.
bool WordLine::isOld() const
{
    if (m_channel == nullptr)
        return true;
    const Freshness &freshness = m_channel->freshness();
    if (freshness.isOfRecording())
        return true;
    const bool isReached = freshness.reason() != Freshness::Reason::disconnected &&
                           freshness.reason() != Freshness::Reason::linkLost;
    return freshness.isOld() && !(isOut() && isReached);
}

bool WordLine::isKnown() const
{
    if (m_channel == nullptr)
        return true;
    const bool isThere = isOut() ? m_channel->outIsKnown() || m_channel->staged() : m_channel->inIsKnown();
    return isThere && m_channel->freshness().reason() != Freshness::Reason::notRecorded;
}

QString WordLine::bitText(int bit) const
{
    return m_channel != nullptr && m_description != nullptr
               ? codewheel::bitText(*m_description, m_direction, bit)
               : QString();
}

QString WordLine::meaning() const
{
    return m_meaning->text();
}

QString WordLine::copiedText(WordNotation notation) const
{
    return codewheel::copiedText(shown(), m_form.bits, notation);
}

void WordLine::setDisplay(const MonitorDisplay &display)
{
    m_numbers->setDisplay(display);
}

void WordLine::showWord()
{
    if (m_channel == nullptr)
        return;
    m_numbers->setWord(shown());
    m_numbers->setOld(isOld());
    m_numbers->setKnown(isKnown());
    if (m_sender != nullptr)
        m_sender->showWhetherSent();
    m_meaning->setText(explain());
}

// An encoder without supply shows what one at position 0 does.
bool WordLine::mayLackSupply() const
{
    return !isOut() && m_encoder != nullptr && m_encoder->latest().position == 0 &&
           m_encoder->latest().state == EncoderState::operation && !m_encoder->showsPosition();
}

QString WordLine::explain() const
{
    if (!isKnown() && m_channel->freshness().isOfRecording())
        return freshnessText(Freshness::Reason::notRecorded);
    if (!isKnown())
        return isOut() ? tr("Not known what is there.") : freshnessText(Freshness::Reason::unsettled);
    if (m_description == nullptr)
        return tr("Not explained: there is no description of this device.");
    WordContext context;
    context.direction = m_direction;
    context.counterpart = isOut() ? m_channel->in() : m_channel->out();
    if (m_encoder != nullptr) {
        context.mode = m_encoder->latest().mode;
        context.coding = m_encoder->latest().coding;
    }
    QString text = explanationText(*m_description, explainWord(*m_description, shown(), context));
    if (isOut() && !m_channel->freshness().isOfRecording())
        return m_channel->staged() ? tr("Not sent yet: %1", "meaning of a word").arg(text) : text;
    if (mayLackSupply())
        text = tr("%1, or no supply", "meaning of a word").arg(text);
    if (!isOld())
        return text;
    return QStringLiteral("%1, %2: %3") // "Bus stopped, 20 s ago: ..."
        .arg(freshnessBrief(m_channel->freshness().reason()), ageText(*m_channel), text);
}

} // namespace codewheel
