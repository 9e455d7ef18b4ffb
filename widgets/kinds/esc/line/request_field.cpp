// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/request_field.h"

#include "kinds/esc/protocol/esc_line_address.h"
#include "widgets/kinds/esc/line/command_list.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QCompleter>
#include <QHeaderView>
#include <QKeyEvent>
#include <QTreeView>

#include <algorithm>

namespace codewheel {
namespace {

constexpr qsizetype addressDigits = 2;
constexpr int listWidth = 130 * grid::unit;

} // namespace

RequestField::RequestField(QWidget *parent)
    : QLineEdit(parent)
    , m_commands(new CommandList(this))
{
    setFont(numberFont());
    setClearButtonEnabled(true);
    makeCompletion();
    connect(this, &QLineEdit::textEdited, this, &RequestField::followAddress);
}

void RequestField::makeCompletion()
{
    auto *completer = new QCompleter(m_commands, this);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    completer->setCompletionColumn(CommandList::request);
    auto *list = new QTreeView;
    list->setRootIsDecorated(false);
    list->setHeaderHidden(true);
    list->setAccessibleName(tr("Commands"));
    list->setMinimumWidth(listWidth);
    completer->setPopup(list); // takes ownership
    list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setCompleter(completer);
}

// Comes before the completer, which reacts to textEdited.
void RequestField::followAddress(const QString &text)
{
    const QString digits = text.left(addressDigits).toUpper();
    if (digits.size() == addressDigits && EscLineAddress::fromWire(digits))
        m_commands->setAddress(digits);
    m_place = m_history.size();
}

void RequestField::setFractionBits(int bits)
{
    m_commands->setFractionBits(bits);
}

void RequestField::setHistory(const QStringList &history)
{
    m_history = history.mid(std::max<qsizetype>(0, history.size() - mostKept));
    m_place = m_history.size();
}

void RequestField::keep()
{
    const QString sent = text().trimmed().toUpper();
    m_history.removeAll(sent);
    m_history << sent;
    setHistory(m_history);
    clear();
}

void RequestField::goThroughHistory(qsizetype by)
{
    const qsizetype wanted = std::clamp<qsizetype>(m_place + by, 0, m_history.size());
    if (wanted == m_place)
        return;
    if (m_place == m_history.size())
        m_typed = text();
    m_place = wanted;
    setText(m_place == m_history.size() ? m_typed : m_history.at(m_place));
}

QList<KeyHelp> RequestField::keys()
{
    return {{keyNames({Qt::Key_Return}), tr("Sends the request")},
            {keyNames({Qt::Key_Up, Qt::Key_Down}), tr("The request typed before, or after")},
            {keyNames({Qt::CTRL | Qt::Key_Space}), tr("Lists the commands")}};
}

// These move the cursor in a text; where there is none they are the terminal's.
bool RequestField::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && text().isEmpty()) {
        const auto *key = static_cast<const QKeyEvent *>(event);
        const bool isOfTerminal = key->key() == Qt::Key_E || key->key() == Qt::Key_End;
        if (isOfTerminal && key->modifiers() == Qt::ControlModifier) {
            event->ignore();
            return false;
        }
    }
    return QLineEdit::event(event);
}

void RequestField::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Up)
        goThroughHistory(-1);
    else if (event->key() == Qt::Key_Down)
        goThroughHistory(1);
    else if (event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier) {
        completer()->setCompletionPrefix(text().size() < addressDigits ? m_commands->address() : text());
        completer()->complete();
    } else
        QLineEdit::keyPressEvent(event);
}

} // namespace codewheel
