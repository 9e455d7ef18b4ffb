// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_view_accessible.h"

#include "widgets/monitor/word_view.h"

namespace codewheel {

namespace {

QAccessibleInterface *makeWordInterface(const QString &className, QObject *object)
{
    auto *view =
        className == QLatin1String("codewheel::WordView") ? qobject_cast<WordView *>(object) : nullptr;
    return view != nullptr ? new WordViewAccessible(*view) : nullptr;
}

int indexOfBit(const WordView &view, WordBit bit)
{
    return bit.word * view.bits() + view.bits() - 1 - bit.bit;
}

WordBit bitOfIndex(const WordView &view, int index)
{
    return {index / view.bits(), view.bits() - 1 - index % view.bits()};
}

} // namespace

void installWordViewAccessibility()
{
    QAccessible::installFactory(makeWordInterface); // ignored if it is there already
}

void announceBitFocus(WordView &view, WordBit bit)
{
    QAccessibleEvent event(&view, QAccessible::Focus);
    event.setChild(indexOfBit(view, bit));
    QAccessible::updateAccessibility(&event);
}

void announceBitState(WordView &view, WordBit bit)
{
    QAccessible::State changed;
    changed.checked = true;
    QAccessibleStateChangeEvent event(&view, changed);
    event.setChild(indexOfBit(view, bit));
    QAccessible::updateAccessibility(&event);
}

WordViewAccessible::WordViewAccessible(WordView &view)
    : QAccessibleWidget(&view, QAccessible::Grouping)
{}

WordViewAccessible::~WordViewAccessible()
{
    for (const auto &[index, id] : m_bits)
        QAccessible::deleteAccessibleInterface(id);
}

WordView &WordViewAccessible::view() const
{
    return *static_cast<WordView *>(object());
}

int WordViewAccessible::childCount() const
{
    return isValid() ? view().words() * view().bits() : 0;
}

QAccessibleInterface *WordViewAccessible::child(int index) const
{
    if (index < 0 || index >= childCount())
        return nullptr;
    const auto [made, isNew] = m_bits.try_emplace(index);
    if (isNew)
        made->second =
            QAccessible::registerAccessibleInterface(new BitAccessible(view(), bitOfIndex(view(), index)));
    return QAccessible::accessibleInterface(made->second);
}

QAccessibleInterface *WordViewAccessible::childAt(int x, int y) const
{
    if (!isValid())
        return nullptr;
    const auto bit = view().bitAt(view().mapFromGlobal(QPoint(x, y)));
    return bit ? child(indexOfBit(view(), *bit)) : nullptr;
}

int WordViewAccessible::indexOfChild(const QAccessibleInterface *child) const
{
    const auto *bit = dynamic_cast<const BitAccessible *>(child);
    return bit != nullptr && bit->parent() == this ? indexOfBit(view(), bit->bit()) : -1;
}

QAccessibleInterface *WordViewAccessible::focusChild() const
{
    return isValid() && view().hasFocus() ? child(indexOfBit(view(), view().focusedBit())) : nullptr;
}

BitAccessible::BitAccessible(WordView &view, WordBit bit)
    : m_view(&view)
    , m_bit(bit)
{}

bool BitAccessible::isValid() const
{
    return !m_view.isNull();
}

QWindow *BitAccessible::window() const
{
    return m_view ? m_view->window()->windowHandle() : nullptr;
}

QAccessibleInterface *BitAccessible::parent() const
{
    return QAccessible::queryAccessibleInterface(m_view);
}

QString BitAccessible::text(QAccessible::Text text) const
{
    if (!m_view)
        return {};
    switch (text) {
    case QAccessible::Name:
        return m_view->bitName(m_bit);
    case QAccessible::Description:
        return m_view->bitDescription(m_bit);
    default:
        return {};
    }
}

QRect BitAccessible::rect() const
{
    if (!m_view)
        return {};
    const QRect cell = m_view->bitRect(m_bit);
    return {m_view->mapToGlobal(cell.topLeft()), cell.size()};
}

QAccessible::State BitAccessible::state() const
{
    QAccessible::State state;
    if (!m_view) {
        state.invalid = true;
        return state;
    }
    state.checkable = true;
    state.checked = m_view->isSet(m_bit);
    state.readOnly = !m_view->isEditable(m_bit.word);
    state.disabled = !m_view->isEnabled();
    state.invisible = !m_view->isVisible();
    state.focusable = true;
    state.focused = m_view->hasFocus() && m_view->focusedBit() == m_bit;
    return state;
}

void *BitAccessible::interface_cast(QAccessible::InterfaceType type)
{
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface *>(this) : nullptr;
}

QStringList BitAccessible::actionNames() const
{
    if (m_view && m_view->isEditable(m_bit.word) && m_view->isEnabled())
        return {toggleAction(), setFocusAction()};
    return {setFocusAction()};
}

void BitAccessible::doAction(const QString &name)
{
    if (!m_view || !m_view->isEnabled())
        return;
    if (name == toggleAction()) {
        m_view->toggleBit(m_bit);
    } else if (name == setFocusAction()) {
        m_view->setFocusedBit(m_bit);
        m_view->setFocus(Qt::OtherFocusReason);
    }
}

QStringList BitAccessible::keyBindingsForAction(const QString &) const
{
    return {};
}

} // namespace codewheel
