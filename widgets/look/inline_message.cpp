// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/inline_message.h"

#include "widgets/look/bring_into_sight.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTextDocument>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int leastSentence = 100; // for the sentence with its icon

} // namespace

InlineMessage::InlineMessage(QWidget *parent)
    : QFrame(parent)
    , m_parts(new QBoxLayout(QBoxLayout::LeftToRight, this))
    , m_buttons(new QHBoxLayout)
    , m_icon(new QLabel(this))
    , m_sentence(new QLabel(this))
    , m_action(new QPushButton(this))
    , m_otherAction(new QPushButton(this))
    , m_copy(new QPushButton(lineIcon(Icon::copy), tr("Copy command"), this))
    , m_close(describe(new QToolButton(this), tr("Close this message"), tr("Close this message")))
{
    m_sentence->setWordWrap(true);
    m_sentence->setTextFormat(Qt::PlainText); // it may contain names
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setAutoRaise(true);
    m_close->setIcon(lineIcon(Icon::cancel));

    m_parts->setContentsMargins(grid::margin + grid::unit, grid::unit, grid::unit, grid::unit);
    m_parts->setSpacing(grid::margin);
    auto *said = new QHBoxLayout;
    said->addWidget(m_icon);
    said->addWidget(m_sentence, 1);
    m_buttons->addStretch();
    m_buttons->addWidget(m_action);
    m_buttons->addWidget(m_otherAction);
    m_buttons->addWidget(m_copy);
    m_buttons->addWidget(m_close);
    m_parts->addLayout(said, 1);
    m_parts->addLayout(m_buttons);

    connect(m_action, &QPushButton::clicked, this, &InlineMessage::actionTriggered);
    connect(m_otherAction, &QPushButton::clicked, this, &InlineMessage::otherActionTriggered);
    connect(m_copy, &QPushButton::clicked, this, &InlineMessage::copyCommand);
    connect(m_close, &QToolButton::clicked, this, [this] {
        withdraw();
        Q_EMIT closed();
    });
    for (QAbstractButton *button :
         std::initializer_list<QAbstractButton *>{m_action, m_otherAction, m_copy, m_close})
        takeNoClickYet(button);
    m_action->hide();
    m_otherAction->hide();
    m_copy->hide();
    hide();
    onEvent(this, {QEvent::PaletteChange, QEvent::StyleChange}, [this] {
        drawIcon();
        showText();
    });
    onEvent(this, {QEvent::Resize}, [this] { arrange(); });
}

