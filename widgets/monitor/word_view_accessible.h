// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessibleWidget>
#include <QPointer>

#include <array>

namespace codewheel {

class WordView;

// Makes Qt ask us for the accessible side of WordView; may be called any number of times.
void installWordViewAccessibility();

void announceBitFocus(WordView &view, int bit);
void announceBitState(WordView &view, int bit);

// A WordView as assistive technology sees it: a group of check boxes, the highest bit first.
class WordViewAccessible final : public QAccessibleWidget
{
public:
    explicit WordViewAccessible(WordView &view);
    ~WordViewAccessible() override;
    WordViewAccessible(const WordViewAccessible &) = delete;
    WordViewAccessible &operator=(const WordViewAccessible &) = delete;

    int childCount() const override;
    QAccessibleInterface *child(int index) const override;
    QAccessibleInterface *childAt(int x, int y) const override;
    int indexOfChild(const QAccessibleInterface *child) const override;
    QAccessibleInterface *focusChild() const override;

private:
    WordView &view() const;

    mutable std::array<QAccessible::Id, 32> m_bits{}; // by bit, made when first asked for; 0: not yet
};

// One bit: a check box; with a toggle action where the word is editable.
class BitAccessible final : public QAccessibleInterface, public QAccessibleActionInterface
{
public:
    BitAccessible(WordView &view, int bit);

    int bit() const { return m_bit; }

    bool isValid() const override;
    QObject *object() const override { return nullptr; } // the view's object is the group
    QWindow *window() const override;
    QAccessibleInterface *parent() const override;
    QAccessibleInterface *child(int) const override { return nullptr; }
    QAccessibleInterface *childAt(int, int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface *) const override { return -1; }
    QString text(QAccessible::Text text) const override;
    void setText(QAccessible::Text, const QString &) override {}
    QRect rect() const override;
    QAccessible::Role role() const override { return QAccessible::CheckBox; }
    QAccessible::State state() const override;
    void *interface_cast(QAccessible::InterfaceType type) override;

    QStringList actionNames() const override;
    void doAction(const QString &name) override;
    QStringList keyBindingsForAction(const QString &name) const override;

private:
    QPointer<WordView> m_view;
    int m_bit;
};

} // namespace codewheel
