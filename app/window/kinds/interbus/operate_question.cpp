// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/operate_question.h"

#include "bus/bus_outline.h"
#include "bus/encoder_bus.h"
#include "bus/word_channel.h"
#include "widgets/help/help_topic.h"

#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace codewheel {
namespace {

constexpr qsizetype mostNamed = 8; // the question has to fit a small screen

QString listed(QStringList lines)
{
    const int others = static_cast<int>(lines.size() - mostNamed);
    if (others > 0) {
        lines.resize(mostNamed);
        lines += OperateQuestion::tr("and %n more", nullptr, others);
    }
    return lines.join(u'\n');
}

} // namespace

OperateQuestion::OperateQuestion(EncoderBus &ring, Called called, QWidget &window, QObject *parent)
    : QObject(parent)
    , m_ring(ring)
    , m_called(std::move(called))
    , m_window(window)
{
    connect(&ring, &EncoderBus::stateChanged, this, &OperateQuestion::followRing);
    connect(&ring, &EncoderBus::structureChanged, this, [this] {
        m_isAnswered = false;
        if (m_box)
            m_box->reject();
    });
}

// A lost link that comes back is the same connection.
void OperateQuestion::followRing()
{
    m_isAnswered = m_ring.isOpen() && (m_isAnswered || m_ring.isOperating());
    if (m_box && (m_ring.state() != BusState::open || m_ring.isOperating()))
        m_box->reject();
}

void OperateQuestion::ask(std::function<void()> then)
{
    if (m_isAnswered || !m_ring.isOpen() || m_ring.isSimulated()) {
        then();
        return;
    }
    m_then = std::move(then);
    if (m_box)
        m_box->activateWindow();
    else
        open();
}

// Not by exec(): the ring may be left, or the window rebuilt, while it is open.
void OperateQuestion::open()
{
    const QString name = nameAmongOthers(m_ring.id());
    m_box =
        new QMessageBox(QMessageBox::Question, tr("Operate"),
                        name.isEmpty() ? tr("This ring is real. Shall the program write to it?")
                                       : tr("%1 is a real ring. Shall the program write to it?").arg(name),
                        QMessageBox::NoButton, &m_window);
    m_box->setObjectName(QStringLiteral("operateQuestion"));
    m_box->setAttribute(Qt::WA_DeleteOnClose);
    setHelpTopic(*m_box, "gateway.md#watch-and-operate");
    m_box->setInformativeText(explanation());
    QPushButton *operate = m_box->addButton(tr("&Operate"), QMessageBox::AcceptRole);
    operate->setToolTip(tr("Words can be sent from now on; none is changed by that. This is not asked again "
                           "before the ring is connected anew"));
    QPushButton *stay = m_box->addButton(tr("&Stay in Watch"), QMessageBox::RejectRole);
    stay->setToolTip(tr("Nothing is sent (Esc)"));
    m_box->setDefaultButton(stay);
    m_box->setEscapeButton(stay);
    connect(operate, &QPushButton::clicked, this, [this] {
        m_isAnswered = true;
        std::exchange(m_then, nullptr)();
    });
    m_box->open();
}

QString OperateQuestion::explanation() const
{
    QStringList paragraphs{
        tr("In Operate, the OUT words that you send go to the devices of the ring. A preset or a parameter "
           "changes the position that the controller sees. Switching over changes no OUT word.")};
    if (const QStringList devices = movable(); devices.isEmpty())
        paragraphs += tr("All devices with OUT words are encoders.");
    else
        paragraphs += tr("These devices have OUT words and are not known as encoders. What they drive can "
                         "move:") +
                      u'\n' + listed(devices);
    if (const QStringList devices = outNotKnown(); !devices.isEmpty())
        paragraphs +=
            tr("OUT cannot be read back of these. It stays as it is until something is sent there:") + u'\n' +
            listed(devices);
    return paragraphs.join(QStringLiteral("\n\n"));
}

QStringList OperateQuestion::movable() const
{
    QStringList devices;
    for (const BusNode &node : m_ring.outline().nodes()) {
        const WordChannel *channel = m_ring.channel(node.node);
        if (channel != nullptr && channel->outWords() > 0 && m_ring.encoder(node.node) == nullptr)
            devices += m_called(channel->place(), node.name);
    }
    return devices;
}

QStringList OperateQuestion::outNotKnown() const
{
    QStringList devices;
    for (const BusNode &node : m_ring.outline().nodes()) {
        const WordChannel *channel = m_ring.channel(node.node);
        if (channel != nullptr && channel->outWords() > 0 && !channel->outIsKnown())
            devices += m_called(channel->place(), node.name);
    }
    return devices;
}

} // namespace codewheel