void InlineMessage::showMessage(Role role, const QString &sentence, const QString &actionText,
                                const QString &otherActionText)
{
    if (sentence.isEmpty()) {
        withdraw();
        return;
    }
    m_press.begin();
    m_role = role;
    setCommand({});
    rephrase(sentence);
    m_action->setText(actionText);
    const QString tip = Qt::convertFromPlainText(sentence); // a plain one would be as wide as the sentence
    m_action->setToolTip(tip);
    m_action->setAccessibleDescription(sentence);
    m_action->setVisible(!actionText.isEmpty());
    m_otherAction->setText(otherActionText);
    m_otherAction->setToolTip(tip);
    m_otherAction->setAccessibleDescription(sentence);
    m_otherAction->setVisible(!otherActionText.isEmpty());
    drawIcon();
    arrange();
    show();
    update();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void InlineMessage::showTrouble(Role role, const Trouble &trouble, const QString &actionText)
{
    showMessage(role, trouble.sentence, actionText);
    if (trouble.command.isEmpty())
        return;
    setCommand(trouble.command);
    showText();
    arrange();
}

void InlineMessage::setCommand(const QString &command)
{
    m_command = command;
    m_copy->setText(tr("Copy command"));
    m_copy->setToolTip(tr("Copies it, for pasting it into a terminal: %1").arg(command));
    m_copy->setVisible(!command.isEmpty());
    setAccessibleDescription(command);
}

void InlineMessage::copyCommand()
{
    QApplication::clipboard()->setText(m_command);
    m_copy->setText(tr("Copied"));
}

void InlineMessage::rephrase(const QString &sentence)
{
    m_text = sentence;
    setAccessibleName(tr("%1: %2", "role: sentence").arg(roleWord(m_role), sentence));
    showText();
}

void InlineMessage::setDetail(const QString &detail)
{
    m_detail = detail;
    showText();
}

// All may contain names, which must not be taken for markup.
void InlineMessage::showText()
{
    QString behind;
    if (!m_detail.isEmpty())
        behind = QStringLiteral(" <span style=\"font-size:small; color:%2\">%1</span>")
                     .arg(m_detail.toHtmlEscaped(), palette().color(QPalette::PlaceholderText).name());
    if (!m_command.isEmpty())
        behind += QStringLiteral("<br><code>%1</code>").arg(m_command.toHtmlEscaped());
    m_sentence->setTextFormat(behind.isEmpty() ? Qt::PlainText : Qt::RichText);
    m_sentence->setText(behind.isEmpty() ? m_text : m_text.toHtmlEscaped() + behind);
    m_sentence->setToolTip(
        m_text.isEmpty() ? QString() : Qt::convertFromPlainText(m_text)); // where it has not enough room
}

void InlineMessage::focusSafe()
{
    QAbstractButton *safe =
        m_otherAction->isHidden() ? static_cast<QAbstractButton *>(m_close) : m_otherAction;
    safe->setFocus(Qt::OtherFocusReason);
    QTimer::singleShot(0, this, [this] { bringIntoSight(*this); }); // once it has its place
}

void InlineMessage::withdraw()
{
    if (m_text.isEmpty())
        return; // called 30 times a second with nothing to withdraw
    giveFocusBack();
    hide();
    m_text.clear();
    m_detail.clear();
    setCommand({});
    showText();
    setAccessibleName({});
}

// Otherwise it would go to the next part of the window.
void InlineMessage::giveFocusBack()
{
    if (!isAncestorOf(QApplication::focusWidget()))
        return;
    for (QWidget *its = previousInFocusChain(); its != this; its = its->previousInFocusChain())
        if (parentWidget()->isAncestorOf(its) && !isAncestorOf(its) && its->isVisible() && its->isEnabled() &&
            (its->focusPolicy() & Qt::TabFocus) != 0) {
            its->setFocus(Qt::OtherFocusReason);
            return;
        }
}

QString InlineMessage::sentence() const
{
    return m_text;
}

void InlineMessage::addButton(QAbstractButton *button)
{
    m_buttons->insertWidget(m_buttons->indexOf(m_close), button);
    takeNoClickYet(button);
}

void InlineMessage::takeNoClickYet(QAbstractButton *button)
{
    button->installEventFilter(this);
}

bool InlineMessage::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::Show:
    case QEvent::Move:
        m_press.begin();
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return m_press.isSecond();
    default:
        return QFrame::eventFilter(watched, event);
    }
}

// Something above it has come or gone.
void InlineMessage::moveEvent(QMoveEvent *event)
{
    QFrame::moveEvent(event);
    m_press.begin();
}

bool InlineMessage::hasActions() const
{
    for (int i = 0; i < m_buttons->count(); ++i)
        if (const QWidget *button = m_buttons->itemAt(i)->widget();
            button != nullptr && button != m_close && !button->isHidden())
            return true;
    return false;
}

// As wide as with the buttons below the sentence.
QSize InlineMessage::minimumSizeHint() const
{
    const QSize least = QFrame::minimumSizeHint();
    const QMargins margins = m_parts->contentsMargins();
    const int widest = std::max(m_buttons->minimumSize().width(), leastSentence);
    return {std::min(least.width(), margins.left() + widest + margins.right()), least.height()};
}

// Buttons go beside the sentence, unless below it they take less height.
void InlineMessage::arrange()
{
    m_buttons->invalidate(); // it may not have been told yet which of them are shown
    const int buttons = m_buttons->sizeHint().width();
    const int around = m_icon->sizeHint().width() + 5 * grid::margin;
    const auto heightBeside = [&](int taken) {
        return m_sentence->heightForWidth(std::max(width() - taken - around, leastSentence));
    };
    const bool isLower =
        heightBeside(buttons) > heightBeside(0) + m_buttons->sizeHint().height() + grid::margin;
    const bool isNarrow = hasActions() && (isLower || width() < buttons + 2 * leastSentence);
    m_parts->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void InlineMessage::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.fillRect(QRect(0, 0, grid::unit, height()), roleColor(m_role, palette()));
}

void InlineMessage::drawIcon()
{
    const QSize size(grid::smallIcon, grid::smallIcon);
    m_icon->setPixmap(lineIcon(roleIcon(m_role), m_role).pixmap(size, devicePixelRatioF()));
}

} // namespace codewheel
