// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/traffic/send_frame_bar.h"

#include "can/candump_log.h"
#include "can/frame_meaning.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/monitor/meaning_line.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace codewheel {
namespace {

// Of the service that reads and writes objects, a request. Empty: it is something else.
std::optional<canopen::SdoFrame> sdoRequestIn(const CanFrame &frame)
{
    const auto cob = frame.isExtended || frame.isRemote ? std::nullopt : canopen::CobId::of(frame.id);
    return cob && cob->service == canopen::CobId::Service::sdoRequest
               ? canopen::SdoFrame::request(frame.data())
               : std::nullopt;
}

bool isRead(const CanFrame &frame)
{
    const auto sdo = sdoRequestIn(frame);
    return sdo &&
           (sdo->kind == canopen::SdoFrame::Kind::read || sdo->kind == canopen::SdoFrame::Kind::readSegment);
}

bool isStored(const CanFrame &frame)
{
    const auto sdo = sdoRequestIn(frame);
    return sdo && sdo->kind == canopen::SdoFrame::Kind::write &&
           (sdo->object.index == canopen::object::store.index ||
            sdo->object.index == canopen::object::restore.index);
}

} // namespace

SendFrameBar::SendFrameBar(QWidget *parent)
    : QWidget(parent)
    , m_field(new QLineEdit(this))
    , m_send(new QPushButton(lineIcon(Icon::start), tr("Send"), this))
    , m_meaning(new MeaningLine(this))
    , m_question(new InlineMessage(this))
    , m_message(new InlineMessage(this))
{
    auto *label = new QLabel(tr("Frame"), this);
    label->setBuddy(m_field);
    m_field->setFont(numberFont());
    m_field->setPlaceholderText(QStringLiteral("605#4004600000000000"));
    m_field->setClearButtonEnabled(true);
    named(m_field, "canFrameToSend")->setAccessibleName(tr("Frame to send"));
    named(m_send, "canSendFrame")->setAccessibleName(tr("Send the frame"));
    m_send->setAutoDefault(false);
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::groupGap);
    row->addWidget(label);
    row->addWidget(m_field, 1);
    row->addWidget(m_send);
    auto *rows = layOut<QVBoxLayout>(this, grid::unit);
    rows->addWidget(m_question);
    rows->addWidget(m_message);
    rows->addWidget(m_meaning);
    rows->addLayout(row);
    m_meaning->hide();
    connect(m_field, &QLineEdit::textChanged, this, [this] {
        m_question->withdraw();
        m_message->withdraw();
        showMeaning();
    });
    connect(m_field, &QLineEdit::returnPressed, this, &SendFrameBar::send);
    connect(m_send, &QPushButton::clicked, this, &SendFrameBar::send);
    connect(m_question, &InlineMessage::otherActionTriggered, m_question, &InlineMessage::withdraw);
    connect(m_question, &InlineMessage::actionTriggered, this, [this] {
        m_question->withdraw();
        if (const auto asked = std::exchange(m_asked, std::nullopt))
            sendNow(*asked);
    });
    showWhatIsPossible();
}

void SendFrameBar::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    m_bus = bus;
    m_question->withdraw();
    if (bus != nullptr) {
        connect(bus, &CanopenSession::stateChanged, this, &SendFrameBar::showWhatIsPossible);
        connect(bus, &CanopenSession::frameSent, this, &SendFrameBar::takeEnd);
        connect(bus, &QObject::destroyed, this, &SendFrameBar::showWhatIsPossible);
    }
    showWhatIsPossible();
}

void SendFrameBar::setRecordingChosen(bool isChosen)
{
    m_isRecordingChosen = isChosen;
    showWhatIsPossible();
}

std::optional<Refusal> SendFrameBar::whyNotSent() const
{
    if (m_isRecordingChosen)
        return Refusal{RefusalKind::notSupported, RefusalId::onlyRecorded, {}};
    if (!m_bus || m_bus->state() != BusState::open)
        return Refusal{RefusalKind::link, CanopenBusRefusalId::closed, {}};
    if (!m_bus->isOperating())
        return Refusal{RefusalKind::busy, RefusalId::watchOnly, {m_bus->linkName()}};
    return std::nullopt;
}

void SendFrameBar::showWhatIsPossible()
{
    const auto whyNot = whyNotSent();
    if (whyNot)
        m_question->withdraw();
    const QString why = whyNot ? refusalText(*whyNot) : QString();
    m_send->setEnabled(!whyNot);
    m_send->setToolTip(whyNot ? why : tr("Sends the frame once (Enter)"));
    m_field->setToolTip(
        whyNot ? why
               : tr("Identifier and data in hexadecimal digits, as in 605#4004600000000000; eight "
                    "digits for an identifier of 29 bits, R for a remote frame."));
}

std::optional<CanFrame> SendFrameBar::typed()
{
    const CanLogLine line = CandumpLog::frame(m_field->text().remove(u' ').toUpper().toStdString());
    if (line.frame && !line.frame->isError)
        return line.frame;
    const QString why = line.fault ? canLogFaultText(*line.fault) : tr("Error frames cannot be sent.");
    m_message->showMessage(Role::attention,
                           sentence(tr("Nothing was sent. %1 Write it as 605#4004600000000000."), {why}));
    return std::nullopt;
}

void SendFrameBar::showMeaning()
{
    const CanLogLine line = CandumpLog::frame(m_field->text().remove(u' ').toUpper().toStdString());
    m_meaning->setVisible(line.frame.has_value());
    if (line.frame)
        m_meaning->setText(CanFrameMeanings().next(*line.frame)());
}

void SendFrameBar::send()
{
    m_question->withdraw();
    m_message->withdraw();
    const auto frame = typed();
    if (!frame)
        return;
    if (const auto why = whyNotSent())
        m_message->showMessage(Role::attention, refusalText(*why));
    else if (isRead(*frame))
        sendNow(*frame);
    else
        ask(*frame);
}

void SendFrameBar::ask(const CanFrame &frame)
{
    m_asked = frame;
    const QString meaning = CanFrameMeanings().next(frame)();
    QString text = meaning.isEmpty() ? tr("What this frame does is not known to the program.")
                                     : sentence(tr("This is sent: %1."), {meaning});
    text += u' ' + tr("A drive may move.");
    if (isStored(frame))
        text += u' ' + tr("It costs an EEPROM write.");
    m_question->showMessage(Role::attention, text, tr("&Send it"), tr("Do &not send"));
}

void SendFrameBar::sendNow(const CanFrame &frame)
{
    m_bus->send(frame);
    Q_EMIT sent();
}

void SendFrameBar::takeEnd(const FrameSent &ended)
{
    if (ended.refused)
        m_message->showMessage(Role::attention, refusalText(*ended.refused));
    else if (ended.fate == CanFate::refused)
        m_message->showMessage(Role::attention, tr("The frame was not sent: the adapter refused it."));
    else if (ended.fate == CanFate::notKnown)
        m_message->showMessage(Role::attention,
                               tr("Whether the frame has gone out is not known: the adapter does not tell."));
}

} // namespace codewheel
