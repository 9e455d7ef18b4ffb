// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_sender.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"

#include <QCheckBox>
#include <QPushButton>

namespace codewheel {

WordSender::WordSender(WordChannel &channel, const QString &place, const WordForm &form, QWidget *parent)
    : QWidget(parent)
    , m_channel(&channel)
    , m_commandBits(form.commandBits)
    , m_write(new QPushButton(lineIcon(Icon::write), tr("Write"), this))
    , m_discard(new QPushButton(tr("Discard"), this))
    , m_atOnce(new QCheckBox(tr("At once"), parent))
{
    describe(m_write, tr("Write %1", "Write OUT 1.0").arg(place),
             tr("Send this word to the encoder; it stays there until another is sent (Ctrl+Return)"));
    describe(m_discard, tr("Discard %1", "Discard OUT 1.0").arg(place),
             tr("Back to the word on the bus (Esc)"));
    describe(m_atOnce, tr("Send %1 at once", "Send OUT 1.0 at once").arg(place),
             tr("Send each change as it is made. Words with a parameter number or a command bit still ask."));
    layOutRow(this, {m_write, m_discard}, {grid::unit, QMargins()});

    connect(m_write, &QPushButton::clicked, this, &WordSender::write);
    connect(m_discard, &QPushButton::clicked, this, &WordSender::discard);
    showStaged();
}

void WordSender::setBlocked(bool blocked)
{
    m_blocked = blocked;
    showWhetherSent();
}

void WordSender::showWhetherSent()
{
    const bool isRecorded = m_channel && m_channel->freshness().isOfRecording();
    m_write->setEnabled(!m_blocked && !isRecorded);
    m_atOnce->setEnabled(!isRecorded);
}

void WordSender::write()
{
    if (!m_channel || m_blocked)
        return;
    const Word word = m_channel->shownOut();
    if (m_mayBeSent && (!m_mayBeSent(word) || !m_channel || m_channel->shownOut() != word))
        return;
    if (const Result<void> written = m_channel->write(); !written)
        Q_EMIT refused(written.error());
    else
        Q_EMIT sent();
}

void WordSender::discard()
{
    if (!m_channel)
        return;
    m_channel->unstage();
    Q_EMIT discarded();
}

void WordSender::edited()
{
    if (!m_channel || !m_atOnce->isChecked() || !m_channel->staged())
        return;
    if ((*m_channel->staged() & m_commandBits) == 0)
        write();
    else
        Q_EMIT askedFor(*m_channel->staged());
}

// Write stays enabled: without a staged word it repeats the one on the bus.
void WordSender::showStaged()
{
    const bool staged = m_channel && m_channel->staged();
    if (!staged && m_discard->hasFocus())
        m_write->setFocus();
    m_discard->setEnabled(staged);
}

} // namespace codewheel
