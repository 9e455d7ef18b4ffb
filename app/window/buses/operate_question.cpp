// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/operate_question.h"

#include "app/window/buses/bus_at_work.h"
#include "bus/encoder_bus.h"
#include "widgets/help/help_topic.h"

#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace codewheel {

OperateQuestion::OperateQuestion(BusAtWork &atWork, Warning warning, QWidget &window, QObject *parent)
    : QObject(parent)
    , m_atWork(atWork)
    , m_warning(std::move(warning))
    , m_window(window)
{
    connect(&atWork, &BusAtWork::aboutToChange, this, &OperateQuestion::beginAnew);
    connect(&atWork, &BusAtWork::changed, this, &OperateQuestion::followSession);
    followSession();
}

void OperateQuestion::followSession()
{
    const EncoderBus *bus = m_atWork.bus();
    if (bus == nullptr)
        return;
    connect(bus, &EncoderBus::stateChanged, this, &OperateQuestion::followBus, Qt::UniqueConnection);
    connect(bus, &EncoderBus::structureChanged, this, &OperateQuestion::beginAnew, Qt::UniqueConnection);
    followBus(); // it may have been in Operate from the beginning
}

// A lost link that comes back is the same connection.
void OperateQuestion::followBus()
{
    const EncoderBus *bus = m_atWork.bus();
    const bool isOperating = bus != nullptr && bus->isOperating();
    m_isAnswered = m_atWork.isOpen() && (m_isAnswered || isOperating);
    if (bus == nullptr || bus->state() != BusState::open || isOperating)
        withdraw();
}

void OperateQuestion::beginAnew()
{
    m_isAnswered = false;
    withdraw();
}

void OperateQuestion::withdraw()
{
    if (m_box)
        m_box->reject();
}

void OperateQuestion::ask(std::function<void()> then)
{
    if (m_isAnswered || !m_atWork.isOpen() || m_atWork.bus()->isSimulated()) {
        then();
        return;
    }
    m_then = std::move(then);
    if (m_box)
        m_box->activateWindow();
    else
        open(*m_atWork.bus());
}

// Not by exec(): the bus may be left, or the window rebuilt, while it is open.
void OperateQuestion::open(const EncoderBus &bus)
{
    const OperateWarning warning = m_warning(bus);
    m_box = new QMessageBox(QMessageBox::Question, tr("Operate"), warning.question, QMessageBox::NoButton,
                            &m_window);
    m_box->setObjectName(QStringLiteral("operateQuestion"));
    m_box->setAttribute(Qt::WA_DeleteOnClose);
    setHelpTopic(*m_box, warning.helpTopic);
    m_box->setInformativeText(warning.explanation);
    QPushButton *operate = m_box->addButton(tr("&Operate"), QMessageBox::AcceptRole);
    operate->setToolTip(tr("It can be written to from now on; nothing is changed by that. This is not asked "
                           "again before it is connected anew"));
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

} // namespace codewheel
